import { areaOf } from "../../kernel/area/area.ts";
import { intersection } from "../../kernel/area/clip.ts";
import { holderOutlines } from "../../kernel/cutter/holder.ts";
import { insertOutline } from "../../kernel/cutter/insert.ts";
import { at, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import { CHORD, SAME } from "../../kernel/tolerance.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { toolBox } from "./drawing.ts";

/**
 * The upper edge of the work seen from the side, from left to right: the largest radius at each Z, 0 where there is no
 * work.
 */
export type Silhouette = readonly Pt[];

/** An edge of a section with its ends from left to right. */
type Edge = readonly [left: Pt, right: Pt];

const edgesOf = (rings: readonly Ring[]): Edge[] =>
  rings.flatMap((ring) =>
    ring.flatMap((p, i): Edge[] => {
      const q = ring[(i + 1) % ring.length] as Pt;
      if (Math.abs(p.z - q.z) <= SAME) return [];
      return [p.z < q.z ? [p, q] : [q, p]];
    }),
  );

const radiusAt = ([a, b]: Edge, z: number): number => a.r + ((b.r - a.r) * (z - a.z)) / (b.z - a.z);

/** The first of ascending numbers that is not less than a number. */
function firstFrom(ascending: readonly number[], least: number): number {
  let [low, high] = [0, ascending.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((ascending[middle] as number) < least) low = middle + 1;
    else high = middle;
  }
  return low;
}

/**
 * The silhouette of the work from the outlines of its section, which do not cross one another, mm; empty without work.
 */
export function silhouetteOf(rings: readonly Ring[]): Silhouette {
  const edges = edgesOf(rings),
    marks = [...new Set(edges.flatMap(([a, b]) => [a.z, b.z]))].sort((a, b) => a - b);
  const top: (Edge | null)[] = marks.slice(1).map(() => null),
    high = top.map(() => 0);
  // Outlines do not cross: between two corners the edge that is outermost in the middle is outermost everywhere.
  for (const edge of edges) {
    for (let i = firstFrom(marks, edge[0].z); (marks[i + 1] ?? Infinity) <= edge[1].z; i += 1) {
      const r = radiusAt(edge, ((marks[i] as number) + (marks[i + 1] as number)) / 2);
      if (r > (high[i] as number)) [top[i], high[i]] = [edge, r];
    }
  }
  const line: Pt[] = [];
  const add = (z: number, r: number) => {
    const last = line.at(-1);
    if (!last || Math.abs(last.z - z) > SAME || Math.abs(last.r - r) > SAME) line.push(at(z, r));
  };
  top.forEach((edge, i) => {
    for (const z of [marks[i] as number, marks[i + 1] as number]) add(z, edge ? radiusAt(edge, z) : 0);
  });
  return line;
}

/** A tool that only touches the work overlaps it by less than this, mm². */
const TOUCHED = 0.1;

/**
 * Whether part of a tool, with its tip at one of the places, is behind the work: nearer to the axis than the work's
 * edge there.
 */
export function liesBehind(tool: Tool, tips: readonly Pt[], silhouette: Silhouette): boolean {
  const [first, last] = [silhouette[0], silhouette.at(-1)],
    box = toolBox(tool);
  if (!first || !last || !box) return false;
  const outer = Math.max(...silhouette.map((p) => p.r));
  const reached = tips.filter((tip) => tip.z + box.left < last.z && tip.r + box.low < outer);
  if (reached.length === 0) return false;
  const under = [at(first.z, 0), at(last.z, 0), ...silhouette.toReversed()];
  const rings = [insertOutline(tool, CHORD), ...holderOutlines(tool)].filter((ring) => ring.length > 2);
  const shared = (tip: Pt) =>
    intersection(
      rings.map((ring) => ring.map((p) => at(p.z + tip.z, p.r + tip.r))),
      [under],
    );
  return reached.some((tip) => areaOf(shared(tip)) > TOUCHED);
}
