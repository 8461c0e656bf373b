import { part } from "../../kernel/geometry/point.ts";
import { signOf } from "../../kernel/geometry/segments.ts";
import type { Segment } from "../../kernel/geometry/point.ts";
import type { Edge } from "./graph.ts";

/** An edge with a direction: even numbers run as the edge, odd ones against it. */
export type Way = number;
export const turned = (way: Way): Way => way ^ 1;
export const edgeIndex = (way: Way): number => way >> 1;

/** The edges of a connected drawing, with what lies to the left of each of their directions. */
export interface Faces {
  readonly edges: readonly Edge[];
  /** Each face as the ways around it, the face to the left: bounded ones counter-clockwise. */
  readonly faces: readonly (readonly Way[])[];
  readonly faceOf: readonly number[];
  /** Index of the face outside of everything. */
  readonly outer: number;
  readonly area: readonly number[];
}

export const startNode = (edges: readonly Edge[], way: Way): number => {
  const e = edges[edgeIndex(way)];
  return (way & 1 ? e?.to : e?.from) ?? -1;
};
export const endNode = (edges: readonly Edge[], way: Way): number => startNode(edges, turned(way));
export function segmentAlong(edges: readonly Edge[], way: Way): Segment | null {
  const s = edges[edgeIndex(way)]?.segment;
  return s ? (way & 1 ? part.reversed(s) : s) : null;
}

/** Area between a segment and the origin, positive counter-clockwise. */
function areaOf(s: Segment): number {
  const chord = part.cross(s.from, s.to) / 2;
  if (s.kind === "line") return chord;
  const sweep = part.sweepOf(s);
  return chord + (signOf(s.turn) * part.radiusOf(s) ** 2 * (sweep - Math.sin(sweep))) / 2;
}

/** Ways that leave each node, counter-clockwise: by their directions a little away from it, which also tells bends. */
function fansOf(edges: readonly Edge[]): Map<number, Way[]> {
  const fans = new Map<number, Way[]>();
  edges.forEach((_, i) => {
    for (const way of [2 * i, 2 * i + 1]) {
      const node = startNode(edges, way),
        fan = fans.get(node);
      if (fan) fan.push(way);
      else fans.set(node, [way]);
    }
  });
  for (const [node, fan] of fans) {
    if (fan.length < 3) continue;
    const segments = fan.map((way) => segmentAlong(edges, way)),
      step = segments.reduce((least, s) => Math.min(least, s ? part.lengthOf(s) : least), Infinity) / 2;
    const angles = new Map<Way, number>();
    fan.forEach((way, i) => {
      const s = segments[i];
      if (s) angles.set(way, part.angleOf(part.difference(part.pointOn(s, step / part.lengthOf(s)), s.from)));
    });
    fans.set(
      node,
      fan.toSorted((a, b) => (angles.get(a) ?? 0) - (angles.get(b) ?? 0)),
    );
  }
  return fans;
}

/** Faces of connected edges. */
export function facesOf(edges: readonly Edge[]): Faces {
  const fans = fansOf(edges),
    next: Way[] = [];
  for (const fan of fans.values())
    fan.forEach((way, i) => {
      next[turned(way)] = fan[(i + fan.length - 1) % fan.length] ?? way;
    });
  const faceOf: number[] = [],
    faces: Way[][] = [],
    area: number[] = [];
  for (let first = 0; first < 2 * edges.length; first += 1) {
    if (faceOf[first] !== undefined) continue;
    const face: Way[] = [];
    let sum = 0;
    for (let way = first; faceOf[way] === undefined; way = next[way] ?? first) {
      faceOf[way] = faces.length;
      face.push(way);
      const s = segmentAlong(edges, way);
      if (s) sum += areaOf(s);
    }
    faces.push(face);
    area.push(sum);
  }
  const outer = area.reduce((least, a, i) => (a < (area[least] ?? 0) ? i : least), 0);
  return { edges, faces, faceOf, outer, area };
}
