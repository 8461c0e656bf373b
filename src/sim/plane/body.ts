import { boxAround, type Cuboid } from "../../kernel/area/box.ts";
import { intersection } from "../../kernel/area/clip.ts";
import { partPoint, plane } from "../../kernel/plane/plane.ts";
import { at, type Ring } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import type { BodyHeights } from "./depths.ts";

/**
 * A milled body, seen from above. Areas of the plane are rings as elsewhere (z of a point is X here, r is Y). With both
 * fields set, the body is their intersection: a block that was turned.
 */
export interface MilledBody {
  readonly block: Cuboid | null;
  /** The half section of a body round the axis X0 Y0. */
  readonly turned: readonly Ring[] | null;
}

/** Chord error of round tools and round blanks, mm: finer than the picture shows. */
export const PLANE_CHORD = 0.005;

/** A circle round X0 Y0 as a counter-clockwise ring. */
export function roundRing(radius: number, chord = PLANE_CHORD): Ring {
  const start = { x: radius, y: 0 };
  const arc = { kind: "arc", from: start, to: start, centre: { x: 0, y: 0 }, turn: "ccw" } as const;
  return plane.flattened(arc, chord).slice(1).map(partPoint);
}

/** Higher than anything on a machine, mm. */
const HIGH = 1e5;

/** The radius ranges in which a turned body has material above a height, joined and in order. */
function spansAbove(section: readonly Ring[], height: number): readonly (readonly [number, number])[] {
  const above =
    height === -Infinity
      ? section
      : intersection(section, [[at(height, -HIGH), at(HIGH, -HIGH), at(HIGH, HIGH), at(height, HIGH)]]);
  const spans = above
    .map((ring) => {
      const { low, high } = boxAround([ring]);
      return [Math.max(0, low), high] as const;
    })
    .sort(([a], [b]) => a - b);
  const joined: [number, number][] = [];
  for (const [from, to] of spans) {
    const last = joined.at(-1);
    if (last && from <= last[1] + SAME) last[1] = Math.max(last[1], to);
    else joined.push([from, to]);
  }
  return joined.filter(([from, to]) => to - from > SAME);
}

function roundsAbove(section: readonly Ring[], height: number): Ring[] {
  return spansAbove(section, height).flatMap(([from, to]) => {
    const outer = roundRing(to);
    return from > SAME ? [outer, roundRing(from).toReversed()] : [outer];
  });
}

/** The area in which a body reaches above a height, mm; -Infinity: the whole body. */
export function standingAbove({ block, turned }: MilledBody, height: number): Ring[] {
  const rounds = turned && roundsAbove(turned, height);
  if (!block) return rounds ?? [];
  if (block.top <= height) return [];
  const { left, right, low, high } = block;
  const side: Ring = [at(left, low), at(right, low), at(right, high), at(left, high)];
  return rounds ? intersection(rounds, [side]) : [side];
}

/**
 * The heights of upward faces of a section, mm: the segments of its outline that run outwards, with material on the
 * left.
 */
const facesOf = (section: readonly Ring[]): readonly number[] =>
  section.flatMap((ring) =>
    ring.flatMap((to, i) => {
      const from = ring[(i + ring.length - 1) % ring.length];
      return from && Math.abs(from.z - to.z) <= SAME && to.r - from.r > SAME ? [to.z] : [];
    }),
  );

/** Bottom, top and flat shoulders of a body; null without a body. */
export function heightsOf(body: MilledBody): BodyHeights | null {
  const { block, turned } = body,
    section = turned && turned.length > 0 ? boxAround(turned) : null;
  if (!block && !section) return null;
  const bottom = Math.max(block?.bottom ?? -Infinity, section?.left ?? -Infinity);
  const top = Math.min(block?.top ?? Infinity, section?.right ?? Infinity);
  const shoulders = facesOf(turned ?? []).filter((z) => z < top - SAME && z > bottom + SAME);
  return top > bottom ? { bottom, top, shoulders } : null;
}
