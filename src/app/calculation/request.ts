import { readText } from "../../program/values/field.ts";
import type { Job } from "../../program/job/job.ts";
import type { MachineData } from "../../program/machine/machine-data.ts";
import type { Control } from "../../program/tools/plane-types.ts";
import type { ShopTools } from "../../program/tools/read-tools.ts";
import { SETUP_FIELDS } from "../../program/job/setup-fields.ts";
import { textOf } from "../document/printed.ts";
import { filesOf, isProgram, type Work, type WorkFile } from "../document/work.ts";

/** A program to calculate. */
export interface Request {
  readonly version: number;
  readonly text: string;
  /** Name of its file. */
  readonly name?: string;
  /** Its other files, which it can call. */
  readonly files?: readonly Pick<WorkFile, "name" | "text">[];
  /** Blocks with a skip mark are skipped. */
  readonly skipMarked?: boolean;
  /** The tools that the program can call. */
  readonly table: ShopTools;
  /** Rapid rate for times where the machine states none, mm/min. */
  readonly rapid: number;
  /** Machine data for times; null or absent if unknown. */
  readonly machine?: MachineData | null;
  /** How APPR and DEP move in the tool axis. */
  readonly control: Control;
}

/** Rapid rate that times are estimated with when none can be read, mm/min. */
export const USUAL_RAPID = 10_000;

/** Rapid rate of a job, mm/min. */
export const rapidOf = (job: Job): number => readText(SETUP_FIELDS.rapid, job.rapid).value ?? USUAL_RAPID;

/** What is run of a work. */
export const runOf = (work: Work) =>
  isProgram(work)
    ? {
        text: work.text,
        name: work.name,
        files: filesOf(work),
        skipMarked: work.skipMarked ?? false,
        rapid: USUAL_RAPID,
      }
    : { text: textOf(work), rapid: rapidOf(work) };
