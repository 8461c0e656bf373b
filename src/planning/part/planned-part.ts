import { areaOf } from "../../kernel/area/area.ts";
import { boxAround } from "../../kernel/area/box.ts";
import { clampingBodies, type Clamped } from "../../kernel/area/clamping.ts";
import { difference, union } from "../../kernel/area/clip.ts";
import { selfCrossing } from "../../kernel/contour/crossing.ts";
import { at, part as space, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { toDiameter } from "../../kernel/units.ts";
import type { PlannedPart } from "../types.ts";
import {
  chainOf,
  endedAt,
  firstPoint,
  joinedAtFront,
  lastPoint,
  lineTo,
  orientedSides,
  pointsOf,
  reversed,
  segmentsOf,
  type Links,
} from "./chain-links.ts";
import type { FinishedPart } from "./finished-part.ts";
import { blankOfPart, clampingOfPart, holeOf } from "./part-blank.ts";
import { partProblem, type PartProblem } from "./part-problem.ts";
import { markedRows } from "./marked-rows.ts";

/** A part as the planner needs it; null with at least one error. */
export interface PlannedPartResult {
  readonly part: PlannedPart | null;
  /** The stock in the chuck, mm; empty where it is wrong. */
  readonly blank: readonly Ring[];
  readonly clamping: Clamped | null;
  readonly problems: readonly PartProblem[];
}

/** Smaller areas are rounding, mm² of the half section. */
const LEAST_AREA = 0.01;
/** A part that is larger than its blank by less is within the errors of chords, mm². */
const BEYOND = 0.05;
/** Past every part, mm. */
const PAST = 100;

const spot = (p: Pt) => ({ x: toDiameter(p.r), z: p.z });
const onAxisAt = ({ z }: Pt): Pt => at(z, 0);

/** Both sides of a part, joined at the front and ended at the rear. */
interface Sides {
  readonly outside: Links;
  readonly inside: Links;
  /** The outside has no rear end: the part goes on as the blank is. */
  readonly isOpen: boolean;
}

/** Whether an outside ends in a face that rises out of the part, as contours that end in the blank do. */
const endsInBlank = (outside: Links): boolean => {
  const s = outside.at(-1)?.segment;
  return s?.kind === "line" && Math.abs(s.from.z - s.to.z) <= SAME && s.to.r > s.from.r;
};

/** The outside from the axis on: a missing front face is added. */
function withFrontFace(outside: Links): Links {
  const [begin] = outside,
    first = firstPoint(outside);
  return begin && first && first.r > SAME ? [lineTo(onAxisAt(first), first, begin), ...outside] : outside;
}

/**
 * The bottom of a bore that ends in the solid: a missing one is added, down to the hole of the blank or to the axis. Of a
 * part that goes on as its blank is (`rearZ` −Infinity) the hole has no end.
 */
function withFloor(inside: Links, rearZ: number, hole: number): Links {
  const [end, last] = [inside.at(-1), lastPoint(inside)];
  if (!end || !last || last.r <= SAME || last.z <= rearZ + SAME) return inside;
  const floor = at(last.z, Math.min(hole, last.r)),
    links = last.r - floor.r > SAME ? [...inside, lineTo(last, floor, end)] : inside;
  return hole > SAME && rearZ > -Infinity ? [...links, lineTo(floor, at(rearZ, floor.r), end)] : links;
}

/** `hole`: radius of the hole of the blank, 0 where it is solid. */
function sidesOf(part: FinishedPart, hole: number, problems: PartProblem[]): Sides | null {
  const read = (side: "outside" | "inside") => {
    const { links, problems: found } = markedRows(part, side);
    problems.push(...found);
    return links;
  };
  const typed = { outside: read("outside"), inside: read("inside") };
  for (const side of ["outside", "inside"] as const) {
    const below = typed[side].find(({ segment }) => space.boxOf(segment).low < -SAME);
    if (below) problems.push(partProblem("belowAxis", spot(below.segment.to), { side, row: below.mark.row }));
  }
  if (problems.some((p) => p.severity === "error")) return null;
  const { outside: bare, inside: bore } = orientedSides(typed.outside, typed.inside, part.unmachinedBehind);
  const outside = withFrontFace(bare),
    [begin, end, first, last] = [outside[0], outside.at(-1), firstPoint(outside), lastPoint(outside)];
  if (!begin || !end || !first || !last) {
    problems.push(partProblem("noOutside", {}));
    return null;
  }
  const isOpen = part.unmachinedBehind || (!part.partsOff && endsInBlank(bare));
  // A part made of a tube without a word on its bore has that of the tube.
  const own = bore.length === 0 && hole > 0 ? [lineTo(at(first.z, hole), at(last.z, hole), begin)] : bore;
  if (own.length === 0) return { outside, inside: [], isOpen };
  const joined = joinedAtFront(outside, own);
  const from = firstPoint(own) ?? first;
  if (!joined) {
    problems.push(partProblem("openFront", spot(from), { side: "inside", ...(own[0] && { row: own[0].mark.row }) }));
    return null;
  }
  const rear = isOpen ? -Infinity : last.z;
  const ended = isOpen ? joined.inside : endedAt(joined.inside, lineTo(last, onAxisAt(last), end));
  return { outside: joined.outside, inside: withFloor(ended, rear, hole), isOpen };
}

/** The closed half section of both sides. */
function ringOf({ outside, inside }: Sides): Ring {
  const [outer, inner] = [pointsOf(outside), pointsOf(reversed(inside))],
    last = lastPoint(outside);
  const isThrough = inside.length > 0 && (lastPoint(inside)?.r ?? 0) > SAME;
  return last && !isThrough && last.r > SAME ? [...outer, onAxisAt(last), ...inner] : [...outer, ...inner];
}

/** What remains of a blank in front of the ends of both sides; behind them it is as it was. */
function remaining({ outside, inside }: Sides, blank: readonly Ring[]): readonly Ring[] {
  const [outer, inner] = [pointsOf(outside), pointsOf(inside)],
    { right, high } = boxAround([...blank, outer]),
    far = Math.max(right, high) + PAST;
  const [first, last, begin, bottom] = [outer[0], outer.at(-1), inner[0], inner.at(-1)];
  if (!first || !last) return [];
  const gone: Ring[] = [[...outer, at(last.z, far), at(far, far), at(far, 0), onAxisAt(first)]];
  if (begin && bottom) gone.push([...inner, onAxisAt(bottom), at(far, 0), at(far, begin.r)]);
  const solid = gone.flatMap((ring) => union([areaOf([ring]) < 0 ? ring.toReversed() : ring]));
  return difference(blank, solid);
}

/** Where the outline of a part crosses itself; null where it does not. */
function crossingOf({ outside, inside, isOpen }: Sides): PartProblem | null {
  const last = lastPoint(outside),
    end = outside.at(-1),
    to = lastPoint(inside);
  if (!last || !end) return null;
  const isThrough = inside.length === 0 || (to && (to.r <= SAME || Math.abs(to.z - last.z) <= SAME)),
    rear = !isOpen && isThrough && last.r > SAME ? [lineTo(last, to && to.r > SAME ? to : onAxisAt(last), end)] : [];
  const loop = [...outside, ...rear, ...reversed(inside)],
    found = selfCrossing(segmentsOf(loop));
  const [late, early] = found ? [loop[found[0]], loop[found[1]]] : [];
  if (!late || !early) return null;
  const on = (p: Pt) => [late, early].every((l) => space.distanceTo(l.segment, p) <= SAME);
  const p = space.meetings(late.segment, early.segment).find(on) ?? late.segment.from;
  const isBore = inside.some((l) => l.mark.row === late.mark.row) && !inside.some((l) => l.mark.row === early.mark.row);
  return partProblem(isBore ? "boreOutside" : "crosses", spot(p), {
    side: isBore ? "inside" : "outside",
    row: late.mark.row,
  });
}

/**
 * A finished part as geometry: both sides from the front face to the rear with the marks of their elements, the closed
 * half section, its blank and its clamping. Contours may run from either end, with or without their faces; a bore may be
 * part of a closed outline. Never throws.
 */
export function plannedPart(part: FinishedPart): PlannedPartResult {
  const problems: PartProblem[] = [];
  const stated = blankOfPart(part, null, problems);
  const none = (blank: readonly Ring[] = []): PlannedPartResult => ({ part: null, blank, clamping: null, problems });
  const sides = sidesOf(part, holeOf(part, stated), problems);
  if (!sides) return none(stated ?? []);
  const ring = ringOf(sides),
    crossing = crossingOf(sides);
  if (crossing) problems.push(crossing);
  const blank = stated ?? blankOfPart({ ...part, unmachinedBehind: sides.isOpen }, boxAround([ring]), problems) ?? [],
    rings = sides.isOpen ? remaining(sides, blank) : [ring];
  if (!crossing && areaOf(rings) < LEAST_AREA)
    problems.push(
      sides.inside.length > 0
        ? partProblem("boreOutside", spot(firstPoint(sides.inside) ?? at(0, 0)), { side: "inside" })
        : partProblem("noArea", {}),
    );
  if (problems.some((p) => p.severity === "error")) return none(blank);
  const front = boxAround([ring]).right;
  if (Math.abs(front) > SAME) problems.push(partProblem("front", { z: front }, { severity: "warning" }));
  const beyond = blank.length > 0 ? areaOf(difference([ring], blank)) : 0;
  if (beyond > BEYOND) problems.push(partProblem("beyondBlank", { area: beyond }, { severity: "warning" }));
  const clamping = clampingOfPart(part, problems),
    { ra, rz } = part.general,
    general = { ...(ra !== undefined && { roughness: ra }), ...(rz !== undefined && { rz }) };
  return {
    part: { name: part.name, outside: chainOf(sides.outside, general), inside: chainOf(sides.inside, general), rings },
    blank,
    clamping: clamping && { clamping, bodies: clampingBodies(clamping, blank) },
    problems,
  };
}
