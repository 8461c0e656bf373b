import type { Pt, Ring } from "../kernel/geometry/point.ts";

/** Which axis the lines run along on which an area is looked at. */
export type Along = "z" | "r";

/**
 * Where straight lines along an axis cross the outlines of an area: for each line, by its place across that axis, the
 * places along it in rising order, in and out in turn. The places of the lines must rise.
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
