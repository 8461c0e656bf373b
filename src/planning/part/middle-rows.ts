import { toleranceMiddle } from "../../kernel/fit/typed-tolerance.ts";
import { cutThread, type NamedThread } from "../../kernel/thread/named-thread.ts";
import { readThread } from "../../kernel/thread/threads.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { radians, radiusOf } from "../../kernel/units.ts";
import { readRows, type RowReading } from "../../program/job/contour-rows.ts";
import type { ContourRow } from "../../program/job/job.ts";
import { coreOf, hasTap } from "../../program/tools/tap-of-thread.ts";
import type { FinishedPart, RowMark } from "./finished-part.ts";
import { partProblem, type PartProblem } from "./part-problem.ts";

type Side = "outside" | "inside";

/** A coordinate as text, finer than the resolution of a control. */
const text = (n: number) => String(Number(n.toFixed(6)) || 0);

/** End of an element, X as ⌀. */
interface End {
  x: number;
  z: number;
}
/** Ends of the elements; null for corners, recesses and centres. */
type Ends = readonly (End | null)[];
type IsLine = (row: number) => boolean;

/** A row whose end is absolute: nothing of it is solved any more, so that the end may be moved. */
function plain(row: ContourRow, { radius, turn }: RowReading, end: End): ContourRow {
  const at = { x: text(end.x), z: text(end.z), incrementalX: false, incrementalZ: false };
  const bare = { ...row, ...at, angle: "", length: "", tangent: false, second: false, words: {} };
  return radius === null || turn === null
    ? { ...bare, kind: "L", r: "" }
    : { ...bare, kind: "CR", r: text(radius), turn };
}

/** The middle of a size, ⌀ or length from Z0; null where the text has none for it. */
const middleOf = (tolerance: string, size: number) => toleranceMiddle(tolerance, size)?.middle ?? null;

/**
 * The crest of a cylinder that a thread is cut into, mm: the drill before a tap, else the middle of its class; null where
 * it varies.
 */
function crestOf(thread: NamedThread, side: Side): number | null {
  const own = thread[side];
  if (!own || thread.taper !== 0) return null;
  return (side === "inside" && hasTap(thread) ? coreOf(thread)?.size : null) ?? cutThread(own, "middle").crest;
}

/** Slopes of lines that keep their angle when a cylinder beside them moves: chamfers and flanks, not tapers. */
const [LEAST_SLOPE, MOST_SLOPE] = [Math.tan(radians(15)), Math.tan(radians(75))];

/** Distance along Z by which the end of a chamfer moves when its cylinder moves by `by` (⌀), mm; 0 for other elements. */
function slide(end: End | null | undefined, other: End | null | undefined, isLine: boolean, by: number): number {
  if (!end || !other || !isLine) return 0;
  const [across, along] = [end.x - other.x, end.z - other.z],
    slope = Math.abs(radiusOf(across) / along);
  return slope > LEAST_SLOPE && slope < MOST_SLOPE ? (by * along) / across : 0;
}

/**
 * Moves the ends of a run of elements that share a coordinate: a cylinder in several rows stays a cylinder. `isLine`: of
 * the element that ends at an index.
 */
function moveRun(ends: Ends, axis: "x" | "z", [from, to]: readonly [number, number], by: number, isLine: IsLine): void {
  const now = ends[to]?.[axis] ?? 0,
    isSame = (i: number) => {
      const end = ends[i];
      return end === null || (end !== undefined && Math.abs(end[axis] - now) <= SAME);
    };
  let [first, last] = [from, to];
  while (first > 0 && isSame(first - 1)) first -= 1;
  while (last + 1 < ends.length && isSame(last + 1)) last += 1;
  const run = ends.slice(first, last + 1).filter((end) => end !== null),
    [begin, end] = [run[0], run.at(-1)];
  if (axis === "x" && begin && end) {
    const begins = ends.indexOf(begin),
      [before, after] = [
        slide(begin, ends[first - 1], isLine(begins), by),
        slide(end, ends[last + 1], isLine(last + 1), by),
      ];
    if (Math.abs(before) + Math.abs(after) < Math.abs(begin.z - end.z)) {
      begin.z += before;
      end.z += after;
    }
  }
  for (const each of run) each[axis] += by;
}

/** The breadth of a recess in the middle of its tolerance. */
function middleBreadth(row: ContourRow, tolerance: string): ContourRow | null {
  const middle = middleOf(tolerance, Number((row.words["BREADTH"] ?? "").replace(",", ".")));
  return middle === null ? null : { ...row, words: { ...row.words, BREADTH: text(middle) } };
}

/**
 * Rows of a side with sizes in the middle of their tolerances: ⌀ of a cylinder with its edges, position of a face,
 * breadth of a recess, and the cylinder of a thread at its crest. What has no middle is a problem.
 */
export function middleRows(
  { marks, ...part }: FinishedPart,
  side: Side,
  problems: PartProblem[],
): readonly ContourRow[] {
  const rows = part[side];
  const isSized = ({ tolerance, thread }: RowMark = {}) => tolerance !== undefined || thread !== undefined;
  if (!rows.some((row) => isSized(marks[row.id]))) return rows;
  const reading = readRows(rows);
  const ends: Ends = reading.rows.map(({ end }) => (end ? { ...end } : null));
  const isLine = (i: number) => reading.rows[i]?.radius === null;
  const isCentre = (i: number) => rows[i]?.kind === "CC";
  const isOpen = rows.some(({ kind }, i) => !ends[i] && !["RND", "CHF", "UDC", "GRV", "CC"].includes(kind));
  // The rows are not finished: their own issues say so.
  if (isOpen) return rows;
  const recesses = new Map<number, ContourRow>();
  for (const [i, row] of rows.entries()) {
    const { tolerance, thread } = marks[row.id] ?? {},
      place = { severity: "warning", side, row: row.id } as const;
    const named = thread === undefined ? null : readThread(thread);
    if (tolerance === undefined && !named) continue;
    const before = ends.slice(0, i).findLastIndex((end) => end !== null),
      [from, to] = [ends[before], ends[i]];
    if (tolerance !== undefined && row.kind === "GRV") {
      const changed = middleBreadth(row, tolerance);
      if (changed) recesses.set(i, changed);
      else problems.push(partProblem("toleranceText", { text: tolerance }, place));
      continue;
    }
    const axis = from && to && (["x", "z"] as const).find((each) => Math.abs(from[each] - to[each]) <= SAME);
    if (!to || !axis || !isLine(i)) {
      if (tolerance !== undefined) problems.push(partProblem("tolerancePlace", { text: tolerance }, place));
      continue;
    }
    if (named && axis === "x") {
      const crest = crestOf(named, side);
      const isDrawn =
        crest !== null &&
        [named.nominal, crest, named[side]?.crest ?? crest].some((x) => Math.abs(x - to.x) <= named.pitch / 4);
      if (isDrawn) moveRun(ends, "x", [before, i], crest - to.x, isLine);
      else if (crest !== null) problems.push(partProblem("threadSize", { text: thread ?? "", x: to.x, crest }, place));
    } else if (tolerance !== undefined) {
      const size = axis === "x" ? to.x : Math.abs(to.z),
        middle = middleOf(tolerance, size);
      if (middle === null) problems.push(partProblem("toleranceText", { text: tolerance }, place));
      else moveRun(ends, axis, [before, i], (middle - size) * (axis === "z" && to.z < 0 ? -1 : 1), isLine);
    }
  }
  return rows.flatMap((row, i) => {
    const [end, read] = [ends[i], reading.rows[i]];
    if (isCentre(i)) return [];
    return end && read ? [plain(row, read, end)] : [recesses.get(i) ?? row];
  });
}
