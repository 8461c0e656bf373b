/** A Q, QL, QR or QS parameter where a number may stand, with its sign. */
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
/** FMAX, FAUTO, or a number with its unit as the letters say it. */
export type FeedWord = "max" | "auto" | { readonly value: Value; readonly unit: "F" | "FU" | "FZ" };
export type Compensation = "R0" | "RL" | "RR";

/** The words that a path block may carry, each at most once except axes and M functions. */
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
  readonly linear: readonly AxisWord[];
  readonly compensation?: Compensation;
  readonly feed?: FeedWord;
  /** M functions in their order. */
  readonly functions: readonly number[];
  /** MB of M140. */
  readonly retract?: Value | "max";
  /** A feed behind M140 or M128: it belongs to that function, not to the path. */
  readonly functionFeed?: FeedWord;
  /** Words that are kept and not understood. */
  readonly extra: readonly string[];
}

export const PATH_KINDS = ["L", "C", "CR", "CT", "CTP", "LP", "CP", "CC", "RND"] as const;
export type PathKind = (typeof PATH_KINDS)[number];
export const APPROACH_FORMS = ["LT", "LN", "CT", "LCT", "PLT", "PLN", "PCT", "PLCT"] as const;
export type ApproachForm = (typeof APPROACH_FORMS)[number];

export const FREE_FORMS = ["FL", "FLT", "FC", "FCT", "FPOL", "FSELECT"] as const;
export type FreeForm = (typeof FREE_FORMS)[number];

export interface CycleParameter {
  /** "Q215". */
  readonly q: string;
  /** null when what stands there can not be read. */
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
      /** What INSTR looks for and STRCOMP compares with. */
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

/** Where an outline stands: behind a label of the program, or in a file. */
export type OutlinePlace = { readonly label: Label | Parameter } | { readonly file: FileName };

/** Where an outline of a blank stands: behind a label, or in a file. */
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
/** What a jump asks of two values, or of one parameter. */
export type Comparison = (typeof COMPARISONS)[number];

/** FN functions that set a parameter to what they work out. */
export const FUNCTION_NUMBERS = [0, 1, 2, 3, 4, 5, 6, 7, 8, 13] as const;
export type FunctionNumber = (typeof FUNCTION_NUMBERS)[number];

/** What one block says. */
export type Statement =
  | { readonly kind: "empty" }
  | { readonly kind: "comment"; readonly text: string }
  | { readonly kind: "structure"; readonly text: string }
  | { readonly kind: "begin" | "end"; readonly name: string; readonly unit: "MM" | "INCH" }
  /** Corner 1 names the tool axis. */
  | {
      readonly kind: "blankBox";
      readonly corner: 1 | 2;
      readonly axis: AxisName | null;
      readonly axes: readonly AxisWord[];
    }
  | {
      readonly kind: "blankCylinder";
      readonly axis: AxisName;
      readonly outside: { readonly measure: "D" | "R"; readonly value: Value } | null;
      readonly length: Value | null;
      readonly distance: Value | null;
      readonly inside: { readonly measure: "DI" | "RI"; readonly value: Value } | null;
    }
  /** `inner`: label of what it is hollow by. */
  | {
      readonly kind: "blankRotation";
      readonly axis: AxisName;
      readonly measure: "D" | "R";
      readonly outline: OutlineSource;
      readonly inner: Label | null;
    }
  /** A body in a file of its own; `target` is that of the finished part. */
  | { readonly kind: "blankFile"; readonly file: string; readonly target: string | null }
  | {
      readonly kind: "toolDefinition";
      readonly tool: Label;
      readonly length: Value | null;
      readonly radius: Value | null;
    }
  | {
      readonly kind: "toolCall";
      /** null: only speed, feed or deltas change. */
      readonly tool: Label | Parameter | null;
      readonly axis: AxisName | null;
      readonly speed: Value | null;
      readonly feed: FeedWord | null;
      readonly deltaLength: Value | null;
      readonly deltaRadius: Value | null;
      readonly extra: readonly string[];
    }
  | { readonly kind: "mode"; readonly mode: "TURN" | "MILL"; readonly kinematics: string | null }
  | {
      readonly kind: "spin";
      /** True: constant cutting speed. */
      readonly constantSurface: boolean;
      readonly cuttingSpeed: Value | null;
      readonly speed: Value | null;
      readonly limit: Value | null;
      /** GEARRANGE: which gear of the spindle. */
      readonly gear?: Value | null;
    }
  | {
      readonly kind: "turnCorrection";
      readonly system: "TCS" | "WPL";
      readonly plane: string;
      readonly words: readonly NamedWord[];
    }
  | { readonly kind: "turnBlank"; readonly blank: OutlineSource | "off" }
  | { readonly kind: "path"; readonly path: PathKind; readonly words: Words }
  /** An element of a free contour, its pole, or which solution is meant; `given`: what only such elements have. */
  | { readonly kind: "free"; readonly form: FreeForm; readonly given: readonly NamedWord[]; readonly words: Words }
  /** Chamfer with its side length. */
  | { readonly kind: "chamfer"; readonly length: Value | null; readonly words: Words }
  | { readonly kind: "approach"; readonly departing: boolean; readonly form: ApproachForm; readonly words: Words }
  | { readonly kind: "undercut"; readonly form: string; readonly words: readonly NamedWord[] }
  | { readonly kind: "groove"; readonly form: "RADIAL" | "AXIAL"; readonly words: readonly NamedWord[] }
  | { readonly kind: "label"; readonly label: Label }
  | { readonly kind: "call"; readonly label: Label | Parameter; readonly repeat: Value | null }
  /** One of the numbered lines of an older cycle: 14.0, 14.1 … */
  | { readonly kind: "cycleLine"; readonly cycle: number; readonly line: number; readonly text: string }
  | {
      readonly kind: "cycle";
      readonly cycle: number;
      readonly name: string;
      readonly parameters: readonly CycleParameter[];
    }
  | { readonly kind: "cycleCall"; readonly how: "" | "POS" | "PAT"; readonly words: Words }
  | { readonly kind: "selectContour"; readonly file: FileName }
  | { readonly kind: "contourDefinition"; readonly areas: readonly ContourArea[] }
  /** A contour QC1 of a contour formula. */
  | {
      readonly kind: "declareContour";
      readonly contour: string;
      readonly from: OutlinePlace;
      readonly depth: Value | null;
    }
  /** How declared contours make one: their names, the signs between them, brackets. */
  | { readonly kind: "contourFormula"; readonly target: string; readonly terms: readonly string[] }
  /** FN 14: the control stops with an error of this number. */
  | { readonly kind: "raise"; readonly error: Value }
  /** `bare`: the name stands without quotes. */
  | { readonly kind: "callProgram"; readonly file: FileName; readonly bare: boolean }
  | { readonly kind: "selectProgram"; readonly file: FileName; readonly bare: boolean }
  | { readonly kind: "callSelected" }
  /** A jump when a comparison holds; `fn` is the number of the FN function, null where only IF stands. */
  | {
      readonly kind: "jump";
      readonly fn: 9 | 10 | 11 | 12 | null;
      readonly left: Value;
      readonly compare: Comparison;
      /** null with IS DEFINED and IS UNDEFINED. */
      readonly right: Value | null;
      readonly label: Label | Parameter;
    }
  /** TRANS DATUM: the words of AXIS, or RESET. */
  | { readonly kind: "datum"; readonly shift: readonly AxisWord[] | "reset" }
  /** TRANS DATUM TABLE with the row as it is written. */
  | { readonly kind: "datumTable"; readonly row: string }
  /** TRANS MIRROR, TRANS ROTATION and TRANS SCALE. */
  | { readonly kind: "mirror"; readonly axes: readonly AxisName[] | "reset" }
  | { readonly kind: "rotation"; readonly angle: PolarWord | "reset" }
  | { readonly kind: "scale"; readonly factor: Value | "reset" }
  /** PLANE in all its forms, FUNCTION TCPM and its reset: read by what runs them. */
  | { readonly kind: "plane"; readonly text: string }
  /** `fn` is the number of the FN function, null for a formula. */
  | { readonly kind: "assign"; readonly fn: FunctionNumber | null; readonly target: string; readonly formula: Formula }
  /** `declared`: DECLARE STRING stands before it. */
  | { readonly kind: "assignText"; readonly declared: boolean; readonly target: string; readonly text: TextFormula }
  /** M functions without a path. */
  | { readonly kind: "functions"; readonly words: Words }
  | { readonly kind: "stop"; readonly words: Words }
  | { readonly kind: "unknown"; readonly text: string };

/** A block of one kind, or of several. */
export type StatementOf<K extends Statement["kind"]> = Extract<Statement, { kind: K }>;
