import type { AnswerCache } from "../../kernel/answer-cache.ts";
import type { Issue } from "../../kernel/plan/issue.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { MachineData } from "../machine/machine-data.ts";
import type { Control, Mill } from "../tools/plane-types.ts";
import type { ProgramFiles } from "./program-files.ts";
import type { Tracing } from "./tracing.ts";

/** Environment of a run. */
export interface Shop {
  readonly tools: readonly Tool[];
  /** Tools with invalid columns, with their issues. */
  readonly refused?: ReadonlyMap<number, readonly Issue[]>;
  /** Rapid rate for times where the machine states none, mm/min. */
  readonly rapid: number;
  /** Known data of the machine. */
  readonly machine?: MachineData;
  /** Milling tools of the table. */
  readonly mills?: readonly Mill[];
  /** Which control it is: how APPR and DEP move in the tool axis. "TNC 640" when absent. */
  readonly control?: Control;
  /** Programs that can be called. */
  readonly files?: ProgramFiles;
  /** Updates a traced blank; without it the cycles are planned as if nothing was traced. */
  readonly tracing?: Tracing;
  /** Cache of earlier runs: contours, plans, steps; without it everything is recomputed. */
  readonly memory?: AnswerCache;
  /** True to skip the blocks marked with `/`. */
  readonly skipMarked?: boolean;
}
