import type { Kienzle } from "./formulas.ts";
import { ELASTICITY } from "../../program/tools/cutting-work.ts";
import type { IsoGroup } from "../../program/tools/cutting-table.ts";

/** How the workpiece is held: in the chuck alone, with a centre in its end, or between centres. */
export type Support = "chuck" | "chuckAndCentre" | "centres";

/** The free part of the workpiece, mm: length from the jaws, the diameter of a plain bar as stiff as it is, its bore. */
export interface HeldWorkpiece {
  readonly overhang: number;
  readonly diameter: number;
  readonly bore?: number;
  readonly support: Support;
}

/** A boring bar, mm: length from its clamping to the tip, and diameter. */
export interface HeldBar {
  readonly overhang: number;
  readonly diameter: number;
}

/** Share of the cutting force that bends the workpiece or the bar. */
const PASSIVE = 0.4;
/** Allowed deflection, mm: a fifth of a usual oversize when roughing, the resolution of a fit when finishing. */
export const DEFLECTION = { rough: 0.05, finish: 0.01 } as const;
/** Load over deflection in E · I / L³: a cantilever at its end, and beams at their weakest place. */
const STIFFNESS: Readonly<Record<Support, number>> = { chuck: 3, chuckAndCentre: 102, centres: 48 };
const STEEL = ELASTICITY.P;

/** A force that deflects by as much as allowed, N, with its inputs. */
interface AllowedForce {
  readonly force: number;
  readonly inputs: Readonly<Record<string, number>>;
}

const secondMoment = (diameter: number, bore = 0) => (Math.PI * (diameter ** 4 - bore ** 4)) / 64;

function allowed(k: number, elasticity: number, moment: number, overhang: number, deflection: number): AllowedForce {
  const force = (k * deflection * elasticity * moment) / overhang ** 3;
  return { force: force / PASSIVE, inputs: { k, δ: deflection, E: elasticity, I: Math.round(moment), L: overhang } };
}

/** The cutting force at which a workpiece bends by an allowed deflection; null where nothing is free to bend. */
function forceOnWorkpiece(
  { overhang, diameter, bore = 0, support }: HeldWorkpiece,
  group: IsoGroup,
  deflection: number,
): AllowedForce | null {
  if (!(overhang > 0) || !(diameter > bore)) return null;
  return allowed(STIFFNESS[support], ELASTICITY[group], secondMoment(diameter, bore), overhang, deflection);
}

/** The same for a boring bar of steel. */
const forceOnBar = ({ overhang, diameter }: HeldBar, deflection: number): AllowedForce | null =>
  overhang > 0 && diameter > 0 ? allowed(STIFFNESS.chuck, STEEL, secondMoment(diameter), overhang, deflection) : null;

/** What bends under the cutting force, with the force at which it bends as far as allowed. */
export interface BentBody extends AllowedForce {
  readonly by: "slenderness" | "bar";
}

/** The bodies that a cut bends: workpiece and bar, as far as known. */
export function bentBodies(
  { workpiece, bar }: { readonly workpiece: HeldWorkpiece | null; readonly bar: HeldBar | null },
  group: IsoGroup,
  deflection: number,
): readonly BentBody[] {
  const held = workpiece && forceOnWorkpiece(workpiece, group, deflection);
  const bent = bar && forceOnBar(bar, deflection);
  return [
    ...(held ? [{ ...held, by: "slenderness" } as const] : []),
    ...(bent ? [{ ...bent, by: "bar" } as const] : []),
  ];
}

/** The depth of cut at which a force is reached, mm. */
export const depthForForce = (force: number, specific: number, feed: number): number => force / (feed * specific);

/** The feed at which a blade of a width reaches a force, mm/rev: from F = b · kc1.1 · f^(1 − mc). */
export const feedForForce = (force: number, { kc11, mc }: Kienzle, width: number): number =>
  (force / (width * kc11)) ** (1 / (1 - mc));

/** Length over diameter: above this a workpiece in the chuck alone, and a steel bar, are slender. */
export const SLENDER = { workpiece: 3, bar: 4 } as const;
