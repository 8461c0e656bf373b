/** The control that loads a file: Klartext of the TNC 640 or TNC7, or DIN/ISO of both. */
export type LoadingControl = "tnc640" | "tnc7" | "iso";

/** Refusals of a control, by code with the data of the message. */
export interface RefusalData {
  /** The first block is not `BEGIN PGM`, or not `%NAME`. */
  readonly beginMissing: { readonly text: string };
  /** No `END PGM`, or no second `%NAME`. */
  readonly endMissing: Readonly<Record<never, never>>;
  /** A block behind the end of the program, or a second beginning inside it. */
  readonly outsideProgram: { readonly text: string };
  readonly nameMissing: Readonly<Record<never, never>>;
  /** A character that cannot stand in the name of a program. */
  readonly nameCharacter: { readonly name: string; readonly character: string };
  /** Beginning and end name different programs. */
  readonly nameDiffers: { readonly begin: string; readonly end: string };
  /** Neither MM nor INCH behind the name; neither G71 nor G70 in DIN/ISO. */
  readonly unitMissing: { readonly units: string };
  /** The text in place of the block number is no whole number. */
  readonly blockNumber: { readonly text: string };
  /** A list over several lines without ` ~`; `lines`: how many lines become blocks of their own. */
  readonly listWithoutTilde: { readonly list: string; readonly lines: number };
  /** A line ends in `~`, and no line of the same block follows. */
  readonly tildeAtEnd: Readonly<Record<never, never>>;
  /** A Q parameter of a list without `=`. */
  readonly equalsMissing: { readonly word: string };
  /** A word that the language does not have, or not in such a block. */
  readonly unknownWord: { readonly text: string };
  /** A formula in which two values meet, or an operator has no value. */
  readonly formulaBroken: { readonly text: string };
  readonly valueMissing: { readonly word: string };
  readonly badNumber: { readonly word: string; readonly text: string };
  readonly outOfRange: { readonly word: string; readonly text: string; readonly least: number; readonly most: number };
  /** More digits than the input format of the word has, in front of the point or behind it. */
  readonly tooManyDigits: {
    readonly word: string;
    readonly text: string;
    readonly before: number;
    readonly after: number;
  };
  /** A fifth M function in one block. */
  readonly tooManyFunctions: { readonly text: string; readonly most: number };
  /** A label that is set twice; `line`: line of the first. */
  readonly labelTwice: { readonly label: string; readonly line: number };
  readonly stringOpen: Readonly<Record<never, never>>;
  readonly bracketOpen: Readonly<Record<never, never>>;
  /** A DIN/ISO block without ` *` at its end. */
  readonly starMissing: Readonly<Record<never, never>>;
}
export type RefusalCode = keyof RefusalData;

/** One reason why a control does not load a file, with its place: line and column count from 1. */
export type FileRefusal = {
  [C in RefusalCode]: {
    readonly line: number;
    readonly column: number;
    /** Number of the block, as printed or counted on from the previous block; null without a block. */
    readonly block: number | null;
    readonly code: C;
    readonly data: RefusalData[C];
  };
}[RefusalCode];

/** A refusal within one line, without line and block; `at` counts from 0. */
export type LineRefusal = {
  [C in RefusalCode]: { readonly at: number; readonly code: C; readonly data: RefusalData[C] };
}[RefusalCode];

export const refuse = <C extends RefusalCode>(at: number, code: C, data: RefusalData[C]): LineRefusal =>
  ({ at, code, data }) as LineRefusal;
