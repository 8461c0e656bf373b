import type { Field, Grid } from "./field.ts";

/* The part connected to the rear end, by flood fill from there: only the blank is shared with the simulation. */

interface Stretch {
  readonly i: number;
  readonly low: number;
  readonly high: number;
  held: boolean;
}

/**
 * The stretches of a field that are connected to material within a column of the plane z = `rear`, mm. Stretches of
 * neighbouring columns are connected if they overlap by more than `least` mm; a negative value joins near misses.
 */
export function connectedToRear(grid: Grid, field: Field, rear: number, least: number): Field {
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
