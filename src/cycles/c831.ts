import { part, type Pt } from "../kernel/geometry/point.ts";
import { toRadius } from "../kernel/units.ts";
import { defineCycle, type Outline, printedContour } from "./define.ts";
import type { Setups } from "./random-setup.ts";
import { threadSetups } from "./random-thread.ts";
import { diameterParam, exampleOf, lengthParam, recalled, type Values } from "./params.ts";
import { refusedPlan } from "./refused-plan.ts";
import { straightThread } from "./thread-outline.ts";
import { oneGroove, threadParams, threadRoles } from "./thread-params.ts";
import { planThreadOn } from "./thread-plan.ts";

const { Q471, Q472, Q473, Q492, Q494, Q474, Q463, Q467, Q468, Q470, Q475, Q476 } = threadParams;

const params = recalled({
  Q471,
  Q460: lengthParam("clearanceRunIn", [0, 999.999], 5, { incremental: true, shown: "clearance" }),
  Q491: diameterParam("threadDiameter", [-99999.999, 99999.999], 75),
  Q472,
  Q473,
  Q492,
  Q494: exampleOf(Q494, -15),
  Q474,
  Q463,
  Q467,
  Q468,
  Q470,
  Q475,
  Q476,
});

/** The thread as a line on its nominal diameter. */
function outlineOf(v: Values<typeof params>): Outline {
  const ends: [Pt, Pt] = [part.point(v.Q492, toRadius(v.Q491)), part.point(v.Q494, toRadius(v.Q491))];
  return straightThread(v, v, ends, false, [
    { q: "Q491", form: "diameter", at: ends[0] },
    {
      q: "Q492",
      form: "z",
      from: part.point(0, ends[0].r),
      to: ends[0],
    },
    { q: "Q494", form: "z", from: part.point(0, ends[1].r), to: ends[1] },
  ]);
}

/** Thread on a cylinder. Its run-in is the set-up clearance, its overrun one turn of the spindle. */
export const c831 = defineCycle({
  number: 831,
  group: "thread",
  manual: null,
  evidence: "K1",
  contour: "own",
  params,
  setup: {
    name: "THREAD",
    tool: 12,
    blank: { outside: "75", bore: "", length: "100", allowance: "0" },
    start: { x: "85", z: "10" },
    contour: printedContour,
    values: oneGroove,
  },
  thread: threadRoles("Q491"),
  steps: { rough: 8, finish: 0 },
  outline: outlineOf,
  plan(v, setting) {
    const outline = outlineOf(v);
    return (
      refusedPlan(outline) ??
      planThreadOn(v, outline, { runIn: v.Q460, overrun: v.Q472, named: { runIn: "Q460", overrun: "Q494" } }, setting)
    );
  },
});

/** Random set-ups for the laws. */
export const setups831: Setups = (draw) => {
  const drawn = threadSetups(draw, false);
  if (!drawn) return null;
  const { Q465, ...values } = drawn.values;
  return { ...drawn, values: { ...values, Q460: Q465 ?? 5 } };
};
