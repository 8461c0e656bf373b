import { describe, expect, test } from "vitest";
import { face } from "../../src/planning/actions/face.ts";
import { finishOutside } from "../../src/planning/actions/finish-outside.ts";
import { roughOutside } from "../../src/planning/actions/rough-outside.ts";
import type { FinishedPart } from "../../src/planning/part/finished-part.ts";
import { Trade } from "../../src/planning/trade-rules.ts";
import type { PlanRequest, PlanState } from "../../src/planning/types.ts";
import { partByHand, PROGRAMMED_BY_HAND } from "./by-hand.ts";
import { partOfTrade } from "./parts.ts";
import { planOf, requestOf, withOwnTools } from "./plan-laws.ts";

const request = (part: FinishedPart): PlanRequest => {
  const made = requestOf(part);
  if (!made) throw new Error(part.name);
  return made;
};

const taught = (wanted: string): FinishedPart => {
  const made = PROGRAMMED_BY_HAND.find(({ name }) => name === wanted);
  if (!made) throw new Error(wanted);
  return partByHand(made);
};

const blankOf = ({ blank }: PlanRequest): PlanState => ({ stock: blank, done: [], threads: new Set() });

/** Tools by letters in the order of their first use: steps with the same letter have the same tool. */
const lettered = (tools: readonly number[]): string =>
  tools.map((T) => String.fromCharCode(65 + [...new Set(tools)].indexOf(T))).join("");

describe("a plan as a setter makes it", () => {
  const plans: readonly (readonly [says: string, part: FinishedPart, kinds: string, tools: string])[] = [
    [
      "one insert faces, roughs into the valley and finishes",
      partOfTrade("spool"),
      "face roughOutside finishOutside partOff",
      "AAAB",
    ],
    [
      "one insert makes undercuts and contour",
      partOfTrade("bolt"),
      "face roughOutside finishOutside thread partOff",
      "AABCD",
    ],
    [
      "a rest of roughing over a groove holds nothing back and is recessed with it",
      taught("l22-clamp-shaft"),
      "roughOutside recess finishOutside thread",
      "ABCD",
    ],
    ["one insert faces a hollow and finishes it", taught("l12-820-contour"), "roughOutside finishOutside", "AA"],
  ];

  test.each(plans)("%s", (_, part, kinds, tools) => {
    const plan = planOf(request(part));
    const actions = plan.steps.map(({ tried }) => tried.action);
    expect(actions.map(({ kind }) => kind).join(" ")).toBe(kinds);
    expect(lettered(actions.map(({ tool }) => tool.T))).toBe(tools);
    expect([plan.judged.verdict, plan.isComplete]).toEqual(["proved", true]);
  });
});

test("inserts for finishing may rough, at the price of their wear", () => {
  const asked = request(partOfTrade("spool"));
  const trade = new Trade(asked);
  const state = blankOf(asked);
  const [facing, rough, finish] = [face, roughOutside, finishOutside].map((source) => source.actions(state, asked));
  expect(new Set(rough?.map(({ tool }) => tool.TYPE))).toEqual(new Set(["ROUGH", "FINISH"]));
  for (const action of rough ?? []) expect(trade.wear(action, 20)).toBe(action.tool.TYPE === "FINISH" ? 20 : 0);
  for (const action of [...(facing ?? []), ...(finish ?? [])]) expect(trade.wear(action, 20)).toBe(0);
});

test("a hollow in a face is offered to inserts that reach it, for roughing and finishing", () => {
  const asked = withOwnTools(request(taught("l12-820-contour")));
  const state = blankOf(asked);
  const toolsInto = [roughOutside, finishOutside].map((source) => {
    const actions = source.actions(state, asked);
    const deepest = Math.max(...actions.map(({ job }) => job.contour.length));
    return new Set(actions.filter(({ job }) => job.contour.length === deepest).map(({ tool }) => tool.T));
  });
  expect(toolsInto).toEqual([new Set([15]), new Set([15])]);
});
