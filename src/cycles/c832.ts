import { part } from "../kernel/geometry/point.ts";
import type { Given } from "./define.ts";
import { defineCycle, printedContour } from "./define.ts";
import type { Setups } from "./random-setup.ts";
import { threadSetups } from "./random-thread.ts";
import { recalled, type Values } from "./params.ts";
import { refusedPlan } from "./refused-plan.ts";
import { straightThread, taperEnds } from "./thread-outline.ts";
import { oneGroove, threadParams, threadRoles } from "./thread-params.ts";
import { planThreadOn } from "./thread-plan.ts";

const {
  Q471,
  Q461,
  Q460,
  Q472,
  Q473,
  Q464,
  Q491,
  Q492,
  Q493,
  Q494,
  Q469,
  Q474,
  Q465,
  Q466,
  Q463,
  Q467,
  Q468,
  Q470,
  Q475,
  Q476,
} = threadParams;
const params = recalled({
  Q471,
  Q461,
  Q460,
  Q472,
  Q473,
  Q464,
  Q491,
  Q492,
  Q493,
  Q494,
  Q469,
  Q474,
  Q465,
  Q466,
  Q463,
  Q467,
  Q468,
  Q470,
  Q475,
  Q476,
});

/** The line of the thread with its dimensions, from two points or from one and an angle. */
function outlineOf(v: Values<typeof params>, given: Given) {
  const { from, to, issues } = taperEnds(v, given.start);
  const transverse = v.Q461 === 1;
  const along = part.point(to.z, from.r);
  const outline = straightThread(v, v, [from, to], transverse, [
    { q: "Q491", form: "diameter", at: from },
    { q: "Q492", form: "z", from: part.point(0, from.r), to: from },
    { q: "Q493", form: "diameter", at: to },
    { q: "Q494", form: "z", from: part.point(0, to.r), to },
    { q: "Q469", form: "angle", vertex: from, from: along, to },
  ]);
  return issues.length > 0 ? { ...outline, contour: [], dimensions: [], issues } : outline;
}

/** Thread on a cylinder, a cone or a face, with its own run-in and overrun. */
export const c832 = defineCycle({
  number: 832,
  group: "thread",
  manual: null,
  evidence: "K1",
  contour: "own",
  params,
  setup: {
    name: "TAPERTHREAD",
    tool: 12,
    // A slight taper: over the crest of a steeper one the cylindrical blank would be higher than the tooth of an
    // insert.
    blank: { outside: "102", bore: "", length: "100", allowance: "0" },
    start: { x: "112", z: "10" },
    contour: printedContour,
    values: { ...oneGroove, Q493: 102 },
  },
  thread: { ...threadRoles("Q491", "Q493"), line: { form: "Q464", startZ: "Q492", endZ: "Q494" } },
  steps: { rough: 8, finish: 0 },
  outline: outlineOf,
  plan(v, setting) {
    const outline = outlineOf(v, { contour: null, start: setting.start });
    return refusedPlan(outline) ?? planThreadOn(v, outline, { runIn: v.Q465, overrun: v.Q466 }, setting);
  },
});

/** Random set-ups for the laws. */
export const setups832: Setups = (draw) => threadSetups(draw, true);
