import { areaOf } from "../kernel/area/area.ts";
import { boxAround } from "../kernel/area/box.ts";
import { part as space, type Ring, type Segment } from "../kernel/geometry/point.ts";
import { SAME } from "../kernel/tolerance.ts";
import { diameter, toRadius } from "../kernel/units.ts";
import { newPart, type FinishedPart, type RowMark } from "../planning/part/finished-part.ts";
import { rowsOfSides } from "../planning/part/part-rows.ts";
import { readRows } from "../program/job/contour-rows.ts";
import { cylinderAround, rowsOf } from "../program/job/requested-shape.ts";
import type { ContourRow } from "../program/job/job.ts";
import type { DrawnTask } from "./drawn-task.ts";

/** A place on a drawing belongs to an element that is this near, mm. */
const NEAR = 0.02;
/** Smaller areas are rounding, mm² of the half section. */
const LEAST_AREA = 0.01;

const closed = (ring: Ring): readonly Segment[] => ring.map((p, i) => space.line(p, ring[(i + 1) % ring.length] ?? p));

/** A row with the elements that it makes. */
interface Element {
  readonly row: string;
  readonly segment: Segment;
}

const elementsOf = (rows: readonly ContourRow[]): readonly Element[] => {
  const { contour, rowOfSegment } = readRows(rows);
  return contour.segments.map((segment, i) => ({ segment, row: rows[rowOfSegment[i] ?? 0]?.id ?? "" }));
};

const isCylinder = ({ from, to }: Segment) => Math.abs(from.r - to.r) <= SAME;
const isFace = ({ from, to }: Segment) => Math.abs(from.z - to.z) <= SAME;
const spans = (a: number, b: number, p: number) => p >= Math.min(a, b) - NEAR && p <= Math.max(a, b) + NEAR;

/** Deviations as typed: "+0.025/0". */
const signed = (n: number) => (n > 0 ? `+${n}` : String(n));

type Marked = Readonly<Record<string, RowMark>>;

function marksOf({ threads, sizes, marks }: DrawnTask, sides: Pick<FinishedPart, "outside" | "inside">): Marked {
  const [outside, inside] = [elementsOf(sides.outside), elementsOf(sides.inside)],
    all = [...outside, ...inside];
  const found: Record<string, RowMark> = {};
  const mark = (element: Element | undefined, given: RowMark) => {
    if (element) found[element.row] = { ...found[element.row], ...given };
  };
  for (const { from, to, name } of threads) {
    const middle = space.pointOn(space.line(from, to), 1 / 2);
    mark(
      all.find(({ segment }) => !isFace(segment) && space.distanceTo(segment, middle) <= NEAR),
      { thread: name.replace("×", "x") },
    );
  }
  for (const { kind, at: place, nominal, upper, lower } of sizes) {
    const r = toRadius(diameter(kind === "face" ? place : nominal));
    const onFace = ({ segment: s }: Element) =>
      isFace(s) && Math.abs(s.from.z - nominal) <= NEAR && spans(s.from.r, s.to.r, r);
    const onCylinder = ({ segment: s }: Element) =>
      isCylinder(s) && Math.abs(s.from.r - r) <= NEAR && spans(s.from.z, s.to.z, place);
    // Deviations of a face are along Z; a tolerance counts from Z0 into the part.
    const tolerance =
      kind === "face" && nominal <= 0 ? `${signed(-lower)}/${signed(-upper)}` : `${signed(upper)}/${signed(lower)}`;
    const among = kind === "diameter" ? outside : kind === "bore" ? inside : all;
    if (kind !== "face" || nominal < 0) mark(among.find(kind === "face" ? onFace : onCylinder), { tolerance });
  }
  for (const { from, to, most } of marks)
    for (const element of all)
      if (!isFace(element.segment) && [element.segment.from.z, element.segment.to.z].every((z) => spans(from, to, z)))
        mark(element, { rz: most });
  return found;
}

/** A blank as a cylinder; of any other shape as the rows of its outline. */
function blankOf(rings: readonly Ring[]): FinishedPart["blank"] {
  const { left, right, low, high } = boxAround(rings);
  if (Math.abs((right - left) * (high - low) - areaOf(rings)) < LEAST_AREA) return cylinderAround(rings);
  const outline = rings.slice(0, 1).flatMap((ring) => rowsOf(closed(ring)));
  return { outline: outline.map((row, i) => ({ ...row, id: `b${i + 1}` })) };
}

/** An outside that ends where a thread on the unmachined blank begins goes on along the thread. */
function withBlankThreads({ outside, threads }: DrawnTask): readonly Segment[] {
  const end = outside.at(-1)?.to;
  const on = threads.find(({ from, to }) => end && Math.abs(from.r - end.r) <= NEAR && to.z < end.z - NEAR);
  return end && on ? [...outside, space.line(end, on.to)] : outside;
}

/**
 * The finished part of a workshop drawing, of an exercise or of a program: its outlines with threads, sizes and surface
 * marks. Behind the end of its outline a part stays as the blank is, unless it was parted off. Null without an outline.
 */
export function partOfDrawn(
  drawn: DrawnTask,
  { name, material }: { readonly name: string; readonly material?: string },
): FinishedPart | null {
  const sides = rowsOfSides(withBlankThreads(drawn), drawn.bore);
  if (sides.outside.length < 2 || drawn.blank.length === 0) return null;
  const partsOff = boxAround(drawn.rings).left > boxAround(drawn.blank).left + SAME;
  return {
    ...newPart(name),
    ...(material !== undefined && { material }),
    ...sides,
    marks: marksOf(drawn, sides),
    blank: blankOf(drawn.blank),
    partsOff,
    unmachinedBehind: !partsOff,
  };
}
