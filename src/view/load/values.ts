import { part, type Pt } from "../../kernel/geometry/point.ts";
import type { Step } from "../../kernel/time/step.ts";
import { pathOf } from "../../kernel/time/time.ts";
import type { PathLoad } from "../../sim/load/along.ts";
import type { RoughStretch } from "../../sim/load/roughness.ts";
import type { PlayPosition } from "../../sim/simulation.ts";

/** Quantities shown along the path. */
export const ALONG_PATH = ["depth", "chip", "feed", "speed"] as const;
export type AlongPath = (typeof ALONG_PATH)[number];

/** A value at a place, and the moment at which the tool is there. */
export interface LoadPlace {
  readonly value: number;
  readonly place: Pt;
  readonly position: PlayPosition;
  readonly block: number;
  readonly operation: number | null;
  /** The spindle is at its limit there. */
  readonly limited: boolean;
}

/**
 * Whether a tool cuts in a row: it removes material, or it threads, where no depth is known. Cutting air is no load.
 */
export const isCutting = (load: PathLoad, row: number): boolean => !((load.depth[row] ?? 0) <= 0);

/** Whether a row has a value to show. */
export const hasLoad = (load: PathLoad, of: AlongPath, row: number): boolean =>
  isCutting(load, row) && Number.isFinite(load[of][row]);

/** The row of a moment; null where the tool does not feed. */
export function rowAt({ count, step, from, to }: PathLoad, position: PlayPosition): number | null {
  let [low, high] = [0, count];
  while (low < high) {
    const middle = (low + high) >> 1,
      at = step[middle] ?? 0;
    if (at < position.step || (at === position.step && (from[middle] ?? 0) <= position.fraction)) low = middle + 1;
    else high = middle;
  }
  const row = low - 1;
  return row >= 0 && step[row] === position.step && (to[row] ?? 0) >= position.fraction ? row : null;
}

/** A row as a place: its middle. */
export function placeOfRow(load: PathLoad, of: AlongPath, row: number, steps: readonly Step[]): LoadPlace | null {
  const index = load.step[row] ?? -1,
    step = steps[index];
  if (!step) return null;
  const fraction = ((load.from[row] ?? 0) + (load.to[row] ?? 0)) / 2;
  const place = part.pointOn(pathOf(step.from, step.move), fraction),
    value = load[of][row] ?? NaN;
  const { block, operation } = step;
  return { value, place, position: { step: index, fraction }, block, operation, limited: load.limited[row] === 1 };
}

/** A stretch of the surface as a place: its middle. */
export function placeOfStretch({ points, position, block, operation, rz }: RoughStretch): LoadPlace {
  const [a, b] = [points[Math.floor((points.length - 1) / 2)], points[Math.ceil((points.length - 1) / 2)]] as [Pt, Pt];
  const place = part.pointOn({ kind: "line", from: a, to: b }, 0.5);
  return { value: rz ?? NaN, place, position, block, operation, limited: false };
}

/**
 * The place of the greatest value of each operation, in their order, and null for moves outside operations. If a
 * spindle reaches its limit, the place of the least cutting speed instead, where the shortfall is greatest.
 */
export function greatestAlong(load: PathLoad, of: AlongPath, steps: readonly Step[]): LoadPlace[] {
  const best = new Map<number | null, number>();
  const beats = (row: number, other: number) => {
    const [a, b] = [load[of][row] ?? 0, load[of][other] ?? 0];
    if (of !== "speed" || (load.limited[row] === 0 && load.limited[other] === 0)) return a > b;
    return load.limited[row] === load.limited[other] ? a < b : load.limited[row] === 1;
  };
  for (let row = 0; row < load.count; row += 1) {
    if (!hasLoad(load, of, row)) continue;
    const operation = steps[load.step[row] ?? -1]?.operation ?? null,
      known = best.get(operation);
    if (known === undefined || beats(row, known)) best.set(operation, row);
  }
  return inOrder([...best.values()].flatMap((row) => placeOfRow(load, of, row, steps) ?? []));
}

/** Heights that differ by a smaller share count as equally rough. */
const AS_ROUGH = 0.005;
const wayOf = ({ points: [first, ...others] }: RoughStretch): number =>
  others.reduce((sum, p, i) => sum + part.apart(others[i - 1] ?? first ?? p, p), 0);

/**
 * The roughest place of each operation that cut a piece of the finished surface; of equally rough stretches the
 * longest.
 */
export function roughestOf(stretches: readonly RoughStretch[]): LoadPlace[] {
  const best = new Map<number | null, RoughStretch>();
  for (const each of stretches) {
    const known = best.get(each.operation),
      [a, b] = [each.rz, known?.rz ?? 0];
    if (a === null) continue;
    const isAsRough = Math.abs(a - b) <= AS_ROUGH * b;
    if (!known || (isAsRough ? wayOf(each) > wayOf(known) : a > b)) best.set(each.operation, each);
  }
  return inOrder([...best.values()].map(placeOfStretch));
}

const inOrder = (places: readonly LoadPlace[]) => [...places].sort((a, b) => a.position.step - b.position.step);

/** The worst of several places: the greatest value, or at a spindle limit the least cutting speed. */
export function worstOf(places: readonly LoadPlace[]): LoadPlace | null {
  const held = places.filter(({ limited }) => limited);
  if (held.length > 0) return held.reduce((a, b) => (b.value < a.value ? b : a));
  return places.length === 0 ? null : places.reduce((a, b) => (b.value > a.value ? b : a));
}
