import type { HandedOn, Job, OfWork } from "../../program/job/job.ts";
import type { NcOutput } from "../../program/machine/nc-output.ts";
import type { WorkKind } from "../place/place.ts";
import { fileKey } from "../../program/state/program-files.ts";

/** Encoding of a program file. Controls also write files that are not UTF-8. */
export type Encoding = "utf-8" | "windows-1252";

/** One text file of a work. */
export interface WorkFile {
  /** Name of the file, with ending. */
  readonly name: string;
  /** Exactly as read, with its line ends. */
  readonly text: string;
  readonly encoding: Encoding;
}

/** A whole program as work: its state is its text and the members below. Everything else is derived. */
export interface ProgramWork extends WorkFile, OfWork {
  /** Its other files: called programs, contours, tables. All have different keys. */
  readonly files?: readonly WorkFile[];
  /** Blocks with a skip mark are skipped. */
  readonly skipMarked?: boolean;
  /**
   * NC output for blocks that the app adds; by default as the program already writes them, else as set on the device.
   */
  readonly output?: NcOutput;
}

/** Only the own tools, control and machine of a work. */
export const onlyBundle = ({ tools, control, machine }: HandedOn): HandedOn => ({
  ...(tools && { tools }),
  ...(control && { control }),
  ...(machine !== undefined && { machine }),
});

/** Longest machine file that is accepted, characters. */
export const LONGEST_MACHINE = 10_000;

/** Longest remarks of a setup sheet, characters: they fill a page. */
export const LONGEST_REMARKS = 4000;

/** Most measurements of a work: a picture with more is unreadable. */
export const MOST_MEASURED = 100;

/** What an operator works on: one cycle by its prompts, or a whole program. */
export type Work = Job | ProgramWork;

export const isProgram = (work: Work): work is ProgramWork => "text" in work;
export const kindOf = (work: Work): WorkKind => (isProgram(work) ? "program" : "cycle");

const NO_FILES: readonly WorkFile[] = [];

/** The other files of a program; the same list while nothing changes in them. */
export const filesOf = ({ files = NO_FILES }: ProgramWork): readonly WorkFile[] => files;

/** All files of a work, the main program first. */
export const textsOf = (program: ProgramWork): readonly WorkFile[] => [program, ...filesOf(program)];

/** The file with a key in a work; undefined if there is none. */
export const fileOf = (program: ProgramWork, key: string): WorkFile | undefined =>
  textsOf(program).find(({ name }) => fileKey(name) === key);

const isNamed =
  (key: string) =>
  ({ name }: WorkFile) =>
    fileKey(name) === key;
const plain = ({ name, text, encoding }: WorkFile): WorkFile => ({ name, text, encoding });
const withFiles = ({ files: _, ...program }: ProgramWork, files: readonly WorkFile[]): ProgramWork =>
  files.length > 0 ? { ...program, files } : program;

/** The work with another text in one of its files. */
export function withText(program: ProgramWork, key: string, text: string): ProgramWork {
  if (isNamed(key)(program)) return { ...program, text };
  return withFiles(
    program,
    filesOf(program).map((file) => (isNamed(key)(file) ? { ...file, text } : file)),
  );
}

/** The work with a file added; it replaces one of the same key. */
export function withFile(program: ProgramWork, file: WorkFile): ProgramWork {
  const key = fileKey(file.name);
  if (isNamed(key)(program)) return { ...program, ...plain(file) };
  const files = filesOf(program);
  return withFiles(
    program,
    files.some(isNamed(key)) ? files.map((f) => (isNamed(key)(f) ? file : f)) : [...files, file],
  );
}

/** The work without one of its other files. */
export const withoutFile = (program: ProgramWork, key: string): ProgramWork =>
  withFiles(
    program,
    filesOf(program).filter((file) => !isNamed(key)(file)),
  );

/** The work with another file as the main program; the former one takes its place. */
export function withMain(program: ProgramWork, key: string): ProgramWork {
  const main = filesOf(program).find(isNamed(key));
  if (!main) return program;
  return {
    ...withFiles(
      program,
      filesOf(program).map((file) => (file === main ? plain(program) : file)),
    ),
    ...plain(main),
  };
}
