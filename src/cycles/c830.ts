import { issue } from "../kernel/plan/issue.ts";
import type { PlanContext } from "../kernel/plan/plan.ts";
import { defineCycle, type Given, type Outline } from "./define.ts";
import type { Setups } from "./random-setup.ts";
import { threadContourSetups } from "./random-thread.ts";
import { recalled, type Values } from "./params.ts";
import { refusedPlan } from "./refused-plan.ts";
import { threadDimensions, threadFrame } from "./thread-outline.ts";
import { oneGroove, threadParams, threadRoles } from "./thread-params.ts";
import { planThreadOn } from "./thread-plan.ts";

const { Q471, Q461, Q460, Q472, Q473, Q474, Q465, Q466, Q463, Q467, Q468, Q470, Q475, Q476 } = threadParams;
const params = recalled({ Q471, Q461, Q460, Q472, Q473, Q474, Q465, Q466, Q463, Q467, Q468, Q470, Q475, Q476 });

/** The contour of the subprogram as the line of a thread. */
function outlineOf(v: Values<typeof params>, { contour }: Given): Outline {
  const [first, last] = [contour?.[0]?.from, contour?.at(-1)?.to];
  const origin = { z: 0, r: 0 } as NonNullable<typeof first>;
  const frame = threadFrame(first ?? origin, last ?? origin, v.Q461 === 1, v.Q471 === 1);
  const none = { contour: contour ?? [], frame, sunk: false, dimensions: [], issues: [] };
  if (!contour) return { ...none, issues: [issue("contourMissing", "error", { label: "" }, "contour")] };
  if (!first || !last) return { ...none, issues: [issue("contourTooShort", "error", {}, "contour")] };
  return { ...none, dimensions: threadDimensions(v, first, last, frame), elements: contour.map((_, i) => i + 1) };
}

/** Thread along a free contour. */
export const c830 = defineCycle({
  number: 830,
  group: "thread",
  manual: null,
  evidence: "K1",
  contour: "free",
  params,
  setup: {
    name: "CONTOURTHREAD",
    tool: 12,
    blank: { outside: "80", bore: "", length: "90", allowance: "0" },
    start: { x: "90", z: "10" },
    // A cylinder: no set-up has a conical blank, and excess material would stand over the crest of a taper.
    contour: [
      { kind: "L", x: "80", z: "0" },
      { kind: "L", z: "-35" },
    ],
    values: oneGroove,
  },
  thread: threadRoles(),
  steps: { rough: 8, finish: 0 },
  outline: outlineOf,
  plan(v, setting: PlanContext, given) {
    const outline = outlineOf(v, given);
    return (
      refusedPlan(outline) ??
      planThreadOn(v, outline, { runIn: v.Q465, overrun: v.Q466, named: { crest: "contour" } }, setting)
    );
  },
});

/** Random set-ups for the laws. */
export const setups830: Setups = threadContourSetups;
