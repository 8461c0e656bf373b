import { part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { ROUND } from "../../kernel/tolerance.ts";
import { toDiameter } from "../../kernel/units.ts";
import { newRow, type ContourRow } from "../job/job.ts";

/** An intersection this many times the gap away is still the corner of two ends. */
const CORNER = 4;

/** The corner in which two curves meet near the gap between them; null where they are parallel or too far. */
function cornerOf(a: Segment, b: Segment): Pt | null {
  const gap = part.apart(a.to, b.from),
    isNear = (p: Pt) => part.apart(p, a.to) <= CORNER * gap && part.apart(p, b.from) <= CORNER * gap;
  const found = part.meetings(a, b).filter(isNear);
  return found.toSorted((p, q) => part.apart(p, a.to) - part.apart(q, a.to))[0] ?? null;
}

/** Consecutive curves that end and begin in the same points: lines give way to arcs, which keep their circles. */
export function connected(run: readonly Segment[]): Segment[] {
  const out = [...run];
  for (let i = 1; i < out.length; i += 1) {
    const [a, b] = [out[i - 1], out[i]];
    if (!a || !b || part.apart(a.to, b.from) <= ROUND) continue;
    const point =
      a.kind === "line" && b.kind === "arc"
        ? b.from
        : a.kind === "arc" && b.kind === "line"
          ? a.to
          : (cornerOf(a, b) ?? b.from);
    out[i - 1] = { ...a, to: point };
    out[i] = { ...b, from: point };
  }
  return out.filter((s) => s.kind === "arc" || part.apart(s.from, s.to) > ROUND);
}

/** A coordinate as typed, at the resolution of a control. */
const typed = (n: number) => String(Number(n.toFixed(3)) || 0);

/** Rows of the table for consecutive curves, coordinates rounded as a control takes them. */
export function rowsThrough(run: readonly Segment[]): ContourRow[] {
  const first = run[0];
  if (!first) return [];
  const write = (p: Pt) => ({ x: typed(toDiameter(p.r)), z: typed(p.z) });
  let before = write(first.from);
  const rows = [newRow("e1", before)];
  for (const s of run) {
    const end = write(s.to),
      id = `e${rows.length + 1}`;
    if (end.x === before.x && end.z === before.z) continue;
    if (s.kind === "line")
      rows.push(newRow(id, { x: end.x === before.x ? "" : end.x, z: end.z === before.z ? "" : end.z }));
    else {
      const size = part.radiusOf(s),
        isLong = part.sweepOf(s) > Math.PI + ROUND;
      rows.push(newRow(id, { kind: "CR", ...end, r: typed(isLong ? -size : size), turn: s.turn }));
    }
    before = end;
  }
  return rows;
}
