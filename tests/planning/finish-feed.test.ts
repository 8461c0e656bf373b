import { expect, test } from "vitest";
import { noseRadius } from "../../src/kernel/cutter/insert.ts";
import { finishOutside } from "../../src/planning/actions/finish-outside.ts";
import { roughOutside } from "../../src/planning/actions/rough-outside.ts";
import { applyAction } from "../../src/planning/apply-action.ts";
import type { Action, PlanRequest, PlanState } from "../../src/planning/types.ts";
import { rzOf } from "../../src/planning/values/turning-values.ts";
import { feedForRz } from "../../src/report/advice/formulas.ts";
import { partOfTrade } from "./parts.ts";
import { requestOf } from "./plan-laws.ts";

/** Finest Ra that a drawing asks of the elements in the place of an action, as Rz in µm. */
const finestIn = ({ place: { front, rear } }: Action, { part: { outside } }: PlanRequest): number =>
  Math.min(
    ...outside.segments.flatMap(({ from, to }, i) => {
      const { roughness } = outside.marks[i] ?? {};
      const middle = (from.z + to.z) / 2;
      if (middle > front || middle < rear) return [];
      return roughness === undefined ? [] : [rzOf({ kind: "Ra", value: roughness })];
    }),
  );

test.each(["bearing-seat", "shaft", "bolt"])(
  "no pass that finishes the %s is too fast for a mark in its place",
  (name) => {
    const request = requestOf(partOfTrade(name));
    if (!request) throw new Error(name);
    let state: PlanState = { stock: request.blank, done: [], threads: new Set() };
    let seen = 0;
    for (const source of [roughOutside, finishOutside]) {
      const tried = source.actions(state, request).map((action) => applyAction(action, state, request));
      const first = tried.find(({ works }) => works);
      if (first) state = { ...state, stock: first.stock, done: [...state.done, first] };
      for (const action of finishOutside.actions(state, request)) {
        const feed = Number(action.job.drafts[action.cycle ?? 0]?.["Q505"]);
        expect(feed).toBeLessThanOrEqual(feedForRz(finestIn(action, request), noseRadius(action.tool)) + 0.001);
        seen += 1;
      }
    }
    expect(seen).toBeGreaterThan(0);
  },
);
