/** A Q, QL, QR or QS parameter in place of a number, with its sign. */
export interface Parameter {
  readonly parameter: string;
  readonly negative: boolean;
}
/** A number, or the parameter that holds it. Units are those of the program. */
export type Value = number | Parameter;
/** A label by number or by name; `LBL 0` ends a subprogram. */
export type Label = number | string;

export type AxisName = "X" | "Y" | "Z" | "A" | "B" | "C" | "U" | "V" | "W";
/** One coordinate of a block; X is a diameter while turning. */
export interface AxisWord {
  readonly axis: AxisName;
  readonly value: Value;
  readonly incremental: boolean;
}
/** PR or PA, absolute or incremental. */
export interface PolarWord {
  readonly value: Value;
  readonly incremental: boolean;
}
/** FMAX, FAUTO, or a number with its unit letters. */
export type FeedWord = "max" | "auto" | { readonly value: Value; readonly unit: "F" | "FU" | "FZ" };
export type Compensation = "R0" | "RL" | "RR";

/** The words of a path block, each at most once except axes and M functions. */
export interface Words {
  readonly axes: readonly AxisWord[];
  readonly polarRadius?: PolarWord;
  readonly polarAngle?: PolarWord;
  /** CCA, degrees. */
  readonly centreAngle?: Value;
  /** LEN. */
  readonly length?: Value;
  /** R of an arc, rounding or approach. */
  readonly radius?: Value;
  /** DR+ is "ccw". */
  readonly turn?: "cw" | "ccw";
  /** LIN_Z and the like: a third axis moved along with an arc. */
  readonly linear?: readonly AxisWord[];
  readonly compensation?: Compensation;
  readonly feed?: FeedWord;
  /** M functions in their order. */
  readonly functions: readonly number[];
  /** MB of M140. */
  readonly retract?: Value | "max";
  /** A feed behind M140 or M128: it belongs to that function, not to the path. */
  readonly functionFeed?: FeedWord;
  /** Words that are not understood but stored. */
  readonly extra?: readonly string[];
}
/** A block without words. */
export const noWords: Words = { axes: [], functions: [] };

export const PATH_KINDS = ["L", "C", "CR", "CT", "CTP", "LP", "CP", "CC", "RND"] as const;
export type PathKind = (typeof PATH_KINDS)[number];
export const APPROACH_FORMS = ["LT", "LN", "CT", "LCT", "PLT", "PLN", "PCT", "PLCT"] as const;
export type ApproachForm = (typeof APPROACH_FORMS)[number];

export const FREE_FORMS = ["FL", "FLT", "FC", "FCT", "FPOL", "FSELECT"] as const;
export type FreeForm = (typeof FREE_FORMS)[number];

export interface CycleParameter {
  /** "Q215". */
  readonly q: string;
  /** null where the text cannot be read. */
  readonly value: Value | "auto" | "max" | null;
  /** Text behind `;`, without the continuation mark. */
  readonly label: string | null;
}

/** Right side of an assignment. */
export type Formula =
  | { readonly kind: "value"; readonly value: Value }
  | { readonly kind: "call"; readonly name: string; readonly of: Formula }
  | { readonly kind: "negative"; readonly of: Formula }
  | {
      /** "length" is LEN of FN 8, "angle" ANG of FN 13. */
      readonly kind: "sum" | "difference" | "product" | "quotient" | "power" | "remainder" | "length" | "angle";
      readonly left: Formula;
      readonly right: Formula;
    }
  | {
      readonly kind: "ofText";
      readonly name: "TONUMB" | "INSTR" | "STRLEN" | "STRCOMP";
      readonly source: TextFormula;
      /** The text searched by INSTR or compared by STRCOMP. */
      readonly search: TextFormula | null;
      readonly begin: Value | null;
    }
  | { readonly kind: "undefined" };

/** Right side of an assignment to a QS parameter. */
export type TextFormula =
  | { readonly kind: "quoted"; readonly text: string }
  | { readonly kind: "parameter"; readonly parameter: string }
  | { readonly kind: "joined"; readonly parts: readonly TextFormula[] }
  | { readonly kind: "toChar"; readonly value: Value; readonly decimals: Value | null }
  | {
      readonly kind: "part";
      readonly source: TextFormula;
      readonly begin: Value | null;
      readonly length: Value | null;
    };

/** The file that a block names, or the parameter that holds its name. */
export type FileName = string | Parameter;

/** The source of an outline: a label of the program, or a file. */
export type OutlinePlace = { readonly label: Label | Parameter } | { readonly file: FileName };

/** The source of a blank outline: a label, or a file. */
export type OutlineSource = { readonly label: Label } | { readonly file: FileName };

/** One area of CONTOUR DEF: pocket, island or void, by its label or its file. */
export interface ContourArea {
  readonly role: "P" | "I" | "V";
  readonly number: number;
  readonly from: OutlinePlace;
  readonly depth: Value | null;
}

/** A named word of an undercut, a groove or a correction. */
export interface NamedWord {
  readonly name: string;
  readonly value: Value;
}

export const COMPARISONS = ["EQU", "NE", "GT", "LT", "IS DEFINED", "IS UNDEFINED"] as const;
/** The condition of a jump on two values, or on one parameter. */
export type Comparison = (typeof COMPARISONS)[number];

/** FN functions that assign their result to a parameter. */
export const FUNCTION_NUMBERS = [0, 1, 2, 3, 4, 5, 6, 7, 8, 13] as const;
export type FunctionNumber = (typeof FUNCTION_NUMBERS)[number];
