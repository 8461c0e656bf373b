import type { Flat } from "../geometry/flat.ts";
import { CENTRE_FORMS, type CentreDrill, type CentreForm, type CentreHole } from "../plan/tool.ts";
import { SAME } from "../tolerance.ts";
import { length, radians } from "../units.ts";

/**
 * The preferred sizes: d1, d2, t of A, d3 and t of B, t of R, and guide values of the shaft. Two public tables agree in
 * d1, d2, d3 and the depths (SN EN ISO 6411 and DIN 332-1:1986-04, tag S; decision 0052); the shafts are of the first,
 * the depths of R of the second. Other sizes were not found twice.
 */
const SIZES: readonly (readonly [
  d1: number,
  d2: number,
  tA: number,
  d3: number,
  tB: number,
  tR: number,
  over: number,
  upTo: number,
])[] = [
  [1, 2.12, 1.9, 3.15, 2.2, 1.9, 0, 8],
  [1.6, 3.35, 2.9, 5, 3.4, 2.9, 8, 12],
  [2, 4.25, 3.7, 6.3, 4.3, 3.7, 12, 18],
  [2.5, 5.3, 4.6, 8, 5.4, 4.6, 18, 25],
  [3.15, 6.7, 5.9, 10, 6.8, 5.8, 25, 40],
  [4, 8.5, 7.4, 12.5, 8.6, 7.4, 40, 80],
  [6.3, 13.2, 11.5, 18, 12.9, 11.4, 80, 180],
  [10, 21.2, 18.4, 28, 20.4, 18.3, 180, Infinity],
];

/** The sizes of a form, by pilot. */
export const centreHoles = (form: CentreForm): readonly CentreHole[] =>
  SIZES.map(([d1, d2, tA, d3, tB, tR, over, upTo]) => ({
    form,
    d1,
    d2,
    d3: form === "B" ? d3 : d2,
    t: { A: tA, B: tB, R: tR }[form],
    over,
    upTo,
  }));

export const centreHole = (form: CentreForm, d1: number): CentreHole | null =>
  centreHoles(form).find((hole) => Math.abs(hole.d1 - d1) <= SAME) ?? null;

const [CONE, PROTECTION, POINT] = [60, 120, 118];
const along = (across: number, angle: number) => across / 2 / Math.tan(radians(angle) / 2);

/** Depth of the cone of 60° and of the protecting one, mm. */
export const coneDepth = ({ d1, d2 }: CentreHole): number => along(d2 - d1, CONE);
export const protectionDepth = ({ d2, d3 }: CentreHole): number => along(d3 - d2, PROTECTION);

/** The shortest pilot that makes a hole of the standard, mm. */
export const leastPilot = (hole: CentreHole): number => hole.t - coneDepth(hole) - protectionDepth(hole);

/** Depth of the point at which the hole has its size, mm. */
export const centreDepth = ({ hole, pilot }: CentreDrill): number => pilot + coneDepth(hole) + protectionDepth(hole);

/** Half outline from the point to the full radius of the body: distance from the point, and radius. */
export function centreProfile({ hole, pilot }: CentreDrill, body: number): readonly Flat[] {
  const [r1, r2, r3] = [hole.d1 / 2, hole.d2 / 2, hole.d3 / 2];
  const tip = Math.min(along(hole.d1, POINT), pilot);
  const cone = pilot + coneDepth(hole);
  const points: Flat[] = [
    { u: 0, v: 0 },
    { u: tip, v: r1 },
    { u: pilot, v: r1 },
  ];
  const full = Math.max(body, r3);
  if (hole.form !== "B") return [...points, { u: pilot + along(2 * full - hole.d1, CONE), v: full }];
  return [...points, { u: cone, v: r2 }, { u: cone + along(2 * full - hole.d2, PROTECTION), v: full }];
}

/** Diameter that the drill leaves at the face when its point is at this depth, mm. */
export function mouthAt(drill: CentreDrill, body: number, depth: number): number {
  const profile = centreProfile(drill, body);
  const at = profile.findIndex(({ u }) => u > depth);
  if (at < 0) return 2 * (profile.at(-1)?.v ?? 0);
  const [a, b] = [profile[at - 1], profile[at]];
  if (!a || !b) return 0;
  return 2 * (a.v + ((depth - a.u) / (b.u - a.u)) * (b.v - a.v));
}

/** A designation such as "A4" among the words of a name, with or without its mouth: "DIN 333-A4", "ISO6411-B2,5/8". */
const NAMED = /(?:^|[^A-Z])([ABR]) ?(\d+(?:[.,]\d+)?)(?:\s*[X×/]\s*(\d+(?:[.,]\d+)?))?(?![\dA-Z.,])/;

const numberOf = (text: string) => Number(text.replace(",", "."));

/** The centre hole that a name states; null without one, or for a size that is not in the table. */
export function centreNamed(name: string): CentreHole | null {
  const found = NAMED.exec(name.toUpperCase());
  const form = CENTRE_FORMS.find((f) => f === found?.[1]);
  if (!found?.[2] || !form) return null;
  const hole = centreHole(form, numberOf(found[2]));
  const mouth = found[3] === undefined ? null : numberOf(found[3]);
  return hole && (mouth === null || [hole.d2, hole.d3].some((d) => Math.abs(d - mouth) <= 0.051)) ? hole : null;
}

/** The drill of a table row by its name; without a length of the pilot, the shortest that makes the hole. */
export function centreDrill(name: string, pilot: number | undefined): CentreDrill | null {
  const hole = centreNamed(name);
  return hole && { hole, pilot: length(Math.max(pilot ?? 0, leastPilot(hole))) };
}
