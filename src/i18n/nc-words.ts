import type { CycleNumber, ParamTextId } from "../cycles/index.ts";
import type { Evidence } from "../cycles/params.ts";

/** Words of NC text, with how far they can be trusted: they are facts about the control, not translations. */
export interface NcWord {
  readonly text: string;
  readonly evidence: Evidence;
}

/** The words of one NC-text language. */
export interface NcWords {
  /** Behind the number in the CYCL DEF line. */
  readonly cycles: Readonly<Record<CycleNumber, NcWord>>;
  /** Behind the semicolon of each parameter line. */
  readonly params: Readonly<Record<ParamTextId, NcWord>>;
  /** Cycle 14: behind 14.0, and before the label number behind 14.1. */
  readonly contour: { readonly title: string; readonly label: string; readonly evidence: Evidence };
}
