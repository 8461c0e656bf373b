import type { Cycle } from "../../cycles/define.ts";
import type { Param, Params, Values } from "../../cycles/params.ts";
import { worksAcross } from "../../cycles/use.ts";
import { beginsAtTip } from "../../cycles/wanted.ts";
import { boxAround } from "../../kernel/area/box.ts";
import { issue, type Issue } from "../../kernel/plan/issue.ts";
import { mends } from "../../kernel/plan/offer.ts";
import type { Setting } from "../../kernel/plan/plan.ts";
import { SAME } from "../../kernel/tolerance.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { toDiameter, radius } from "../../kernel/units.ts";
import type { Judge } from "./tried.ts";

/** Tips that point away from the chuck: whoever takes such a tool means to work that way. */
const AWAY: ReadonlySet<number> = new Set([3, 4, 5]);
/** A contour begins this far in front of the blank at most, mm. */
const AHEAD = 5;

/** The ends of the blank along Z, as the program counts. */
interface Reach {
  readonly front: number;
  readonly back: number;
}

/** What an end in front of the work shows in. */
export interface EndAsked {
  readonly cycle: Cycle;
  /** The values that can be used, by Q. */
  readonly values: Readonly<Partial<Record<string, number | "auto">>>;
  /** Z where the contour begins and ends. */
  readonly from: number;
  readonly to: number;
  /** Null where nobody has set the blank, or nobody knows it. */
  readonly blank: (Pick<Reach, "front"> & Partial<Reach>) | null;
  /** Null where nobody has chosen it. */
  readonly tool: Tool | null;
}

/** The parameters that say where a contour lies in X, or in Z. */
export const endsAlong = (cycle: Cycle, kind: "diameter" | "axial"): readonly string[] =>
  Object.entries<Param>(cycle.params)
    .filter(([, p]) => p.kind === kind && p.drawn && !p.incremental)
    .map(([q]) => q);

const endOf = (cycle: Cycle): string | undefined =>
  Object.keys(cycle.params).find((name) => cycle.params[name]?.text === "endZ");

/**
 * An end that lies in front of its start and of the blank, where there is no material unless its minus was forgotten.
 */
export function endInFront({ cycle, values, from, to, blank, tool }: EndAsked): Issue | null {
  const q = endOf(cycle),
    value = q === undefined ? undefined : values[q];
  if (q === undefined || typeof value !== "number" || !(value > 0) || to <= from || -value >= from) return null;
  if (endsAlong(cycle, "axial").some((name) => typeof values[name] !== "number")) return null;
  if (blank && (value <= blank.front + SAME || from > blank.front + AHEAD)) return null;
  if (blank?.back !== undefined && -value < blank.back - SAME) return null;
  if (tool && AWAY.has(tool.TO)) return null;
  return issue("endInFront", "warning", { value, nearest: -value }, q);
}

/**
 * The two parameters of an axis that can be exchanged; null where a cycle has only one of them, or takes them in any
 * order.
 */
function endsOf(cycle: Cycle, axis: "X" | "Z"): readonly [string, string] | null {
  const isGroove = cycle.group === "recessTurning" || cycle.group === "recessing",
    across = worksAcross(cycle);
  if (cycle.thread || (isGroove && (axis === "X") === across)) return null;
  const [start, end, ...more] = endsAlong(cycle, axis === "X" ? "diameter" : "axial");
  return start !== undefined && end !== undefined && more.length === 0 ? [start, end] : null;
}

const isSame = (a: Issue, b: Issue): boolean => a.code === b.code && a.at === b.at;

const isRefused = (issues: readonly Issue[]): boolean => issues.some(({ severity }) => severity === "error");

/** What is known where a cycle is called. */
export interface CallAsked<P extends Params> {
  readonly cycle: Cycle<P>;
  readonly values: Values<P>;
  readonly setting: Pick<Setting, "tool" | "start" | "blank" | "solid">;
  readonly judge: Judge<P>;
  /** What the outline says to the values as they are, and what the plan says. */
  readonly outlined: readonly Issue[];
  readonly planned: readonly Issue[];
}

/**
 * A dimension of the drawing whose sign, or whose order with another one, is impossible for tool and blank: it is asked
 * for only where the other sign brings no new error, or the other order none at all. It explains whatever tool and path
 * say; behind it stands what is wrong with the contour in either case. Null where the values can be meant.
 */
export function slipAtCall<P extends Params>(asked: CallAsked<P>): readonly Issue[] | null {
  const { cycle, values, setting, judge, outlined } = asked;
  if (cycle.contour !== "own") return null;
  const found = [...outlined, ...asked.planned];
  const typed = values as Readonly<Record<string, number | "auto">>;
  const numberOf = (q: string) => (typeof typed[q] === "number" ? typed[q] : 0);
  const judged = (changed: Readonly<Record<string, number>>) =>
    judge({ ...typed, ...changed } as unknown as Values<P>).issues;
  const { tool, start, solid, blank: rings } = setting,
    box = rings ? boxAround(rings) : null;
  const plain = cycle as unknown as Cycle;
  const z = endsOf(plain, "Z"),
    q = endOf(plain);
  const from =
    beginsAtTip(plain) || !endsAlong(plain, "axial")[1] ? start.z : numberOf(endsAlong(plain, "axial")[0] ?? "");
  const reach = box && { front: box.right, back: box.left };
  const severity = isRefused(found) ? ("error" as const) : ("warning" as const);
  const inFront =
    q === undefined ? null : endInFront({ cycle: plain, values: typed, from, to: numberOf(q), blank: reach, tool });
  if (inFront?.code === "endInFront" && inFront.at !== undefined) {
    const after = judged({ [inFront.at]: inFront.data.nearest });
    if (mends(inFront, found, after))
      return [{ ...inFront, severity }, ...outlined.filter((each) => after.some((a) => isSame(a, each)))];
  }
  // Whoever takes a tool that does it means the order.
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
  const x = endsOf(plain, "X"),
    bore = toDiameter(radius(box.low));
  const isSolid =
    bore <= SAME && (solid === null || solid === undefined || (!solid.isBored && solid.below === Infinity));
  const order =
    (z &&
      !AWAY.has(tool.TO) &&
      exchanged("Z", z, (first, last) => last > first && last >= box.right - SAME && first < box.right - SAME)) ||
    (x && exchanged("X", x, (first, last) => (first < last ? isSolid : bore > SAME && last <= bore + SAME)));
  return order ? [order] : null;
}
