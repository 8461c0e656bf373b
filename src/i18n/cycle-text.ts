import type { Group } from "../cycles/define.ts";
import type { UnsimulatedNumber } from "../cycles/unsimulated-cycles.ts";
import type { CycleNumber } from "../cycles/index.ts";
import type { Evidence, Kind } from "../cycles/params.ts";

/** The screen texts of one cycle, in our own words after its manual page. */
export interface CycleText {
  /** Heading: its trade name. */
  readonly name: string;
  /** One sentence for the menu. */
  readonly summary: string;
  readonly description: readonly string[];
  /** The numbered steps of the manual, each short enough for a status line. */
  readonly rough: readonly string[];
  readonly finish: readonly string[];
  readonly notes: readonly string[];
}

/** Texts of the cycles. A cycle of the catalogue without texts is a compile error in each language. */
export interface CyclesTexts {
  readonly groups: Readonly<Record<Group, string>>;
  readonly evidence: Readonly<Record<Evidence, string>>;
  /** The quantity of a value, in a word or two. */
  readonly kinds: Readonly<Record<Kind, string>>;
  /** Status line during a move: number of the step, number of steps, what the step does. */
  readonly roughStep: (step: number, of: number, text: string) => string;
  readonly finishStep: (step: number, of: number, text: string) => string;
  /** Before step 1. */
  readonly positioning: string;
  /** Cycles that are read and preserved, not simulated. */
  readonly kept: Readonly<Record<UnsimulatedNumber, string>>;
  readonly of: Readonly<Record<CycleNumber, CycleText>>;
}

/** Texts of some cycles: those of one group. */
export type CycleTexts = Partial<Record<CycleNumber, CycleText>>;
