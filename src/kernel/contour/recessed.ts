import type { CornerElement } from "./corner.ts";
import { grooveShape, type Groove } from "./groove.ts";
import { issue, type Issue } from "../plan/issue.ts";
import { at, part, type Segment } from "../geometry/point.ts";
import { SAME } from "../tolerance.ts";
import { toDiameter } from "../units.ts";
import { neighboursOfPitch } from "./thread-relief.ts";
import { undercutShape, type Undercut } from "./undercut.ts";

const { lengthOf, line } = part;

/** Decimals of a standard value in the issue. */
const DECIMALS = 4;

/** An undercut or recess of a contour, its element number, and the segment that it was programmed behind. */
export interface PlacedRecess {
  readonly recess: Undercut | Groove;
  readonly element: number;
  readonly after: number;
}

/**
 * A contour under construction: corner i lies between segments i and i + 1; `segmentNumbers` and `cornerNumbers` are
 * elements.
 */
export interface ContourChain {
  readonly segments: Segment[];
  readonly corners: (CornerElement | null)[];
  readonly segmentNumbers: number[];
  readonly cornerNumbers: number[];
}

const tooLong = (element: number, size: number, max: number): Issue =>
  issue("cornerElementTooLong", "error", { element, size, max }, "contour");

/** Replaces `count` segments from `index`; `inner` are the corners between the new segments, all of one element. */
function replace(
  chain: ContourChain,
  index: number,
  count: number,
  parts: readonly Segment[],
  inner: readonly (CornerElement | null)[],
  element: number,
): void {
  const own = chain.segmentNumbers.slice(index, index + count);
  const numbers = parts.map((_, i) =>
    i === 0 ? (own[0] ?? element) : i === parts.length - 1 ? (own[own.length - 1] ?? element) : element,
  );
  chain.segments.splice(index, count, ...parts);
  chain.segmentNumbers.splice(index, count, ...numbers);
  chain.corners.splice(index, count - 1, ...inner);
  chain.cornerNumbers.splice(index, count - 1, ...inner.map(() => element));
}

const alongAxis = (s: Segment) => s.kind === "line" && Math.abs(s.to.r - s.from.r) <= SAME;
const alongFace = (s: Segment) => s.kind === "line" && Math.abs(s.to.z - s.from.z) <= SAME;

function putUndercut(chain: ContourChain, undercut: Undercut, element: number, index: number): Issue[] {
  const [one, two] = [chain.segments[index], chain.segments[index + 1]];
  const cylinderFirst = one !== undefined && alongAxis(one);
  const [cylinder, face] = cylinderFirst ? [one, two] : [two, one];
  if (!one || !two || !cylinder || !face || !alongAxis(cylinder) || !alongFace(face) || chain.corners[index])
    return [issue("undercutNeighbours", "error", { element }, "contour")];
  const corner = one.to;
  const [awayZ, awayR] = cylinderFirst
    ? [Math.sign(cylinder.from.z - corner.z), Math.sign(face.to.r - corner.r)]
    : [Math.sign(cylinder.to.z - corner.z), Math.sign(face.from.r - corner.r)];
  const shape = undercutShape(undercut, toDiameter(corner.r), awayR < 0);
  if ("word" in shape) return [issue("recessWord", "error", { element, word: shape.word }, "contour")];
  if ("pitch" in shape) {
    const words = shape.missing.join(" ");
    return [
      issue(
        "pitchNotListed",
        "error",
        { element, pitch: shape.pitch, words, ...neighboursOfPitch(shape.pitch) },
        "contour",
      ),
    ];
  }
  const [first, last] = [shape.vertices[0], shape.vertices[shape.vertices.length - 1]];
  const [broad, high] = [first?.u ?? 0, last?.v ?? 0];
  if (broad > lengthOf(cylinder) + SAME) return [tooLong(element, broad, lengthOf(cylinder))];
  if (high > lengthOf(face) + SAME) return [tooLong(element, high, lengthOf(face))];
  const deepest = Math.min(...shape.vertices.map((v) => v.v));
  if (corner.r + awayR * deepest < 0) return [issue("recessWord", "error", { element, word: "DEPTH" }, "contour")];
  const ordered = cylinderFirst ? shape.vertices : shape.vertices.toReversed();
  const points = ordered.map((v) => at(corner.z + awayZ * v.u, corner.r + awayR * v.v));
  const ends = [one.from, ...points, two.to];
  replace(
    chain,
    index,
    2,
    ends.slice(1).map((to, i) => line(ends[i] ?? to, to)),
    ordered.map((v) => v.corner),
    element,
  );
  const given = Object.entries(shape.defaults)
    .map(([word, n]) => `${word}${Number(n.toFixed(DECIMALS))}`)
    .join(" ");
  return given === "" ? [] : [issue("undercutDefaults", "info", { element, words: given }, "contour")];
}

function putGroove(chain: ContourChain, groove: Groove, element: number, index: number): Issue[] {
  const on = chain.segments[index];
  if (!on) return [issue("undercutNeighbours", "error", { element }, "contour")];
  const shape = grooveShape(groove, on);
  if (shape === "wrongElement") return [issue("undercutNeighbours", "error", { element }, "contour")];
  if ("other" in shape)
    return [issue("recessWordsExclusive", "error", { element, word: shape.word, other: shape.other }, "contour")];
  if ("word" in shape) return [issue("recessWord", "error", { element, word: shape.word }, "contour")];
  if ("breadth" in shape) return [tooLong(element, shape.breadth, shape.room)];
  const [signZ, signR] = [Math.sign(on.to.z - on.from.z), Math.sign(on.to.r - on.from.r)];
  const points = shape.vertices.map((v) =>
    groove.direction === "radial"
      ? at(on.from.z + signZ * v.along, on.from.r + v.across)
      : at(on.from.z + v.across, on.from.r + signR * v.along),
  );
  const ends = [on.from, ...points, on.to];
  replace(
    chain,
    index,
    1,
    ends.slice(1).map((to, i) => line(ends[i] ?? to, to)),
    shape.vertices.map((v) => v.corner),
    element,
  );
  return [];
}

/**
 * Distance of a recess along its segment, mm: the farthest is put in first, so that the positions of the others stay
 * valid.
 */
function place(chain: ContourChain, r: PlacedRecess): number {
  if (r.recess.kind === "undercut") return Infinity;
  const on = chain.segments[r.after];
  const centre = r.recess.words.CENTER ?? 0;
  return on ? Math.abs(r.recess.direction === "radial" ? centre - on.from.z : centre - on.from.r) : 0;
}

/** Puts undercuts and recesses into a chain; one that does not fit is left out and reported. */
export function putRecesses(chain: ContourChain, recesses: readonly PlacedRecess[]): Issue[] {
  const backwards = recesses
    .map((r) => ({ r, place: place(chain, r) }))
    .sort((a, b) => b.r.after - a.r.after || b.place - a.place);
  return backwards.flatMap(({ r }) =>
    r.recess.kind === "undercut"
      ? putUndercut(chain, r.recess, r.element, r.after)
      : putGroove(chain, r.recess, r.element, r.after),
  );
}
