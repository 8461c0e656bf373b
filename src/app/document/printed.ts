import { ncLabels } from "../../i18n/nc-labels.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { Job, SetJob } from "../../program/job/job.ts";
import { printAsInManual, printJob } from "../../program/job/print-job.ts";
import { retryImport } from "../base/parts.ts";
import { completeJob } from "./reading.ts";
import { openContent, useEditor } from "./store.ts";
import { isProgram, onlyBundle, textsOf, type ProgramWork, type Work, type WorkFile } from "./work.ts";
import { shopOf } from "./work-tools.ts";

const printed = new WeakMap<SetJob, string>();

/**
 * The program text of a job with its set-up, which is run and checked: a Klartext file for its control in its own label
 * language, cached per state of the job. Its tools are by default its own, or those of this device.
 */
export function printedText(typed: Job, tools: readonly Tool[] = shopOf(typed).table.tools): string {
  const job = completeJob(typed, tools);
  const known = printed.get(job);
  if (known !== undefined) return known;
  const text = printJob(job, ncLabels(job.ncLanguage));
  printed.set(job, text);
  return text;
}

/** The program text of a work: that of a program, or a job's as printed. */
export const textOf = (work: Work): string => (isProgram(work) ? work.text : printedText(work));

/** The program text of the open work; null if none is open. */
export function openText(editor = useEditor.getState()): string | null {
  const content = openContent(editor);
  return content && textOf(content);
}

/** A work as a program with its tools and settings; a job is printed. */
export function asProgram(work: Work): ProgramWork {
  if (isProgram(work)) return work;
  const text = printedText(work);
  return { name: `${programName(text)}.h`, text, encoding: "utf-8", ...onlyBundle(work) };
}

/** The program of a job in the layout of the printed manual, for reading. */
export const manualText = (typed: Job): string => {
  const job = completeJob(typed);
  return printAsInManual(job, ncLabels(job.ncLanguage));
};

/** A program as a DIN/ISO file; `kept`: numbers of the blocks without a DIN/ISO equivalent, which remain Klartext. */
export interface IsoFile {
  readonly text: string;
  readonly kept: readonly number[];
}

/** Converts a Klartext program to DIN/ISO; the printer is fetched on first use. */
export async function isoFile(text: string): Promise<IsoFile> {
  const [{ isoProgramText }, { parse }] = await retryImport(() =>
    Promise.all([import("../../nc/iso/print-iso.ts"), import("../../nc/parse.ts")]),
  );
  const made = isoProgramText(parse(text));
  return { text: made.text, kept: made.untranslated.map(({ number }) => number) };
}

/** The exported text of a job: the file that its control loads, whatever layout is shown. */
export async function exportedText(job: Job): Promise<string> {
  const text = printedText(job);
  return job.layout === "iso" ? (await isoFile(text)).text : text;
}

/** The files of a work as a control loads them. */
export const exportedFiles = async (work: Work): Promise<readonly WorkFile[]> =>
  isProgram(work) ? textsOf(work) : [{ name: fileOfJob(work), text: await exportedText(work), encoding: "utf-8" }];

/** The file name of a job: the name in BEGIN PGM with the extension of its format. */
export const fileOfJob = (job: Job): string => `${programName(printedText(job))}.${job.layout === "iso" ? "i" : "h"}`;

/** Name of the program file of a work. */
export const fileOfWork = (work: Work): string => (isProgram(work) ? work.name : fileOfJob(work));

/** The name in BEGIN PGM, which is also the name of the file. */
export const programName = (text: string): string => /BEGIN PGM (\S+)/.exec(text)?.[1] ?? "PROGRAM";

/** One block of a program: its number, counted if the file has none, and its lines. */
export interface PrintedBlock {
  readonly number: number;
  readonly lines: readonly string[];
}

const NUMBER = /^\/?N?(\d+)\s/;
const VALUE = /^\s*Q\d+ ?=/;

/** Splits a program into blocks: a parameter list continues after ` ~`, in the manual layout with lines of values. */
export function printedBlocks(text: string): readonly PrintedBlock[] {
  const blocks: { number: number; lines: string[] }[] = [];
  for (const line of text.split(/\r?\n/)) {
    if (line.trim() === "") continue;
    const open = blocks.at(-1),
      number = NUMBER.exec(line)?.[1];
    if (open && (open.lines.at(-1)?.endsWith("~") || (number === undefined && VALUE.test(line)))) open.lines.push(line);
    else blocks.push({ number: number === undefined ? (open?.number ?? -1) + 1 : Number(number), lines: [line] });
  }
  return blocks;
}

/** Blocks of a program in Klartext or DIN/ISO, comments among them. */
export const blockCount = (text: string): number => printedBlocks(text).length;
