import type { ClampingDraft } from "../../program/clamping/words.ts";
import type { BlankDraft, ContourRow } from "../../program/job/job.ts";
import type { ShopRules } from "../types.ts";

/** What the drawing says about the element of a row. Everything is optional. */
export interface RowMark {
  /** Designation of a thread on a cylinder or cone: "M30x1.5", "G1/2", "Tr40x7". */
  readonly thread?: string;
  /**
   * Designation of an undercut: "DIN 509-F 0.6x0.3", "DIN 76-A". A row of kind UDC takes form and words from it; for any
   * other row it names the drawn geometry.
   */
  readonly undercut?: string;
  /** Tolerance of the ⌀ of a cylinder, or of the position of a face: "h6", "+0.02/-0.01". */
  readonly tolerance?: string;
  /** Greatest arithmetical mean roughness, and greatest mean roughness depth, µm. */
  readonly ra?: number;
  readonly rz?: number;
}

/** General allowances of a drawing, for everything without a mark. */
export interface GeneralAllowances {
  /** General tolerances as in the title block: "ISO 2768-m". */
  readonly tolerance?: string;
  readonly ra?: number;
  readonly rz?: number;
}

/** The stock: a cylinder as typed, or the rows of its outline. */
export type PartBlank = BlankDraft | { readonly outline: readonly ContourRow[] };

/** A finished part as its drawing states it, mm. Z0 is the finished front face. */
export interface FinishedPart {
  readonly name: string;
  /** Material by its id in the cutting data. */
  readonly material: string;
  /**
   * Rows of the outside contour, with or without its faces; a closed one holds the bore, too. It may run from either
   * end.
   */
  readonly outside: readonly ContourRow[];
  /** Rows of the bore; empty without one. */
  readonly inside: readonly ContourRow[];
  /** Marks by the id of their row. */
  readonly marks: Readonly<Record<string, RowMark>>;
  readonly general: GeneralAllowances;
  /** Null: proposed. */
  readonly blank: PartBlank | null;
  readonly clamping: ClampingDraft | null;
  /** Series from bar: the part is parted off. */
  readonly partsOff: boolean;
  /** Behind the end of the outside contour the part remains as the blank is. */
  readonly unmachinedBehind: boolean;
  /** Rules of the shop that differ from the usual ones. */
  readonly rules: Partial<ShopRules>;
}

/** A part without a contour. */
export const newPart = (name: string): FinishedPart => ({
  name,
  material: "c45",
  outside: [],
  inside: [],
  marks: {},
  general: {},
  blank: null,
  clamping: null,
  partsOff: false,
  unmachinedBehind: false,
  rules: {},
});
