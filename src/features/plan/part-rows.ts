import type { FinishedPart, RowMark } from "../../planning/part/finished-part.ts";
import { withUndercuts } from "../../planning/part/marked-rows.ts";
import type { ContourRow } from "../../program/job/job.ts";

/** The two contours of a part that are typed. */
export const SIDES = ["outside", "inside"] as const;
export type Side = (typeof SIDES)[number];

/*
 * Marks name rows of both contours, so their ids differ: e1 outside, i1 in the bore. A contour table counts its own rows
 * as e1, e2 …
 */
const LETTER: Readonly<Record<Side, string>> = { outside: "e", inside: "i" };
const TABLE = "e";

const renamed = (rows: readonly ContourRow[], from: string, to: string): readonly ContourRow[] =>
  from === to ? rows : rows.map((row) => (row.id.startsWith(from) ? { ...row, id: to + row.id.slice(1) } : row));

/** The id in the contour table of a row of the part. */
export const tableId = (id: string): string => TABLE + id.slice(1);

/** The rows of a contour for its table. */
export const tableRows = (part: FinishedPart, side: Side): readonly ContourRow[] =>
  renamed(part[side], LETTER[side], TABLE);

/** A part with only the marks of its rows. */
function withKnownMarks(part: FinishedPart): FinishedPart {
  const known = new Set([...part.outside, ...part.inside].map(({ id }) => id));
  const marks = Object.entries(part.marks);
  return marks.every(([id]) => known.has(id))
    ? part
    : { ...part, marks: Object.fromEntries(marks.filter(([id]) => known.has(id))) };
}

/** The part with the rows of a contour table. */
export const withTableRows = (part: FinishedPart, side: Side, rows: readonly ContourRow[]): FinishedPart =>
  withKnownMarks({ ...part, [side]: renamed(rows, TABLE, LETTER[side]) });

/** The part with a mark changed; empty members are removed. */
export function withMark(
  part: FinishedPart,
  row: string,
  change: Partial<Record<keyof RowMark, unknown>>,
): FinishedPart {
  const { [row]: before, ...others } = part.marks;
  const mark = Object.fromEntries(
    Object.entries({ ...before, ...change }).filter(([, value]) => value !== undefined && value !== ""),
  ) as RowMark;
  return { ...part, marks: Object.keys(mark).length > 0 ? { ...others, [row]: mark } : others };
}

/**
 * A part from elsewhere with rows named as here. An undercut gets the form and the words of its designation, so that
 * the contour table shows and changes it.
 */
export function adopted(part: FinishedPart): FinishedPart {
  const named = new Map<string, string>();
  const sides = Object.fromEntries(
    SIDES.map((side) => [
      side,
      withUndercuts(part, part[side], side, []).map((row, i) => {
        const id = `${LETTER[side]}${i + 1}`;
        named.set(row.id, id);
        return { ...row, id };
      }),
    ]),
  ) as unknown as Pick<FinishedPart, Side>;
  const isResolved = (id: string) =>
    [...sides.outside, ...sides.inside].some((row) => row.id === id && row.kind === "UDC" && row.form !== "");
  const marks = Object.entries(part.marks).flatMap(([old, { undercut, ...mark }]) => {
    const id = named.get(old);
    if (id === undefined) return [];
    const own = undercut !== undefined && !isResolved(id) ? { ...mark, undercut } : mark;
    return Object.keys(own).length > 0 ? [[id, own] as const] : [];
  });
  return { ...part, ...sides, marks: Object.fromEntries(marks) };
}
