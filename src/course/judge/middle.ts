import { at, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import { SLIVER } from "../../kernel/tolerance.ts";
import { scanCrossings, type Along } from "../../sim/scan.ts";

interface Way {
  readonly long: number;
  readonly middle: Pt;
}

/** Lines across an area, each in the middle of a strip between two neighbouring corners. */
function linesOf(area: readonly Ring[], across: "z" | "r"): number[] {
  const sorted = [...new Set(area.flatMap((ring) => ring.map((p) => p[across])))].sort((a, b) => a - b);
  return sorted.slice(1).flatMap((next, i) => {
    const last = sorted[i] ?? next;
    return next - last > SLIVER ? [(last + next) / 2] : [];
  });
}

function longestAlong(area: readonly Ring[], along: Along): Way | null {
  const lines = linesOf(area, along === "z" ? "r" : "z");
  let best: Way | null = null;
  scanCrossings(area, along, lines).forEach((found, i) => {
    for (let k = 0; k + 1 < found.length; k += 2) {
      const [from, to, line] = [found[k] ?? 0, found[k + 1] ?? 0, lines[i] ?? 0];
      if (to - from <= (best?.long ?? 0)) continue;
      best = { long: to - from, middle: along === "z" ? at((from + to) / 2, line) : at(line, (from + to) / 2) };
    }
  });
  return best;
}

/**
 * A point inside an area that shows its extent: the middle of the longest straight line through it along Z or across.
 */
export function middleOf(area: readonly Ring[]): Pt {
  const [along, across] = [longestAlong(area, "z"), longestAlong(area, "r")];
  const best = along && (!across || along.long >= across.long) ? along : across;
  return best?.middle ?? area[0]?.[0] ?? at(0, 0);
}
