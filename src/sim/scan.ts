import type { Pt, Ring } from "../kernel/geometry/point.ts";

/** The axis that scan lines run along. */
export type Along = "z" | "r";

/**
 * Crossings of lines along an axis with the outlines of an area: for each line, ascending places along it, entering and
 * leaving in turn. `lines`: their ascending places across the axis.
 */
export function scanCrossings(area: readonly Ring[], along: Along, lines: readonly number[]): number[][] {
  const across = along === "z" ? "r" : "z";
  const found = lines.map((): number[] => []);
  /** The first line at or beyond a place. */
  const firstFrom = (place: number) => {
    let [low, high] = [0, lines.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if ((lines[middle] as number) < place) low = middle + 1;
      else high = middle;
    }
    return low;
  };
  for (const ring of area) {
    let p = ring[ring.length - 1] as Pt;
    for (const q of ring) {
      const [from, to] = [p[across], q[across]];
      if (from !== to) {
        const end = Math.max(from, to);
        for (let i = firstFrom(Math.min(from, to)); i < lines.length && (lines[i] as number) < end; i += 1)
          found[i]?.push(p[along] + ((q[along] - p[along]) * ((lines[i] as number) - from)) / (to - from));
      }
      p = q;
    }
  }
  for (const list of found) list.sort((a, b) => a - b);
  return found;
}
