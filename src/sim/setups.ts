import type { Ring } from "../kernel/geometry/point.ts";
import type { Finished } from "./check.ts";
import { sidesOf } from "./edges.ts";
import { finishedPart } from "./finished.ts";
import { contourSurfaces } from "./plain-cut.ts";
import type { Residual, SimulatedOperation } from "./simulation.ts";

/**
 * The set-ups of a run. Where another blank is stated, residual material so far is computed, and contours of the
 * previous set-up no longer count.
 */
export function setupsOf(
  operations: readonly SimulatedOperation[],
  residual: (stock: readonly Ring[], of: readonly SimulatedOperation[]) => readonly Residual[],
) {
  const left: Residual[] = [];
  let first = 0;
  const known = (from: number): Finished => {
    const rings = finishedPart(operations.slice(from));
    return { rings, edges: sidesOf(rings), surfaces: contourSurfaces(operations.slice(from), from) };
  };
  const begunBefore = (step: number): number => {
    const next = operations.findIndex((o) => o.firstStep >= step);
    return next < 0 ? operations.length : next;
  };
  const atFirst = known(0);
  let finished = atFirst;
  const until = (stock: readonly Ring[], end: number): Residual[] =>
    residual(stock, operations.slice(first, end)).map((r) => ({ ...r, operation: r.operation + first }));
  return {
    atFirst,
    begunBefore,
    finished: () => finished,
    /** Records the residual material on pieces that are parted off. */
    partOff(pieces: readonly Ring[], step: number): void {
      left.push(...until(pieces, begunBefore(step)));
    },
    change(stock: readonly Ring[], step: number): void {
      const end = begunBefore(step);
      left.push(...until(stock, end));
      first = end;
      finished = known(first);
    },
    residual: (stock: readonly Ring[]): readonly Residual[] => [...left, ...until(stock, operations.length)],
  };
}
