import type { Measurement } from "../../kernel/plan/measured.ts";
import type { HandedOn, Job, TaskWork } from "../../program/job/job.ts";
import type { NcOutput } from "../../program/machine/nc-output.ts";
import { fileKey } from "../../program/state/program-files.ts";

/** How the bytes of a program file stand for characters. Controls also write files that are not UTF-8. */
export type Encoding = "utf-8" | "windows-1252";

/** One text file of a work. */
export interface WorkFile {
  /** Name of the file, with ending. */
  readonly name: string;
  /** Exactly as read, with its line ends. */
  readonly text: string;
  readonly encoding: Encoding;
}

/** A whole program as work: its state is its text, and what belongs to it. Everything else is made from it. */
export interface ProgramWork extends WorkFile, HandedOn {
  /** What was opened with it: programs that it calls, contours, tables. No two of a work have the same key. */
  readonly files?: readonly WorkFile[];
  /** Blocks behind a skip mark are left out. */
  readonly skipMarked?: boolean;
  /**
   * How blocks are written that the app adds; as the program writes them already, and as this device does where it is
   * not set.
   */
  readonly output?: NcOutput;
  /** What its setup sheet says to the setter. */
  readonly remarks?: string;
  /** What it is turned from, by its id in the cutting data; that of the device where it names none. */
  readonly material?: string;
  /** What was measured in its picture and stays there, in the order in which it was measured. */
  readonly measured?: readonly Measurement[];
  readonly task?: TaskWork;
}

/** What a work brings along, and nothing else of it. */
export const broughtBy = ({ tools, control, machine }: HandedOn): HandedOn => ({
  ...(tools && { tools }),
  ...(control && { control }),
  ...(machine !== undefined && { machine }),
});

/** Longest machine file that is read and kept, characters. */
export const LONGEST_MACHINE = 10_000;

/** Longest remarks of a setup sheet, characters: they fill a page. */
export const LONGEST_REMARKS = 4000;

/** Most measurements that a work keeps: a picture of more says nothing. */
export const MOST_MEASURED = 100;

/** What an operator works on: one cycle by its prompts, or a whole program. */
export type Work = Job | ProgramWork;

export const isProgram = (work: Work): work is ProgramWork => "text" in work;

const NO_FILES: readonly WorkFile[] = [];

/** The files beside a program; the same list as long as nothing changes in them. */
export const filesOf = ({ files = NO_FILES }: ProgramWork): readonly WorkFile[] => files;

/** The program and the files beside it, the program first. */
export const textsOf = (program: ProgramWork): readonly WorkFile[] => [program, ...filesOf(program)];

/** The file of a key among those of a work; undefined when it is not one of them. */
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

/** The work with one more file; one of the same key gives way to it. */
export function withFile(program: ProgramWork, file: WorkFile): ProgramWork {
  const key = fileKey(file.name);
  if (isNamed(key)(program)) return { ...program, ...plain(file) };
  const files = filesOf(program);
  return withFiles(
    program,
    files.some(isNamed(key)) ? files.map((f) => (isNamed(key)(f) ? file : f)) : [...files, file],
  );
}

/** The work without one of the files beside its program. */
export const withoutFile = (program: ProgramWork, key: string): ProgramWork =>
  withFiles(
    program,
    filesOf(program).filter((file) => !isNamed(key)(file)),
  );

/**
 * The work with another of its files as the program that runs; the one that ran so far stands beside it, in its place.
 */
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
