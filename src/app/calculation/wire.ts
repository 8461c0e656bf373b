import { transferHandlers } from "comlink";
import type { PlaneStep, Spot } from "../../program/tools/plane-types.ts";
import type { Outcome } from "./outcome.ts";

/** Members that few steps have, sent unpacked. */
type Rare = Omit<
  PlaneStep,
  "kind" | "from" | "to" | "feed" | "feedUnit" | "radius" | "block" | "index" | "seconds" | "turned"
>;

/**
 * Motions of a milling program as columns. Receiving half a million small objects takes the page seconds; typed arrays
 * take no time.
 */
export interface PackedPlane {
  /** Twelve numbers per step; NaN where a step has none. */
  readonly numbers: Float64Array<ArrayBuffer>;
  /** Kind and unit of the feed: places in `KINDS` and `UNITS`, one byte each. */
  readonly kinds: Uint8Array<ArrayBuffer>;
  readonly units: Uint8Array<ArrayBuffer>;
  /** The rare members, by the index of their step. */
  readonly rare: ReadonlyMap<number, Rare>;
}

const KINDS = ["rapid", "feed", "arc"] as const satisfies readonly PlaneStep["kind"][];
const UNITS = [undefined, "mm/rev", "mm/min"] as const satisfies readonly PlaneStep["feedUnit"][];
const COLUMNS = 12;

export function packPlane(plane: readonly PlaneStep[]): PackedPlane {
  const numbers = new Float64Array(plane.length * COLUMNS);
  const kinds = new Uint8Array(plane.length);
  const units = new Uint8Array(plane.length);
  const rare = new Map<number, Rare>();
  plane.forEach(({ kind, from, to, feed, feedUnit, radius, block, index, seconds, turned, ...others }, i) => {
    numbers.set(
      [from.x, from.y, from.z ?? NaN, to.x, to.y, to.z ?? NaN, feed ?? NaN, radius, block, index, seconds, turned],
      i * COLUMNS,
    );
    kinds[i] = KINDS.indexOf(kind);
    units[i] = UNITS.indexOf(feedUnit);
    if (Object.keys(others).length > 0) rare.set(i, others);
  });
  return { numbers, kinds, units, rare };
}

const numberOrNull = (value: number): number | null => (Number.isNaN(value) ? null : value);

export function unpackPlane({ numbers, kinds, units, rare }: PackedPlane): readonly PlaneStep[] {
  return Array.from(kinds, (code, i): PlaneStep => {
    const column = (at: number): number => numbers[i * COLUMNS + at] ?? NaN;
    const spot = (at: number): Spot => ({ x: column(at), y: column(at + 1), z: numberOrNull(column(at + 2)) });
    const [kind, from, to] = [KINDS[code] ?? "feed", spot(0), spot(3)];
    const [feed, feedUnit] = [column(6), UNITS[units[i] ?? 0]];
    const [radius, block, index, seconds, turned] = [column(7), column(8), column(9), column(10), column(11)];
    const step: PlaneStep =
      feedUnit && !Number.isNaN(feed)
        ? { kind, from, to, feed, feedUnit, radius, block, index, seconds, turned }
        : { kind, from, to, radius, block, index, seconds, turned };
    const others = rare.get(i);
    return others ? { ...step, ...others } : step;
  });
}

interface Sent {
  readonly outcome: Outcome;
  readonly plane: PackedPlane;
}

/** Results with more milled motions are sent packed. */
const MANY = 2000;

const isLong = (value: unknown): value is Outcome =>
  typeof value === "object" &&
  value !== null &&
  "run" in value &&
  "simulation" in value &&
  (value as Outcome).run.plane.length > MANY;

/** Registers the transfer of results between worker and page: both sides call this before the first one. */
export function wireOutcomes(): void {
  transferHandlers.set("outcome", {
    canHandle: isLong,
    serialize: (outcome: Outcome): [Sent, Transferable[]] => {
      const plane = packPlane(outcome.run.plane);
      const sent = { outcome: { ...outcome, run: { ...outcome.run, plane: [] } }, plane };
      return [sent, [plane.numbers.buffer, plane.kinds.buffer, plane.units.buffer]];
    },
    deserialize: ({ outcome, plane }: Sent): Outcome => ({
      ...outcome,
      run: { ...outcome.run, plane: unpackPlane(plane) },
    }),
  });
}
