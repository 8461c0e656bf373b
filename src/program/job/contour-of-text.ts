import type { Program } from "../../nc/program.ts";
import type { Statement } from "../../nc/statement.ts";
import type { AxisWord, Label, Words } from "../../nc/words.ts";
import { newRow, type ContourRow } from "./job.ts";
import { valueAsTyped } from "../values/typed-value.ts";

const word = (axes: readonly AxisWord[], name: "X" | "Z") => axes.find((w) => w.axis === name);
const place = ({ axes }: Words) => {
  const [x, z] = [word(axes, "X"), word(axes, "Z")];
  return {
    x: x ? valueAsTyped(x.value) : "",
    z: z ? valueAsTyped(z.value) : "",
    incrementalX: x?.incremental ?? false,
    incrementalZ: z?.incremental ?? false,
  };
};

const polar = ({ polarRadius, polarAngle }: Words): ContourRow["words"] => ({
  ...(polarRadius && { [polarRadius.incremental ? "IPR" : "PR"]: valueAsTyped(polarRadius.value) }),
  ...(polarAngle && { [polarAngle.incremental ? "IPA" : "PA"]: valueAsTyped(polarAngle.value) }),
});

/** One block of a contour subprogram as a table row; null where it is no plain element. */
function rowOf(s: Statement, id: string): ContourRow | null {
  if (s.kind === "chamfer") return newRow(id, { kind: "CHF", r: s.length === null ? "" : valueAsTyped(s.length) });
  if (s.kind !== "path") return null;
  const { radius, turn } = s.words;
  const r = radius === undefined ? "" : valueAsTyped(radius);
  if (s.path === "L") return newRow(id, { kind: "L", ...place(s.words) });
  if (s.path === "LP" || s.path === "CP" || s.path === "CTP")
    return newRow(id, { kind: s.path, words: polar(s.words), turn: turn ?? "ccw" });
  if (s.path === "CC" || s.path === "C" || s.path === "CT")
    return newRow(id, { kind: s.path, ...place(s.words), turn: turn ?? "ccw" });
  if (s.path === "RND") return newRow(id, { kind: "RND", r });
  if (s.path === "CR") return newRow(id, { kind: "CR", ...place(s.words), r, turn: turn ?? "cw" });
  return null;
}

/** Plain elements from a block to the end of its subprogram, as table rows. */
export function rowsFrom({ blocks }: Program, first: number): readonly ContourRow[] {
  const rows: ContourRow[] = [];
  for (let i = first; i < blocks.length; i += 1) {
    const s = blocks[i]?.statement;
    if (!s || s.kind === "label" || s.kind === "end") break;
    const row = rowOf(s, `b${i}`);
    if (row) rows.push(row);
  }
  return rows;
}

/** Contour of the last cycle 14 before a block, as table rows; empty without one. */
export function contourBefore(program: Program, index: number): readonly ContourRow[] {
  const { blocks } = program;
  const named = blocks
    .slice(0, index)
    .findLast((b) => b.statement.kind === "cycleLine" && b.statement.cycle === 14 && b.statement.line > 0)?.statement;
  const found = named?.kind === "cycleLine" ? /"([^"]+)"|(\d{1,9})/.exec(named.text) : null;
  if (!found) return [];
  const label = found[1] ?? Number(found[2]);
  const first = blocks.findIndex((b) => b.statement.kind === "label" && b.statement.label === label);
  if (first < 0) return [];
  return rowsFrom(program, first + 1);
}

/** A contour subprogram as table rows. */
export interface LabelledContour {
  readonly label: Label;
  readonly rows: readonly ContourRow[];
}

/** Least elements of a contour: a start point and one line. */
const LEAST = 2;

/** The subprograms of a program that are contours: labels with elements only, in the order of the text. */
export const contoursIn = (program: Program): readonly LabelledContour[] =>
  program.blocks.flatMap(({ statement: s }, i): readonly LabelledContour[] => {
    if (s.kind !== "label" || s.label === 0) return [];
    const end = program.blocks.findIndex((b, k) => k > i && b.statement.kind === "label");
    const rows = rowsFrom(program, i + 1);
    const between = program.blocks.slice(i + 1, end < 0 ? undefined : end);
    const isPlain = between.every((b) =>
      ["path", "chamfer", "undercut", "groove", "comment", "empty"].includes(b.statement.kind),
    );
    return end > i && isPlain && rows.length >= LEAST ? [{ label: s.label, rows }] : [];
  });
