import { expect, test } from "vitest";
import { actionSources } from "../../src/planning/actions/index.ts";
import { newPart } from "../../src/planning/part/finished-part.ts";
import type { Action, ActionSource } from "../../src/planning/types.ts";
import { newRow } from "../../src/program/job/job.ts";
import { keysOf, planOf, requestOf } from "./plan-laws.ts";

/** A blind bore with the bottom that a drill leaves. */
const request = requestOf({
  ...newPart("CUP"),
  outside: [newRow("e1", { x: "0", z: "0" }), newRow("e2", { x: "50" }), newRow("e3", { z: "-45" })],
  inside: [newRow("i1", { x: "21", z: "0" }), newRow("i2", { z: "-31" }), newRow("i3", { x: "0", z: "-37.309" })],
  blank: { outside: "52", bore: "0", length: "80", allowance: "1" },
  unmachinedBehind: true,
});

/** Finishing of a bore whose contour ends where the nose still stands in the material: with its last row left out. */
const endsInMaterial = (action: Action): Action =>
  action.job.contour.length > 2
    ? { ...action, job: { ...action.job, contour: action.job.contour.slice(0, -1) } }
    : action;
const sources: readonly ActionSource[] = actionSources.map((source) =>
  source.kind === "finishInside"
    ? { ...source, actions: (state, asked) => source.actions(state, asked).map(endsInMaterial) }
    : source,
);

test("an operation that only the whole program shows to be at fault is left out", () => {
  if (!request) throw new Error("no part");
  const { judged, steps } = planOf(request, {}, sources);
  expect(judged.verdict).toBe("proved");
  expect(steps.length).toBeGreaterThan(1);
});

test("a bore is made as far as a kept plan of it goes on", () => {
  // The insert that the improved plan has for the wall leaves more of the cone than the one of the search.
  const wide = requestOf({
    ...newPart("CUP"),
    material: "42crmo4",
    outside: [newRow("e1", { x: "0", z: "0" }), newRow("e2", { x: "42" }), newRow("e3", { z: "-45" })],
    inside: [newRow("i1", { x: "26", z: "0" }), newRow("i2", { z: "-22" }), newRow("i3", { x: "0", z: "-29.811" })],
    blank: { outside: "62", bore: "0", length: "80", allowance: "1" },
    general: { tolerance: "ISO 2768-m", ra: 3.2 },
    unmachinedBehind: true,
  });
  if (!wide) throw new Error("no part");
  const plan = planOf(wide);
  expect(keysOf(planOf(wide, { keep: keysOf(plan) }))).toEqual(keysOf(plan));
});
