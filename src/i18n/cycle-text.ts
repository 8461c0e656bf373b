import type { Group } from "../cycles/define.ts";
import type { KeptNumber } from "../cycles/kept-cycles.ts";
import type { CycleNumber } from "../cycles/index.ts";
import type { Evidence, Kind } from "../cycles/params.ts";

/** What the screen says about one cycle, in our own words after its manual page. */
export interface CycleText {
  /** Heading: what it is called in the trade. */
  readonly name: string;
  /** One sentence for the menu. */
  readonly summary: string;
  readonly description: readonly string[];
  /** The numbered steps of the manual, each short enough for a status line. */
  readonly rough: readonly string[];
  readonly finish: readonly string[];
  readonly notes: readonly string[];
}

/** Texts about cycles. A cycle of the catalogue without its texts is a compile error in each language. */
export interface CyclesTexts {
  readonly groups: Readonly<Record<Group, string>>;
  readonly evidence: Readonly<Record<Evidence, string>>;
  /** What a value measures, in a word or two. */
  readonly kinds: Readonly<Record<Kind, string>>;
  /** Status line while a move runs: number of the step, how many there are, what it does. */
  readonly roughStep: (step: number, of: number, text: string) => string;
  readonly finishStep: (step: number, of: number, text: string) => string;
  /** Before step 1. */
  readonly positioning: string;
  /** Those that are read and kept, and not run. */
  readonly kept: Readonly<Record<KeptNumber, string>>;
  readonly of: Readonly<Record<CycleNumber, CycleText>>;
}

/** Texts of some of them: those of one group. */
export type CycleTexts = Partial<Record<CycleNumber, CycleText>>;
