import type { Job } from "../program/job.ts";

/** How the bytes of a program file stand for characters. Controls also write files that are not UTF-8. */
export type Encoding = "utf-8" | "windows-1252";

/** A whole program as work: its state is its text. Everything else is made from it. */
export interface ProgramWork {
  /** Name of its file, with ending. */
  readonly name: string;
  /** Exactly as read, with its line ends. */
  readonly text: string;
  readonly encoding: Encoding;
}

/** What an operator works on: one cycle by its prompts, or a whole program. */
export type Work = Job | ProgramWork;

export const isProgram = (work: Work): work is ProgramWork => "text" in work;
