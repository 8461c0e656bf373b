import type { CycleNumber, ParamTextId } from "../cycles/index.ts";
import type { Evidence } from "../cycles/params.ts";

/** Words of NC text, with their evidence: they are facts about the control, not translations. */
export interface NcWord {
  readonly text: string;
  readonly evidence: Evidence;
}

/** The words of one NC-text language. */
export interface NcWords {
  /** After the number in the CYCL DEF line. */
  readonly cycles: Readonly<Record<CycleNumber, NcWord>>;
  /** After the semicolon of each parameter line. */
  readonly params: Readonly<Record<ParamTextId, NcWord>>;
  /** Cycle 14: after 14.0, and before the label number after 14.1. */
  readonly contour: { readonly title: string; readonly label: string; readonly evidence: Evidence };
}
