import { readTolerance } from "../../kernel/fit/typed-tolerance.ts";
import { SAME, SLIVER } from "../../kernel/tolerance.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { radius, radiusOf, toDiameter } from "../../kernel/units.ts";

/**
 * Undersize of the drill before a reamer by its diameter: up to, least, most, mm. Empirical values for steel of vocational
 * training (decision 0056).
 */
const UNDERSIZES: readonly (readonly [upTo: number, least: number, most: number])[] = [
  [5, 0.1, 0.2],
  [20, 0.2, 0.3],
  [50, 0.3, 0.5],
  [Infinity, 0.5, 1],
];
/** Tolerance class of a reamed hole, and the finest roughness that reaming leaves, Ra in µm (recalled, tag K). */
const [REAMED, FINEST] = ["H7", 0.8] as const;

/** Nominal diameters of reamers are tenths of a millimetre; their measured ones lie within their class. */
const TENTH = 10;
const nominalOf = (tool: Tool): number => Math.round(toDiameter(radius(tool.R ?? 0)) * TENTH) / TENTH;
const across = (tool: Tool): number => toDiameter(radius(tool.R ?? 0));

/** Radii of the hole that a reamer needs, mm: the narrowest, and the widest in which all of its edge still cuts. */
export function reamerHole(reamer: Tool): { readonly least: number; readonly most: number } {
  const d = nominalOf(reamer);
  const [, less, more] = UNDERSIZES.find(([upTo]) => d <= upTo) ?? [0, 0, 0];
  return { least: radiusOf(d - more), most: radiusOf(d - less) };
}

/** Whether a drill makes the hole before a reamer. */
export function drillsBefore(reamer: Tool, drill: Tool): boolean {
  const { least, most } = reamerHole(reamer);
  const r = drill.R ?? 0;
  return r > least - SAME && r < most + SAME;
}

/** A cylinder of a bore as its drawing states it: its diameter at the middle of its tolerance, mm, and Ra in µm. */
export interface WantedHole {
  readonly diameter: number;
  readonly tolerance?: string | undefined;
  readonly roughness?: number | undefined;
}

/** Differences of two diameters that rounding makes, mm. */
const ROUNDED = 0.0015;

/** Whether a reamer makes a cylinder of a bore: its hole lies within the tolerance, and its wall is fine enough. */
export function reams(reamer: Tool, { diameter, tolerance, roughness = FINEST }: WantedHole): boolean {
  const d = nominalOf(reamer);
  const made = readTolerance(REAMED, d);
  // What is left, or taken of the part, is thinner than what counts.
  const isNear = Math.abs(across(reamer) - diameter) < 2 * SLIVER;
  if (reamer.TYPE !== "REAM" || !made || !isNear || roughness < FINEST) return false;
  if (tolerance === undefined) return Math.abs(diameter - d) < ROUNDED;
  const wanted = readTolerance(tolerance, d);
  if (!wanted || Math.abs(d + (wanted.upper + wanted.lower) / 2 - diameter) > ROUNDED) return false;
  return made.lower >= wanted.lower - SAME && made.upper <= wanted.upper + SAME;
}
