import { part, type Pt } from "../../../kernel/geometry/point.ts";
import { SAME } from "../../../kernel/tolerance.ts";
import type { SectionCurve } from "./half-section.ts";
import { ROUGH } from "./meridian.ts";

/** Ends farther apart are no corner that a system wrote inexactly, mm. */
const FARTHEST = 3 * ROUGH;
/** Sections with more open ends are left as they are. */
const MOST_ENDS = 1000;

interface End {
  readonly curve: number;
  readonly side: "from" | "to";
  readonly at: Pt;
}

/** Corners where faces meet inexactly, since their edge is an approximation, are put where their lines and arcs cross. */
export function mended(curves: readonly SectionCurve[]): readonly SectionCurve[] {
  const all = curves.flatMap((c, curve): End[] =>
    (["from", "to"] as const).map((side) => ({ curve, side, at: c.segment[side] })),
  );
  const isOpen = (e: End) => !all.some((o) => o.curve !== e.curve && part.apart(o.at, e.at) < SAME);
  const open = all.length > 2 * MOST_ENDS ? [] : all.filter((e) => !curves[e.curve]?.isFitted && isOpen(e)),
    out = [...curves],
    used = new Set<End>();
  for (const e of open) {
    if (used.has(e)) continue;
    const near = open
      .filter((o) => o.curve !== e.curve && !used.has(o) && part.apart(o.at, e.at) < FARTHEST)
      .sort((a, b) => part.apart(a.at, e.at) - part.apart(b.at, e.at))[0];
    const [a, b] = [out[e.curve], near && out[near.curve]];
    if (!near || !a || !b) continue;
    const corner = part
      .meetings(a.segment, b.segment)
      .filter((p) => part.apart(p, e.at) < FARTHEST && part.apart(p, near.at) < FARTHEST)
      .sort((p, q) => part.apart(p, e.at) - part.apart(q, e.at))[0];
    if (!corner) continue;
    used.add(e).add(near);
    out[e.curve] = { ...a, segment: { ...a.segment, [e.side]: corner } };
    out[near.curve] = { ...b, segment: { ...b.segment, [near.side]: corner } };
  }
  return out;
}
