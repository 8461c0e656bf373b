import { readThread } from "../../kernel/thread/threads.ts";
import { part as space } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { readRows } from "../../program/job/contour-rows.ts";
import type { ContourRow } from "../../program/job/job.ts";
import { UNDERCUT_FORMS } from "../../kernel/contour/undercut.ts";
import { nameOfUndercut, readUndercutName, undercutsNamed } from "../../program/job/undercut-name.ts";
import { undercutPlace } from "../../program/job/undercut-place.ts";
import type { ElementMark } from "../types.ts";
import { middleRows } from "./middle-rows.ts";
import type { Links } from "./chain-links.ts";
import type { FinishedPart, RowMark } from "./finished-part.ts";
import { partProblem, type PartProblem, type PartSide } from "./part-problem.ts";

/** Rows of undercuts with the form and the words of their designation; typed words stay. */
export function withUndercuts(
  part: FinishedPart,
  rows: readonly ContourRow[],
  side: PartSide,
  problems: PartProblem[],
): readonly ContourRow[] {
  if (!rows.some((row) => row.kind === "UDC" && part.marks[row.id]?.undercut !== undefined)) return rows;
  const reading = readRows(rows);
  return rows.map((row, i) => {
    const name = row.kind === "UDC" ? part.marks[row.id]?.undercut : undefined;
    if (name === undefined) return row;
    const place = undercutPlace(reading.rows, i),
      pitch = pitchBeside(part, rows, i);
    const udc = undercutsNamed(name, place && { ...place, ...(pitch !== null && { pitch }) }).sizes[0]?.udc;
    if (!udc) {
      problems.push(partProblem("undercutName", { text: name }, { side, row: row.id }));
      return row;
    }
    const words = Object.fromEntries(Object.entries(udc.words).map(([word, n]) => [word, String(n)]));
    return { ...row, form: udc.form, words: { ...words, ...row.words } };
  });
}

/** The pitch of a thread on the element before or behind a row, mm. */
function pitchBeside({ marks }: FinishedPart, rows: readonly ContourRow[], index: number): number | null {
  const isElement = ({ kind }: ContourRow) => kind !== "RND" && kind !== "CHF" && kind !== "UDC" && kind !== "GRV";
  const beside = [rows.slice(0, index).findLast(isElement), rows.slice(index + 1).find(isElement)];
  const [thread] = beside.flatMap((row) => (row && marks[row.id]?.thread) ?? []);
  return thread === undefined ? null : (readThread(thread)?.pitch ?? null);
}

/** The designation of a row of kind UDC, typed or found by its words. */
function undercutOf(row: ContourRow, mark: RowMark | undefined): string | undefined {
  if (row.kind !== "UDC" || mark?.undercut !== undefined) return mark?.undercut;
  const form = UNDERCUT_FORMS.find((f) => f === row.form) ?? "E";
  const words = Object.fromEntries(
    Object.entries(row.words).map(([word, text]) => [word, Number(text.replace(",", "."))]),
  );
  return nameOfUndercut(form, words, null)?.name ?? form;
}

/** A thread needs a cylinder or a cone, a tolerance a cylinder or a face. */
function problemsOfMark(
  { thread, undercut }: RowMark,
  row: ContourRow,
  isStraight: boolean,
  side: PartSide,
): readonly PartProblem[] {
  const place = { side, row: row.id } as const,
    found: PartProblem[] = [];
  if (thread !== undefined && !readThread(thread)) found.push(partProblem("threadName", { text: thread }, place));
  else if (thread !== undefined && !isStraight) found.push(partProblem("threadPlace", { text: thread }, place));
  if (undercut !== undefined && row.kind !== "UDC" && !readUndercutName(undercut))
    found.push(partProblem("undercutName", { text: undercut }, place));
  return found;
}

/** The elements of a side in the order of its rows, each with its mark. */
export function markedRows(
  part: FinishedPart,
  side: "outside" | "inside",
): { readonly links: Links; readonly problems: readonly PartProblem[] } {
  const problems: PartProblem[] = [];
  const rows = withUndercuts(part, middleRows(part, side, problems), side, problems);
  if (rows.length === 0) return { links: [], problems };
  const { contour, rowOfSegment, issues } = readRows(rows);
  problems.push(
    ...issues.flatMap(({ row, issue }): readonly PartProblem[] =>
      issue.severity === "info"
        ? []
        : [{ code: "row", severity: issue.severity, side, row: rows[row]?.id ?? "", issue }],
    ),
  );
  const marks = rows.map((row): ElementMark => {
    const own = part.marks[row.id],
      undercut = undercutOf(row, own);
    return {
      row: row.id,
      ...(own?.ra !== undefined && { roughness: own.ra }),
      ...(own?.rz !== undefined && { rz: own.rz }),
      ...(own?.thread !== undefined && { thread: own.thread }),
      ...(undercut !== undefined && { undercut }),
      ...(own?.tolerance !== undefined && { tolerance: own.tolerance }),
    };
  });
  const links = contour.segments.map((segment, i) => ({
    segment,
    mark: marks[rowOfSegment[i] ?? 0] ?? { row: "" },
  }));
  for (const row of rows) {
    const own = part.marks[row.id];
    const isStraight = links.some(
      ({ segment: s, mark }) =>
        mark.row === row.id && s.kind === "line" && Math.abs(s.from.z - s.to.z) > SAME && space.lengthOf(s) > SAME,
    );
    if (own) problems.push(...problemsOfMark(own, row, isStraight, side));
  }
  return { links, problems };
}
