import type { Pt } from "../../kernel/point.ts";
import { along, outward, pointAt, type HelpFrame } from "./frame.ts";

/** One cut at one level: where it enters and where it ends, part space. */
export interface Pass {
  readonly level: number;
  readonly from: Pt;
  readonly to: Pt;
}

/** More lines than this would be a grey area. */
const MOST = 60;

/** Stretches of an area's inside at one level, in feed order. */
function inside(f: HelpFrame, area: readonly Pt[], v: number): [number, number][] {
  const hits: number[] = [];
  area.forEach((b, i) => {
    const a = area[(i || area.length) - 1] ?? b;
    const [va, vb] = [outward(f, a), outward(f, b)];
    if (va > v !== vb > v) hits.push(along(f, a) + ((v - va) / (vb - va)) * (along(f, b) - along(f, a)));
  });
  hits.sort((a, b) => a - b);
  const out: [number, number][] = [];
  for (let i = 0; i + 1 < hits.length; i += 2) out.push([hits[i] ?? 0, hits[i + 1] ?? 0]);
  return out;
}

/**
 * The roughing levels of an area, evenly divided as the control divides them; the drawing knows no tool, so these are
 * the levels of a pointed one.
 */
export function passesOf(
  f: HelpFrame,
  area: readonly Pt[],
  infeed: number,
): { readonly passes: readonly Pass[]; readonly step: number; readonly top: number } {
  const levels = area.map((p) => outward(f, p));
  const top = Math.max(...levels), depth = top - Math.min(...levels);
  if (!(depth > 1e-9) || !Number.isFinite(depth)) return { passes: [], step: 0, top: Number.isFinite(top) ? top : 0 };
  const count = infeed > 0 ? Math.max(1, Math.ceil(depth / infeed - 1e-6)) : 1;
  const step = depth / count;
  const passes: Pass[] = [];
  for (let k = 1; k <= Math.min(count, MOST); k += 1) {
    const level = top - k * step;
    for (const [a, b] of inside(f, area, level + (k === count ? 0.02 : 1e-4) * step))
      if (b - a > 1e-6) passes.push({ level, from: pointAt(f, a, level), to: pointAt(f, b, level) });
  }
  return { passes, step, top };
}

/** Stretches of the contour that fall away from the open side in machining direction: the plunging elements. */
export function falling(f: HelpFrame, line: readonly Pt[]): Pt[][] {
  const out: Pt[][] = [];
  let run: Pt[] = [];
  line.forEach((p, i) => {
    const before = line[i - 1];
    if (!before) return;
    const falls = outward(f, p) < outward(f, before) - 1e-6 && along(f, p) > along(f, before) - 1e-6;
    if (falls) run = run.length > 0 ? [...run, p] : [before, p];
    else if (run.length > 0) {
      out.push(run);
      run = [];
    }
  });
  return run.length > 0 ? [...out, run] : out;
}
