import type { Place, Size } from "../camera.ts";
import type { LabelBox } from "./labels.ts";

/** Side of a cell, pixels: about as high as a text. */
const CELL = 16;

/** The cells of a sheet. Places outside belong to the cells along its edges. */
function cellsOf({ width, height }: Size) {
  const columns = Math.max(1, Math.ceil(width / CELL)),
    rows = Math.max(1, Math.ceil(height / CELL));
  const between = (at: number, count: number) => Math.max(0, Math.min(count - 1, Math.floor(at / CELL)));
  return {
    count: columns * rows,
    cellOf: ({ x, y }: Place) => between(y, rows) * columns + between(x, columns),
    /** The first and the last cell of each row of cells that a box covers. */
    *spansOf({ x, y, width: wide, height: high }: LabelBox): Generator<readonly [number, number]> {
      const [left, right, last] = [between(x, columns), between(x + wide, columns), between(y + high, rows)];
      for (let row = between(y, rows); row <= last; row += 1) yield [row * columns + left, row * columns + right];
    },
  };
}

/** Counts the places of a sheet inside a box, its edges left out. Only the cells that the box covers are searched. */
export function placesOn(size: Size, places: readonly Place[]): (box: LabelBox) => number {
  const cells = cellsOf(size),
    ends = new Uint32Array(cells.count + 1);
  const cell = places.map(cells.cellOf);
  for (const each of cell) ends[each + 1] = (ends[each + 1] ?? 0) + 1;
  for (let i = 0; i < cells.count; i += 1) ends[i + 1] = (ends[i + 1] ?? 0) + (ends[i] ?? 0);
  const next = ends.slice(),
    ordered = new Array<Place>(places.length);
  for (const [i, place] of places.entries()) {
    const at = cell[i] ?? 0,
      to = next[at] ?? 0;
    ordered[to] = place;
    next[at] = to + 1;
  }
  return (box) => {
    let found = 0;
    for (const [first, last] of cells.spansOf(box))
      for (let i = ends[first] ?? 0, end = ends[last + 1] ?? 0; i < end; i += 1) {
        const p = ordered[i];
        if (p && p.x > box.x && p.x < box.x + box.width && p.y > box.y && p.y < box.y + box.height) found += 1;
      }
    return found;
  };
}

/** Things on a sheet, found by the cells that they cover, so that only neighbours are compared. */
export interface SheetGrid<Each> {
  readonly put: (each: Each) => void;
  /** Whether one of those near a box passes a test. */
  readonly some: (near: LabelBox, test: (each: Each) => boolean) => boolean;
}

/** An empty grid of things with their boxes. */
export function gridOn<Each>(size: Size, boxOf: (each: Each) => LabelBox): SheetGrid<Each> {
  const cells = cellsOf(size),
    byCell = new Map<number, Each[]>();
  return {
    put: (each) => {
      for (const [first, last] of cells.spansOf(boxOf(each)))
        for (let i = first; i <= last; i += 1) {
          const there = byCell.get(i);
          if (there) there.push(each);
          else byCell.set(i, [each]);
        }
    },
    some: (near, test) => {
      for (const [first, last] of cells.spansOf(near))
        for (let i = first; i <= last; i += 1) if (byCell.get(i)?.some(test)) return true;
      return false;
    },
  };
}
