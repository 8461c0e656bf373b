import type { NcSeverity } from "../issue.ts";

interface Data {
  /** The block is neither known DIN/ISO nor known Klartext, and is kept as text. */
  isoBlockNotUnderstood: { text: string };
  /** A word that is not translated; its whole block is kept as text. */
  isoWordNotUnderstood: { word: string };
  /** A word lacks its value; its whole block is kept as text. */
  isoValueMissing: { word: string };
  /** Coordinates before any path function; the block is kept as text. */
  isoPathMissing: {};
  /** G05 or G15 before any arc with a direction; the block is kept as text. */
  isoDirectionMissing: { word: string };
  /** A working plane outside a tool call and a blank: Klartext has no block for it, so it is left out. */
  isoPlaneLeftOut: { word: string };
  /** Block numbers that do not rise, or leave no room: the blocks are counted from 0. */
  isoBlocksRecounted: {};
}

export type IsoIssueCode = keyof Data;

/** A finding without its place; `at` counts characters of the block after its number. */
export type IsoProblem = {
  [C in IsoIssueCode]: { readonly code: C; readonly at: number; readonly data: Readonly<Data[C]> };
}[IsoIssueCode];

/** One finding of the reader. Lines and columns of the DIN/ISO text count from 1; `number`: block number, or null. */
export type IsoIssue = {
  [C in IsoIssueCode]: {
    readonly code: C;
    readonly severity: NcSeverity;
    readonly number: number | null;
    readonly line: number;
    readonly column: number;
    readonly data: Readonly<Data[C]>;
  };
}[IsoIssueCode];

/** The severity of a finding: blocks kept as text do not run. */
export const isoSeverity = (code: IsoIssueCode): NcSeverity =>
  code === "isoBlocksRecounted" ? "info" : code === "isoPlaneLeftOut" ? "warning" : "error";
