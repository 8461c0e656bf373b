import type { Answers } from "../../kernel/answers.ts";
import type { Issue } from "../../kernel/plan/issue.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { MachineData } from "../machine/machine-data.ts";
import type { Control, Mill } from "../tools/plane-types.ts";
import type { ProgramFiles } from "./program-files.ts";
import type { Tracing } from "./tracing.ts";

/** What a run can use. */
export interface Shop {
  readonly tools: readonly Tool[];
  /** Tools whose columns are impossible, with what is wrong. */
  readonly refused?: ReadonlyMap<number, readonly Issue[]>;
  /** Rapid rate for times where the machine states none, mm/min. */
  readonly rapid: number;
  /** What the machine can do, as far as it is known. */
  readonly machine?: MachineData;
  /** Milling tools of the table. */
  readonly mills?: readonly Mill[];
  /** Which control it is: how APPR and DEP move in the tool axis. "TNC 640" when absent. */
  readonly control?: Control;
  /** Programs that the one that runs can call. */
  readonly files?: ProgramFiles;
  /** Traces the blank that a program asks to be traced; without it the cycles are planned as if it did not. */
  readonly tracing?: Tracing;
  /** Answers of earlier runs: contours, plans and steps; without it everything is computed again. */
  readonly memory?: Answers;
  /** True to leave out the blocks that are marked with `/`. */
  readonly skipMarked?: boolean;
}
