import { readText } from "../../program/values/field.ts";
import type { Job } from "../../program/job/job.ts";
import type { MachineData } from "../../program/machine/machine-data.ts";
import type { Control } from "../../program/tools/plane-types.ts";
import type { ShopTools } from "../../program/tools/read-tools.ts";
import { SETUP_FIELDS } from "../../program/job/setup-fields.ts";
import type { WorkFile } from "../document/work.ts";

/** A program to calculate. */
export interface Request {
  readonly version: number;
  readonly text: string;
  /** Name of its file. */
  readonly name?: string;
  /** The files beside it: what it can call. */
  readonly files?: readonly Pick<WorkFile, "name" | "text">[];
  /** Blocks behind a skip mark are left out. */
  readonly skipMarked?: boolean;
  /** The tools that the program can call. */
  readonly table: ShopTools;
  /** Rapid rate for times where the machine states none, mm/min. */
  readonly rapid: number;
  /** What times are worked out with beside it; null or absent where nothing is known of the machine. */
  readonly machine?: MachineData | null;
  /** How APPR and DEP move in the tool axis. */
  readonly control: Control;
}

/** Rapid rate that times are estimated with when none can be read, mm/min. */
export const USUAL_RAPID = 10_000;

/** Rapid rate of a job, mm/min. */
export const rapidOf = (job: Job): number => readText(SETUP_FIELDS.rapid, job.rapid).value ?? USUAL_RAPID;
