import { klartext } from "./blocks/klartext.ts";
import type { Statement } from "./statement.ts";
import type { Style } from "./style.ts";

/** The lines of a statement without block number and line ends; only cycles have more than one. */
export const statementLines = (s: Statement, style: Style): readonly string[] => klartext.lines(s, style);

/** The text before a statement: number and skip mark. The TNC 640 writes two blanks before older cycles. */
export function headText(number: number | null, skip: boolean, s: Statement, style: Style): string {
  const mark = skip ? "/" : "";
  return number === null ? mark : `${mark}${number}${style.wide && s.kind === "cycleLine" ? "  " : " "}`;
}

/** A block with number and line end. */
export function blockText(
  number: number | null,
  s: Statement,
  style: Style,
  more: { readonly skip?: boolean; readonly comment?: string | null } = {},
): string {
  const lines = statementLines(s, style);
  const comment = more.comment === undefined || more.comment === null ? "" : ` ;${more.comment}`;
  return (
    headText(number, more.skip ?? false, s, style) +
    lines.map((line, i) => line + (i === 0 ? comment : "") + style.newLine).join("")
  );
}

/** A program of statements, numbered from 0, or without numbers. Blank lines carry no number. */
export function programText(statements: readonly Statement[], style: Style, numbered = true): string {
  let next = 0;
  return statements.map((s) => blockText(numbered && s.kind !== "empty" ? next++ : null, s, style)).join("");
}
