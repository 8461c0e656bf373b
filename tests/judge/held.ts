import type { Field, Grid } from "./field.ts";

/*
 * What hangs together with the rear end, by flooding the columns from there: nothing is shared with the simulation but
 * the blank.
 */

interface Stretch {
  readonly i: number;
  readonly low: number;
  readonly high: number;
  held: boolean;
}

/**
 * The stretches of a field that hang together with what stands within a column of the plane z = `rear`, mm. Stretches
 * of neighbouring columns do when they overlap by more than `least` mm; a negative one joins what nearly touches.
 */
export function heldIn(grid: Grid, field: Field, rear: number, least: number): Field {
  const columns = field.map((column, i) =>
    column.flatMap((low, k): Stretch[] =>
      k % 2 === 0 ? [{ i, low, high: column[k + 1] as number, held: false }] : [],
    ),
  );
  const isRear = ({ i, low }: Stretch) =>
    (grid.along === "z" ? grid.from + i * grid.width : low) <= rear + 2 * grid.width;
  const open = columns.flat().filter(isRear);
  for (const s of open) s.held = true;
  for (let s = open.pop(); s; s = open.pop())
    for (const n of [...(columns[s.i - 1] ?? []), ...(columns[s.i + 1] ?? [])]) {
      if (n.held || Math.min(n.high, s.high) - Math.max(n.low, s.low) <= least) continue;
      n.held = true;
      open.push(n);
    }
  return columns.map((column) => column.flatMap((s) => (s.held ? [s.low, s.high] : [])));
}
