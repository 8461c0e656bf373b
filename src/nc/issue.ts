/**
 * A finding of the reader: a code with data and place, never a sentence. The sentences belong to the languages, so a
 * new code is a compile error in every language until it has a text.
 */
export type NcSeverity = "error" | "warning" | "info";

interface Data {
  /** The block stays in the text; it is not executed. */
  notUnderstood: { text: string };
  /** A word of a block that is otherwise understood. */
  wordNotUnderstood: { text: string };
  /** A word stands twice in its block; the last one counts. */
  wordTwice: { word: string };
  /** A Q value without its equals sign, as some manuals print it. */
  equalsMissing: { text: string };
  /** A blank between a Q number and its equals sign in a cycle. */
  blankBeforeEquals: { text: string };
  /** A line with more than `most` characters, which is not read. */
  lineTooLong: { most: number };
  /** A number that cannot be read. */
  badNumber: { text: string };
  /** A block needs this word. */
  wordMissing: { word: string };
  /** A block number that is not the previous one plus one. */
  blockNumber: { found: number; expected: number };
  /** A block without a number in a program that numbers its blocks. */
  blockNumberMissing: { expected: number };
  /** `~` on the last line of a block: the next line is not a continuation. */
  continuationOpen: {};
  /** Lists of cycles without ` ~`, one or more: a control reads their values as blocks of their own. */
  listWithoutTilde: { places: number };
  /** The text is a program in the other language of the controls, DIN/ISO, which is not read. */
  isoProgram: {};
  /** The text does not end with END PGM, or does not start with BEGIN PGM. */
  frameMissing: { which: "BEGIN PGM" | "END PGM" };
}

export type NcCode = keyof Data;

/** Replace `length` characters from `offset` of the whole text by `text`. */
export interface NcFix {
  readonly offset: number;
  readonly length: number;
  readonly text: string;
}

/** One finding. Lines and columns count from 1; offsets from 0 over the whole text. */
export type NcIssue = {
  [C in NcCode]: {
    readonly code: C;
    readonly severity: NcSeverity;
    readonly line: number;
    readonly column: number;
    readonly offset: number;
    readonly length: number;
    readonly data: Readonly<Data[C]>;
    readonly fix?: NcFix;
  };
}[NcCode];

/** An issue before its block has a place: offsets count from the start of the block. */
export type BlockIssue = { [C in NcCode]: Omit<Extract<NcIssue, { code: C }>, "line" | "column"> }[NcCode];
