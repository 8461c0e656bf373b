import type { Cycle } from "../../src/cycles/define.ts";
import type { Move } from "../../src/kernel/plan/move.ts";
import type { Plan } from "../../src/kernel/plan/plan.ts";
import { at, part, type Pt, type Ring } from "../../src/kernel/geometry/point.ts";
import { ROUND, SAME } from "../../src/kernel/tolerance.ts";
import type { TipOrientation } from "../../src/kernel/plan/tool.ts";
import type { Finding, Situation } from "./situation.ts";
import { planOf } from "./worked-plans.ts";

/** A law of a path by itself, before anything is cut. */
export type PlanLaw = (cycle: Cycle, situation: Situation, plan: Plan) => Finding;

/** Whether the operation includes roughing. */
const roughs = (s: Situation) => (s.values["Q215"] ?? 0) <= 1;

/** The parameter that is divided into even infeeds; a limit of a plunge, which 0 switches off, is none. */
const infeedOf = (cycle: Cycle) => Object.entries(cycle.params).find(([, p]) => p.shown === "infeed")?.[0];

const infeedsAreEven: PlanLaw = (cycle, s, plan) => {
  const q = infeedOf(cycle);
  if (!roughs(s) || q === undefined) return null;
  const most = Math.min(s.values[q] ?? 0, s.tool.CUTLENGTH || Infinity);
  if (plan.infeed > most + SAME + ROUND) return `an infeed of ${plan.infeed} where ${most} is the most`;
  if (plan.passes > 1 && (plan.passes * plan.infeed) / (plan.passes - 1) <= most - SAME * most) {
    return `${plan.passes} passes of ${plan.infeed} where one fewer would do with ${most}`;
  }
  return null;
};

const passesAreNumbered: PlanLaw = (_, s, plan) => {
  const strange = plan.moves.find(
    (m) => m.phase === "rough" && m.pass !== undefined && (m.pass < 1 || m.pass > plan.passes),
  );
  return roughs(s) && strange ? `a cut of pass ${strange.pass} where there are ${plan.passes}` : null;
};

/** No bite is deeper than the limit of a plunge. */
const plungesAreLimited: PlanLaw = (cycle, s, plan) => {
  const q = Object.entries(cycle.params).find(([, p]) => p.shown === "depthLimit")?.[0];
  const most = q === undefined ? 0 : (s.values[q] ?? 0);
  return most > 0 && plan.infeed > most + SAME + ROUND ? `a bite of ${plan.infeed} where ${most} is the most` : null;
};

/**
 * The fault of a single move. A move may cross the axis only as far as the contour does, and by the nose that faces it
 * clean.
 */
function wrongWith(m: Move, from: Pt, lowest: number): Finding {
  const where = `${m.kind} to Z ${m.to.z} R ${m.to.r}`;
  if (!Number.isFinite(m.to.z) || !Number.isFinite(m.to.r)) return `${where}: nowhere`;
  if (m.to.r < lowest) return `${where}: below R ${lowest}`;
  if (m.kind === "rapid" && Math.abs(m.to.z - from.z) >= SAME && Math.abs(m.to.r - from.r) >= SAME)
    return `${where}: not along an axis`;
  if (m.kind !== "arc") return null;
  const [a, b] = [from, m.to].map((p) => Math.hypot(p.z - m.centre.z, p.r - m.centre.r)) as [number, number];
  return Math.abs(a - b) >= SAME ? `${where}: begins at radius ${a} and ends at ${b}` : null;
}

const pathIsBounded: PlanLaw = (_, s, plan) => {
  const most = (plan.passes + 3) * (12 + 6 * (plan.contour.length + 4));
  if (plan.moves.length > most) return `${plan.moves.length} moves where ${most} is a lot`;
  // A blade has two noses: the outer one is half its width from the tip.
  const past = Math.max(s.tool.RS, (s.tool.CUTWIDTH ?? 0) / 2);
  const lowest = Math.min(0, ...plan.contour.flatMap((e) => [e.from.r, e.to.r])) - past - SAME;
  let from = s.start;
  for (const m of plan.moves) {
    const wrong = wrongWith(m, from, lowest);
    if (wrong) return wrong;
    from = m.to;
  }
  return null;
};

/** A depth of k infeeds of exactly Q463 takes k passes. */
const divisionsAreExact: PlanLaw = (cycle, s, plan) => {
  const q = infeedOf(cycle);
  if (!roughs(s) || q === undefined || plan.passes === 0 || plan.passes > 200) return null;
  const depth = plan.passes * plan.infeed;
  for (const k of [1, 2, 3, 7]) {
    if (depth / k < 0.3 || depth / k > (s.tool.CUTLENGTH ?? Infinity)) continue;
    const again = planOf(cycle, { ...s, values: { ...s.values, [q]: depth / k } });
    // A shifted start point changes the depth.
    if (Math.abs(again.passes * again.infeed - depth) < SAME && again.passes !== k)
      return `${again.passes} passes for ${k} infeeds`;
  }
  return null;
};

const OTHER: Record<TipOrientation, TipOrientation> = { 1: 3, 2: 2, 3: 1, 4: 8, 5: 7, 6: 6, 7: 5, 8: 4, 9: 9 };
const point = (p: Pt): Pt => at(-p.z, p.r);
const ring = (r: Ring): Ring => r.map(point).reverse();
export const mirrored = (s: Situation): Situation => ({
  ...s,
  values: { ...s.values, Q492: -(s.values["Q492"] ?? 0), Q494: -(s.values["Q494"] ?? 0) },
  tool: { ...s.tool, TO: OTHER[s.tool.TO] },
  start: point(s.start),
  given: { ...s.given, start: s.given.start && point(s.given.start) },
  blank: s.blank.map(ring),
});
/** A move as text, to a tenth of a micron. */
const describeMove = (m: Move, to: (p: Pt) => Pt) => {
  const places = m.kind === "arc" ? [m.to, m.centre] : [m.to];
  const numbers = places.map(to).flatMap((p) => [p.z, p.r].map((n) => Math.round(n * 1e4) / 1e4 + 0));
  return [m.kind, m.phase, m.pass, m.run, m.step, ...numbers].join(" ");
};

/** Whether `b` is on the straight line from `a` to `c`. */
const isOnTheWay = (a: Pt, b: Pt, c: Pt) =>
  Math.abs(Math.hypot(b.z - a.z, b.r - a.r) + Math.hypot(c.z - b.z, c.r - b.r) - Math.hypot(c.z - a.z, c.r - a.r)) <
  SAME;

/**
 * All moves as text, two collinear lines joined: where a level meets its continuation, rounding decides whether there
 * are two. The same applies to the way up beside a steep wall, where feed changes to rapid.
 */
const describeMoves = ({ moves }: Plan, start: Pt, to: (p: Pt) => Pt) =>
  moves
    .filter((m, i) => {
      const [before, next] = [moves[i - 1]?.to ?? start, moves[i + 1]];
      const same =
        next &&
        m.kind !== "arc" &&
        next.kind !== "arc" &&
        next.phase === m.phase &&
        next.step === m.step &&
        (next.kind === m.kind || next.kind === "rapid");
      return !(same && isOnTheWay(before, m.to, next.to));
    })
    .map((m) => describeMove(m, to));

/**
 * A set-up mirrored in Z, including the tool, must give the mirrored path. A free contour across the axis is open
 * towards +Z for any tool (decision 0010), so only the cycles with their own contour are mirrored. An insert that
 * points straight at the axis still leans to one side: no tool is its mirror image.
 */
const turnsRound: PlanLaw = (cycle, s, plan) => {
  if (cycle.contour !== "own" || (s.tool["T-ANGLE"] !== undefined && [2, 6].includes(s.tool.TO))) return null;
  const other = planOf(cycle, mirrored(s));
  const [ours, theirs] = [describeMoves(plan, s.start, (p) => p), describeMoves(other, point(s.start), point)];
  const apart = ours.findIndex((line, i) => line !== theirs[i]);
  if (apart >= 0 || ours.length !== theirs.length)
    return `turned round, "${theirs[apart]}" stands where "${ours[apart]}" should`;
  const [codes, others] = [plan, other].map((p) => p.issues.map((i) => i.code).join(", ")) as [string, string];
  return codes === others ? null : `turned round, it says ${others || "nothing"} instead of ${codes || "nothing"}`;
};

/** Whether a cycle turns along the axis or across it. */
const isTurning = (cycle: Cycle) => cycle.group === "longitudinal" || cycle.group === "transverse";

/** Only a traced blank changes a path: BLK FORM has no effect. */
const blankDoesNotMatter: PlanLaw = (cycle, s, plan) => {
  if (!isTurning(cycle)) return null;
  const elsewhere = s.blank.map((r) => r.map((p) => at(p.z + 3, p.r + 2)));
  const other = planOf(cycle, { ...s, blank: elsewhere });
  const [ours, theirs] = [plan, other].map((p) => JSON.stringify(p.moves)) as [string, string];
  return ours === theirs ? null : "another blank makes another path";
};

/** In a bore no move goes nearer to the axis than start point and contour, except the passes over an allowance. */
const boreStaysClear: PlanLaw = (cycle, s, plan) => {
  // The tip of a button beside the cut is its middle, and comes nearer by the radius.
  if (
    cycle.group !== "longitudinal" ||
    plan.openSide.r >= 0 ||
    plan.moves.length === 0 ||
    ![5, 6, 7].includes(s.tool.TO)
  )
    return null;
  const started = plan.moves.flatMap((m) => (m.step === 0 ? [m.to.r] : []));
  const contour = plan.contour.flatMap((e) =>
    part.flattened(e, SAME / 10).map((p) => p.r - (plan.oversize?.r ?? 0) - (s.values["Q485"] ?? 0)),
  );
  const least = Math.min(s.start.r, ...started, ...contour) - SAME;
  const nearest = Math.min(...plan.moves.map((m) => m.to.r));
  return nearest < least ? `a way comes to R ${nearest}, where R ${least} is the least` : null;
};

const isRecess = (cycle: Cycle) => cycle.group === "recessTurning" || cycle.group === "recessing";
const says = (plan: Plan, ...codes: readonly string[]) => plan.issues.some((i) => codes.includes(i.code));
const failed = (plan: Plan) => plan.moves.length === 0 || plan.issues.some((i) => i.severity === "error");
/** The distance of a point out of the material. */
const heightIn =
  ({ openSide }: Plan) =>
  (p: Pt): number =>
    p.z * openSide.z + p.r * openSide.r;

/** The oversize on a floor. */
const keptOn = (s: Situation, plan: Plan): number =>
  plan.openSide.z === 0 ? (s.values["Q483"] ?? 0) / 2 : (s.values["Q484"] ?? 0);

/** A recess that the tool fits into, exactly or with clearance, is roughed down to its floor. */
const floorsAreReached: PlanLaw = (cycle, s, plan) => {
  if (!isRecess(cycle) || cycle.contour !== "own" || !roughs(s) || (s.values["Q500"] ?? 0) > 0) return null;
  if (plan.issues.some((i) => i.severity === "error") || says(plan, "recessNarrowerThanTool", "depthOverCutLength"))
    return null;
  const height = heightIn(plan);
  const floor = Math.min(...plan.contour.map((e) => height(e.to))) + keptOn(s, plan);
  if (floor > Math.max(...plan.contour.map((e) => height(e.to))) - SAME) return null;
  const deepest = Math.min(...plan.moves.flatMap((m) => (m.phase === "rough" ? [height(m.to)] : [])));
  return Math.abs(deepest - floor) > 3 * SAME
    ? `roughed down to ${deepest} where the floor with its oversize is ${floor}`
    : null;
};

/** CUTLENGTH counts from the material, not from the start point above it. */
const cutLengthCountsInMaterial: PlanLaw = (cycle, s, plan) => {
  const edge = s.tool.CUTLENGTH ?? 0;
  if (!isRecess(cycle) || !says(plan, "depthOverCutLength")) return null;
  const height = heightIn(plan);
  const depth =
    Math.max(...s.blank.flat().map(height)) - Math.min(...part.flattenedChain(plan.contour, SAME / 10).map(height));
  return depth < edge - SAME ? `a depth of ${depth} is too much for an edge of ${edge}` : null;
};

/** The tool leaves a recess at the height of the start point, no higher, and returns to it at rapid. */
const recessesAreLeftAsPrinted: PlanLaw = (cycle, s, plan) => {
  if (!isRecess(cycle) || failed(plan)) return null;
  const height = heightIn(plan);
  // A contour that keeps its oversize is higher by it.
  const over = s.values["Q215"] === 3 ? keptOn(s, plan) : 0;
  const top = Math.max(height(s.start), ...part.flattenedChain(plan.contour, SAME / 10).map((p) => height(p) + over));
  const higher = plan.moves.find((m) => m.kind !== "arc" && height(m.to) > top + 2 * SAME);
  if (higher) return `up to ${height(higher.to)} where the start point stands at ${top}`;
  const last = plan.moves.at(-1);
  const printed = cycle.contour === "own" && !says(plan, "startBelowContour");
  return printed && last?.phase === "position" && last.kind !== "rapid"
    ? `back to the start point by ${last.kind}`
    : null;
};

/** A recess has the same path in any blank; only an edge that is too short for the depth depends on the blank. */
const recessesIgnoreTheBlank: PlanLaw = (cycle, s, plan) => {
  if (!isRecess(cycle)) return null;
  const other = planOf(cycle, s, false);
  if ([plan, other].some((p) => says(p, "depthOverCutLength", "insertAcrossAxis"))) return null;
  return JSON.stringify(plan.moves) === JSON.stringify(other.moves)
    ? null
    : "another path where the blank is not known";
};

/** By name, so that a stored case can state the broken laws. */
export const planLaws: Readonly<Record<string, PlanLaw>> = {
  infeedsAreEven,
  passesAreNumbered,
  plungesAreLimited,
  pathIsBounded,
  divisionsAreExact,
  turnsRound,
  blankIsNoMatter: blankDoesNotMatter,
  boreStaysClear,
  floorsAreReached,
  cutLengthCountsInMaterial,
  recessesAreLeftAsPrinted,
  recessesIgnoreTheBlank,
};

/** Every path law that a situation breaks, with its message. */
export function brokenByPlan(cycle: Cycle, situation: Situation): string[] {
  const plan = planOf(cycle, situation);
  return Object.entries(planLaws).flatMap(([name, law]) => {
    const said = law(cycle, situation, plan);
    return said === null ? [] : [`${name}: ${said}`];
  });
}
