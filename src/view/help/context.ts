import type { Outline } from "../../cycles/define.ts";
import type { Params } from "../../cycles/params.ts";
import type { Plan } from "../../kernel/plan/plan.ts";
import { part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import type { Lettering } from "./dimensions.ts";
import { along, outward, pointAt, type HelpFrame } from "./frame.ts";
import type { Numbers } from "./lettering.ts";
import type { Layout } from "./layout.ts";
import type { Pass } from "./passes.ts";
import type { Section } from "./section.ts";

/** Everything the explanations of the parameters draw from. */
export interface Context {
  readonly params: Params;
  readonly values: Numbers;
  readonly outline: Outline;
  readonly plan: Plan;
  readonly frame: HelpFrame;
  readonly section: Section;
  readonly layout: Layout;
  readonly passes: readonly Pass[];
  /** The infeed as the cycle divides it, mm. */
  readonly step: number;
  /** Level of the surface before the first pass. */
  readonly top: number;
  /** Text and strength of a parameter. */
  readonly letter: (q: string) => Lettering;
  /** Text of a position on the contour that is no parameter. */
  readonly plain: (kind: "diameter" | "axial", at: Pt) => Lettering;
}

/** A value as a number; FAUTO and missing values count as 0. */
export const numberOf = (values: Numbers, q: string | null): number => {
  const v = q === null ? undefined : values[q];
  return typeof v === "number" && Number.isFinite(v) ? v : 0;
};

/** The cycle start point next to the area, at the set-up clearance, mm. */
export function startPoint(f: HelpFrame, corner: Pt, clearance: number): Pt {
  return !f.transverse && !f.sunk
    ? pointAt(f, along(f, corner) - clearance, outward(f, corner))
    : pointAt(f, along(f, corner), outward(f, corner) + clearance);
}

/**
 * The longest element of the contour that a test accepts, or the longest of all when it accepts none; and its middle.
 */
export function longest(
  context: Context,
  accepts: (dz: number, dr: number) => boolean,
): { readonly element: Segment | null; readonly at: Pt } {
  const sized = context.outline.contour
    .map((s) => ({ s, dz: Math.abs(s.to.z - s.from.z), dr: Math.abs(s.to.r - s.from.r) }))
    .sort((a, b) => Math.hypot(b.dz, b.dr) - Math.hypot(a.dz, a.dr));
  const element = (sized.find(({ dz, dr }) => accepts(dz, dr)) ?? sized[0])?.s ?? null;
  return { element, at: element ? part.pointOn(element, 0.5) : context.section.corner };
}
