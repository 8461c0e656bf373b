import type { Cycle } from "../../cycles/define.ts";
import type { Param, Params, Values } from "../../cycles/params.ts";
import { worksAcross } from "../../cycles/use.ts";
import { beginsAtTip } from "../../cycles/shape-request.ts";
import { boxAround } from "../../kernel/area/box.ts";
import { issue, type Issue } from "../../kernel/plan/issue.ts";
import { noseRadius } from "../../kernel/cutter/insert.ts";
import { fixesFinding } from "../../kernel/plan/offer.ts";
import type { PlanContext } from "../../kernel/plan/plan.ts";
import { SAME } from "../../kernel/tolerance.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { toDiameter, radius } from "../../kernel/units.ts";
import type { Judge } from "./tested-offers.ts";

/** Tips that point away from the chuck: such a tool is chosen to work that way. */
const AWAY: ReadonlySet<number> = new Set([3, 4, 5]);
/** A contour may start this far in front of the blank, mm: its first cut begins in the air. */
const AHEAD = 5;

/** A face may end this far beyond the axis beside the nose of the insert, on the diameter, mm: no pip is left. */
const PAST_AXIS = 2;

/** Ends of the blank along Z, in program coordinates. */
interface BlankExtent {
  readonly front: number;
  readonly back: number;
}

/** Data to detect an end in front of the blank. */
export interface EndCheckInput {
  readonly cycle: Cycle;
  /** Valid values, by Q. */
  readonly values: Readonly<Partial<Record<string, number | "auto">>>;
  /** Z of the contour's start and end. */
  readonly from: number;
  readonly to: number;
  /** Null while the blank is unset or unknown. */
  readonly blank: (Pick<BlankExtent, "front"> & Partial<BlankExtent>) | null;
  /** Null while none is chosen. */
  readonly tool: Tool | null;
}

/** Parameters with the position of a contour in X, or in Z. */
export const endsAlong = (cycle: Cycle, kind: "diameter" | "axial"): readonly string[] =>
  Object.entries<Param>(cycle.params)
    .filter(([, p]) => p.kind === kind && p.drawn && !p.incremental)
    .map(([q]) => q);

const parameterWith = (cycle: Cycle, text: Param["text"]): string | undefined =>
  Object.keys(cycle.params).find((name) => cycle.params[name]?.text === text);

/**
 * Reports an end in front of its start and of the blank: no material is there, so its minus sign is probably missing.
 */
export function endInFront({ cycle, values, from, to, blank, tool }: EndCheckInput): Issue | null {
  const q = parameterWith(cycle, "endZ"),
    value = q === undefined ? undefined : values[q];
  if (q === undefined || typeof value !== "number" || !(value > 0) || to <= from || -value >= from) return null;
  if (endsAlong(cycle, "axial").some((name) => typeof values[name] !== "number")) return null;
  if (blank && value <= blank.front + SAME) return null;
  if (blank?.back !== undefined && -value < blank.back - SAME) return null;
  if (tool && AWAY.has(tool.TO)) return null;
  return issue("endInFront", "warning", { value, nearest: -value }, q);
}

/**
 * Reports a start far in front of the blank, with the end inside it: with a minus sign the whole contour is in the blank.
 */
export function startInFront({ cycle, values, to, blank }: Omit<EndCheckInput, "from" | "tool">): Issue | null {
  const q = parameterWith(cycle, "startZ"),
    value = q === undefined ? undefined : values[q];
  if (q === undefined || typeof value !== "number" || !blank) return null;
  if (value <= Math.max(0, blank.front) + AHEAD || to > blank.front || -value <= to) return null;
  return issue("startInFront", "warning", { value, nearest: -value }, q);
}

/** Exchangeable start and end parameters of an axis; null where a cycle has only one of them, or takes any order. */
function endsOf(cycle: Cycle, axis: "X" | "Z"): readonly [string, string] | null {
  const isGroove = cycle.group === "recessTurning" || cycle.group === "recessing",
    across = worksAcross(cycle);
  if (cycle.thread || (isGroove && (axis === "X") === across)) return null;
  const [start, end, ...more] = endsAlong(cycle, axis === "X" ? "diameter" : "axial");
  return start !== undefined && end !== undefined && more.length === 0 ? [start, end] : null;
}

/**
 * Reports ends along Z in the order of a cut away from the chuck, unless a chosen tool or start point belongs to one.
 */
export function endsExchangedAlong(
  cycle: Cycle,
  values: EndCheckInput["values"],
  tool: Tool | null,
  startZ: number | null,
): Issue | null {
  const [a, b] = endsOf(cycle, "Z") ?? [];
  const [start, end] = [values[a ?? ""], values[b ?? ""]];
  if (a === undefined || b === undefined || typeof start !== "number" || typeof end !== "number") return null;
  if (end <= start || (tool && AWAY.has(tool.TO)) || (startZ !== null && startZ < end - SAME)) return null;
  return issue("endsExchanged", tool ? "error" : "warning", { axis: "Z", start, end, other: b }, a);
}

/** Reports a diameter of the drawing larger than the blank. */
function diameterOutside(cycle: Cycle, values: EndCheckInput["values"], blank: number) {
  const sizes = endsAlong(cycle, "diameter").map((at) => ({ at, value: Number(values[at] ?? 0) }));
  const { at, value } = sizes.reduce((most, each) => (each.value > most.value ? each : most), { at: "", value: blank });
  if (value <= blank + SAME) return null;
  return { at, code: "diameterOutside", severity: "error", data: { value, blank } } as const;
}

const isSame = (a: Issue, b: Issue): boolean => a.code === b.code && a.at === b.at;

const isRefused = (issues: readonly Issue[]): boolean => issues.some(({ severity }) => severity === "error");

/** Data of a cycle call. */
export interface SlipCheckInput<P extends Params> {
  readonly cycle: Cycle<P>;
  readonly values: Values<P>;
  readonly setting: Pick<PlanContext, "tool" | "start" | "blank" | "solid">;
  readonly judge: Judge<P>;
  /** Issues of the outline and of the plan for the values. */
  readonly outlined: readonly Issue[];
  readonly planned: readonly Issue[];
}

/**
 * Finds a dimension whose sign or order is impossible for tool and blank. Reported only where the other sign brings no
 * new error, or the other order, or a value in the blank none at all. It explains all findings of tool and path; contour faults that remain
 * either way follow it. Null where the values may be intended.
 */
export function dimensionSlip<P extends Params>(asked: SlipCheckInput<P>): readonly Issue[] | null {
  const { cycle, values, setting, judge, outlined } = asked;
  if (cycle.contour !== "own") return null;
  const found = [...outlined, ...asked.planned];
  const typed = values as Readonly<Record<string, number | "auto">>;
  const numberOf = (q: string) => (typeof typed[q] === "number" ? typed[q] : 0);
  const judged = (changed: Readonly<Record<string, number>>) =>
    judge({ ...typed, ...changed } as unknown as Values<P>).issues;
  const { tool, start, solid, blank: rings } = setting,
    box = rings?.length ? boxAround(rings) : null;
  const plain = cycle as unknown as Cycle;
  const z = endsOf(plain, "Z"),
    q = parameterWith(plain, "endZ");
  const from =
    beginsAtTip(plain) || !endsAlong(plain, "axial")[1] ? start.z : numberOf(endsAlong(plain, "axial")[0] ?? "");
  const reach = box && { front: box.right, back: box.left };
  const severity = isRefused(found) ? ("error" as const) : ("warning" as const);
  const inFront =
    q === undefined ? null : endInFront({ cycle: plain, values: typed, from, to: numberOf(q), blank: reach, tool });
  const begun = q === undefined ? null : startInFront({ cycle: plain, values: typed, to: numberOf(q), blank: reach });
  for (const asked of [inFront, begun]) {
    if ((asked?.code !== "endInFront" && asked?.code !== "startInFront") || asked.at === undefined) continue;
    const after = judged({ [asked.at]: asked.data.nearest });
    if (fixesFinding(asked, found, after))
      return [{ ...asked, severity }, ...outlined.filter((each) => after.some((a) => isSame(a, each)))];
  }
  const past = severity === "error" ? 0 : PAST_AXIS + 2 * noseRadius(tool);
  for (const at of endsAlong(plain, "diameter")) {
    const value = numberOf(at);
    if (value >= -past) continue;
    const asked = issue("diameterNegative", severity, { value, nearest: -value }, at);
    const after = judged({ [at]: -value });
    if (fixesFinding(asked, found, after))
      return [asked, ...outlined.filter((each) => each.at !== at && after.some((a) => isSame(a, each)))];
  }
  // With a tool for that direction, the order is intended.
  if (!box || severity === "warning") return null;
  const isInBlank = (axis: "X" | "Z", ...ends: readonly number[]) =>
    axis === "X" ? Math.max(...ends) <= toDiameter(radius(box.high)) + SAME : Math.min(...ends) >= box.left - SAME;
  const exchanged = (
    axis: "X" | "Z",
    [a, b]: readonly [string, string],
    isImpossible: (first: number, last: number) => boolean,
  ) => {
    const [first, last] = [numberOf(a), numberOf(b)];
    if (!isInBlank(axis, first, last) || !isImpossible(first, last) || isRefused(judged({ [a]: last, [b]: first })))
      return null;
    return issue("endsExchanged", "error", { axis, start: first, end: last, other: b }, a);
  };
  const surface = toDiameter(radius(box.high)),
    outside = diameterOutside(plain, typed, surface);
  if (outside && !isRefused(judged({ [outside.at]: surface / 2 }))) return [outside];
  const x = endsOf(plain, "X"),
    bore = toDiameter(radius(box.low));
  const isSolid =
    bore <= SAME && (solid === null || solid === undefined || (!solid.isBored && solid.below === Infinity));
  const order =
    (z &&
      !AWAY.has(tool.TO) &&
      exchanged(
        "Z",
        z,
        (first, last) =>
          last > first && (start.z >= last - SAME || (last >= box.right - SAME && first < box.right - SAME)),
      )) ||
    (x && exchanged("X", x, (first, last) => (first < last ? isSolid : bore > SAME && last <= bore + SAME)));
  if (order) return [order];
  const [first, last] = x ?? [];
  // From inside a solid blank no tool gets to a larger diameter.
  if (first === undefined || !isSolid || !(numberOf(first) < numberOf(last ?? ""))) return null;
  return isRefused(judged({ [first]: surface }))
    ? null
    : [issue("diameterInSolid", "error", { value: numberOf(first) }, first)];
}
