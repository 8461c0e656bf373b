import type { Move } from "../../src/kernel/plan/move.ts";
import type { Tool } from "../../src/kernel/plan/tool.ts";
import { areaOf, common, crossed, filled, lengthOf, shrunk, without, type Field, type Grid } from "./field.ts";
import { connectedToRear } from "./clamped.ts";
import { hull, insertOf, type P } from "./insert.ts";

/*
 * A second stock simulation that shares no line with the first: it reads moves and tool columns, and cuts a blank made
 * of fine columns. The laws compare its results with those of `src/sim`.
 */

/** A motion of the tip, as in the simulation. */
export interface Motion {
  readonly from: P;
  readonly move: Move;
  readonly tool: Tool;
}

/** A fault in one motion, mm². Faults thinner than `THIN` or one column are ignored. */
export interface Fault {
  readonly kind: "gouge" | "rapid";
  readonly motion: number;
  readonly area: number;
}

export interface Verdict {
  readonly grid: Grid;
  readonly initial: Field;
  readonly final: Field;
  /** Area removed by all motions, and by the feeds, mm². */
  readonly removed: number;
  readonly cut: number;
  readonly faults: readonly Fault[];
  /** Whether the tool is in the blank before the first move. */
  readonly inside: boolean;
}

/** Chord error of arcs, mm; the depth in which both simulations may differ. */
const CHORD = 0.0005;
export const THIN = 0.006;

/** Positions of the tip along a move: its ends, and for an arc points in between. */
function stations(from: P, move: Move): P[] {
  if (move.kind !== "arc") return [from, move.to];
  const { centre, to } = move;
  const [a0, a1] = [Math.atan2(from.r - centre.r, from.z - centre.z), Math.atan2(to.r - centre.r, to.z - centre.z)];
  const [r0, r1] = [Math.hypot(from.r - centre.r, from.z - centre.z), Math.hypot(to.r - centre.r, to.z - centre.z)];
  const round = 2 * Math.PI;
  const turn = move.turn === "ccw" ? (((a1 - a0) % round) + round) % round : -((((a0 - a1) % round) + round) % round);
  const sweep = Math.hypot(to.z - from.z, to.r - from.r) < 1e-9 ? (move.turn === "ccw" ? round : -round) : turn;
  const count = Math.max(
    1,
    Math.ceil(Math.abs(sweep) / (2 * Math.acos(Math.max(0, 1 - CHORD / Math.max(r0, r1, CHORD))))),
  );
  return Array.from({ length: count + 1 }, (_, i) => {
    if (i === 0) return from;
    if (i === count) return to;
    const [a, r] = [a0 + (sweep * i) / count, r0 + ((r1 - r0) * i) / count];
    return { z: centre.z + r * Math.cos(a), r: centre.r + r * Math.sin(a) };
  });
}

const at = (shape: readonly P[], p: P): P[] => shape.map((q) => ({ z: q.z + p.z, r: q.r + p.r }));
/** The workpiece rotates: a sweep on the other side of the axis is mirrored. */
const both = (shape: P[]): P[][] =>
  shape.some((p) => p.r < 0) ? [shape, shape.map((p) => ({ z: p.z, r: -p.r })).reverse()] : [shape];

/** Positions of a thread's tip in the section plane: at every whole revolution, and where the tip stops. */
function meetings(from: P, move: Extract<Move, { kind: "thread" }>): P[] {
  const way = Math.abs(move.to[move.axis] - from[move.axis]);
  const out: P[] = [];
  for (let gone = (((360 - (move.angle % 360)) % 360) / 360) * move.pitch; gone < way - 1e-7; gone += move.pitch)
    out.push({ z: from.z + ((move.to.z - from.z) * gone) / way, r: from.r + ((move.to.r - from.r) * gone) / way });
  return move.stops ? [...out, move.to] : out;
}

/** Convex pieces swept by a motion. */
function swept({ from, move }: Motion, insert: readonly P[]): P[][] {
  if (move.kind === "thread") return meetings(from, move).flatMap((p) => both(at(insert, p)));
  const stops = stations(from, move);
  return stops.slice(1).flatMap((to, i) => both(hull([...at(insert, stops[i] as P), ...at(insert, to)])));
}

/** A grid of columns over rings, one column wider on both sides. */
export function gridOver(rings: readonly (readonly P[])[], along: Grid["along"], width: number): Grid {
  const all = rings.flatMap((ring) => ring.map((p) => p[along]));
  const [low, high] = [Math.min(...all), Math.max(...all)];
  // Off the round numbers at which walls are.
  const from = low - width * 1.37;
  return { along, width, from, count: Math.ceil((high - from) / width) + 1 };
}

/**
 * Cuts a blank by motions. `part`: the finished part as closed polygons, which must not be cut. `whole` marks the
 * motions that end a cut: after them only material connected to the rear end remains.
 */
export function judge(
  blank: readonly (readonly P[])[],
  motions: readonly Motion[],
  part: readonly (readonly P[])[],
  grid: Grid,
  whole: (motion: number) => boolean = () => false,
): Verdict {
  const initial = filled(grid, blank);
  const rear = Math.min(...blank.flat().map((p) => p.z));
  let stock: Field = [...initial];
  const kept = shrunk(filled(grid, part), THIN);
  const inserts = new Map<Tool, P[]>();
  const faults: Fault[] = [];
  let cut = 0;
  const insertFor = (tool: Tool) => {
    const known = inserts.get(tool) ?? insertOf(tool);
    inserts.set(tool, known);
    return known;
  };
  const first = motions[0];
  let inside = false;
  if (first) {
    for (const shape of both(at(insertFor(first.tool), first.from)))
      crossed(grid, shape, (i, low, high) => {
        if (lengthOf(common(stock[i] ?? [], [low + THIN, high - THIN])) > THIN) inside = true;
      });
  }
  motions.forEach((motion, index) => {
    const gone = new Map<number, number[]>();
    for (const piece of swept(motion, insertFor(motion.tool)))
      crossed(grid, piece, (i, low, high) => {
        if (high <= low || (stock[i]?.length ?? 0) === 0) return;
        const spans = gone.get(i);
        if (spans) spans.push(low, high);
        else gone.set(i, [low, high]);
      });
    let [gouge, rapid] = [0, 0];
    const next: [number, number[]][] = [];
    for (const [i, spans] of gone) {
      const here = stock[i] as Field[number];
      const left = without(here, spans);
      const taken = lengthOf(here) - lengthOf(left);
      if (taken <= 0) continue;
      next.push([i, left]);
      const away = without(here, left);
      gouge += lengthOf(common(away, kept[i] ?? [])) * grid.width;
      if (motion.move.kind === "rapid") {
        const core = common(common(stock[i - 1] ?? [], here), stock[i + 1] ?? []);
        for (let k = 0; k < core.length; k += 2)
          rapid +=
            lengthOf(
              common(away, [
                (core[k] as number) + THIN,
                Math.max((core[k] as number) + THIN, (core[k + 1] as number) - THIN),
              ]),
            ) * grid.width;
      } else cut += taken * grid.width;
    }
    for (const [i, left] of next) stock[i] = left;
    if (whole(index)) stock = connectedToRear(grid, stock, rear, 0);
    if (gouge > 0) faults.push({ kind: "gouge", motion: index, area: gouge });
    if (rapid > 0) faults.push({ kind: "rapid", motion: index, area: rapid });
  });
  return { grid, initial, final: stock, removed: areaOf(grid, initial) - areaOf(grid, stock), cut, faults, inside };
}

/** Sum of the faults of a kind, mm². */
export const sumOf = (v: Verdict, kind: Fault["kind"]): number =>
  v.faults.reduce((sum, f) => (f.kind === kind ? sum + f.area : sum), 0);
