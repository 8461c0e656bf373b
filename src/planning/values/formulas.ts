import { SAME_STEP } from "../../kernel/tolerance.ts";

/**
 * The formulas of cutting values in standard symbols: ap depth, f feed, fp plunging feed, vc cutting speed (vc0 that of
 * roughing), n rpm, rε nose radius, l edge length, b width of a blade, d diameter, P pitch, h depth of a thread, i
 * passes, kc specific force, δ allowed deflection, E modulus of elasticity, I second moment of area, L overhang, k
 * support (3 chuck, 102 chuck and centre, 48 centres). Lengths mm, roughness µm, power kW.
 */
export const VALUE_FORMULAS = {
  depthOfFeed: "ap = 10 · f",
  depthOfEdge: "ap = 2/3 · l",
  depthOfButton: "ap = rε / 2",
  depthOfPower: "ap = 60 000 · Pc / (f · kc · vc)",
  depthOfWorkpiece: "ap = k · δ · E · I / (0.4 · f · kc · L³)",
  depthOfBar: "ap = 3 · δ · E · I / (0.4 · f · kc · L³)",
  depthOfWidth: "ap = b / 2",
  depthOfThread: "ap = h / √i",
  depthOfTooth: "ap = 0.5",
  depthOfNose: "ap = 2/3 · rε",
  depthLeast: "ap",
  oversizeOfNose: "Δ⌀ = 2 · 2/3 · rε",
  oversizeOfDepth: "Δ⌀ = 2 · ap",
  halfOfDepth: "Δz = ap / 2",
  stepOfWidth: "a = 1.5 · b",
  stepOfDiameter: "q = d",
  stepFirst: "q = 2 · d",
  stepLess: "Δq = 0.5 · d",
  wholeDepth: "q = t",
  feedOfMaterial: "f",
  feedOfNose: "f = 0.8 · rε",
  feedOfRoughness: "f = √(8 · rε · Rz / 1000)",
  feedOfWidth: "f = 0.04 · b",
  feedOfCorner: "f = rε",
  feedOfBar: "f = (3 · δ · E · I / (0.4 · b · kc1.1 · L³))^(1 / (1 − mc))",
  feedOfWorkpiece: "f = (k · δ · E · I / (0.4 · b · kc1.1 · L³))^(1 / (1 − mc))",
  feedOfPower: "f = 60 000 · Pc / (b · kc · vc)",
  feedOfDrill: "f = c · d",
  feedOfReamer: "f = c · d",
  feedOfPitch: "f = P",
  feedLeast: "f",
  halfOfFeed: "fp = f / 2",
  speedOfMaterial: "vc",
  speedOfShare: "vc = s · vc0",
  rpmOfSpeed: "n = 1000 · vc / (π · d)",
  rpmOfMachine: "n",
  rpmAssumed: "n",
  rpmOfThread: "n = vf / P",
  limitOfMachine: "d = 1000 · vc / (π · n)",
  limitAssumed: "d = 1000 · vc / (π · n)",
} as const;
export type ValueFormula = keyof typeof VALUE_FORMULAS;

/** What limits a value: the least of all applies. */
export type ValueLimit =
  | "material"
  | "chip"
  | "cutLength"
  | "insert"
  | "power"
  | "slenderness"
  | "bar"
  | "roughness"
  | "width"
  | "machine"
  | "pitch"
  | "depth"
  | "least";

/** A value with its formula, its inputs by the symbols of the formula, and what it is limited by. */
export interface ReasonedNumber {
  readonly value: number;
  readonly formula: ValueFormula;
  readonly inputs: Readonly<Record<string, number | string>>;
  readonly limitedBy: ValueLimit;
}

export const reasoned = (
  value: number,
  formula: ValueFormula,
  limitedBy: ValueLimit,
  inputs: ReasonedNumber["inputs"] = {},
): ReasonedNumber => ({ value, formula, inputs, limitedBy });

/** The least of several values; the first of equal ones. */
export const leastOf = (first: ReasonedNumber, ...others: readonly (ReasonedNumber | null)[]): ReasonedNumber =>
  others.reduce<ReasonedNumber>((least, each) => (each && each.value < least.value ? each : least), first);

/** Rounded down to a step that an operator types; a value below one step stays as it is. */
export function typedDown(value: ReasonedNumber, step: number): ReasonedNumber {
  const down = Number((Math.floor(value.value / step + SAME_STEP) * step).toFixed(4));
  return { ...value, value: down > 0 ? down : value.value };
}

/** Least sensible values. */
export const LEAST = { depth: 0.2, feed: 0.03, finishDepth: 0.1 } as const;
/** Never below a least value, which then is the reason. */
export const atLeast = (value: ReasonedNumber, least: number, formula: "depthLeast" | "feedLeast"): ReasonedNumber =>
  value.value >= least ? value : reasoned(least, formula, "least", {});
