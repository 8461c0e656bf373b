import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { planning } from "../../src/planning/plan.ts";
import { handValuesOf } from "../../src/planning/hand-values.ts";
import type { PlanRequest } from "../../src/planning/types.ts";
import type { WorkingPlan } from "../../src/planning/working-plan.ts";
import { arbitraryParts } from "./arbitrary-part.ts";
import { barPart } from "./missing-parts.ts";
import { partOfTrade } from "./parts.ts";
import { brokenByPart, keysOf, planOf, requestOf, unprepared, withOwnTools } from "./plan-laws.ts";

const of = (name: string): PlanRequest => {
  const request = requestOf(partOfTrade(name));
  if (!request) throw new Error(name);
  return request;
};

const plans = new Map<string, WorkingPlan>();
/** The plan of a part from the built-in tools; each is searched once. */
function planned(name: string): WorkingPlan {
  const plan = plans.get(name) ?? planOf(of(name));
  plans.set(name, plan);
  return plan;
}

/** Parts whose plans take little time; `npm run laws -- --parts=N` tries all and random ones. */
test.each(["bolt", "dowel", "flange", "spacer", "spool", "thin-shaft"])("%s is made in one clamping", (name) => {
  const plan = planned(name);
  expect([plan.judged.verdict, plan.isComplete]).toEqual(["proved", true]);
  expect(unprepared(plan)).toEqual([]);
  expect([...keysOf(plan), `${plan.seconds.toFixed(0)} s`, `T${plan.tools.join(" T")}`].join("\n")).toMatchSnapshot();
});

test("a thread on the bare bar is found to be not prepared", () => {
  const plan = planned("bolt");
  const [first, ...others] = plan.steps.toSorted(
    (a, b) => Number(b.tried.action.kind === "thread") - Number(a.tried.action.kind === "thread"),
  );
  expect(unprepared({ ...plan, steps: first ? [first, ...others] : [] })).toContain(
    `not prepared: ${first?.tried.action.key}`,
  );
});

/** Features of random parts whose plans take little time. */
const FEW = 4;

test("plans of random parts keep the laws", () => {
  fc.assert(
    fc.property(
      arbitraryParts.filter(({ features }) => features.length <= FEW),
      ({ part }) => {
        const request = requestOf(part);
        expect(request ? brokenByPart(request) : []).toEqual([]);
      },
    ),
    { numRuns: 2 },
  );
});

describe("a plan that exists", () => {
  const request = of("spacer");
  const plan = planned("spacer");

  test("is kept when nothing changed, with fewer tries", () => {
    const again = planOf(request, { keep: keysOf(plan) });
    expect(keysOf(again)).toEqual(keysOf(plan));
    expect(again.tries).toBeLessThan(plan.tries);
  });

  test("is kept up to the first step that a change concerns", () => {
    const last = plan.steps.at(-1)?.tried.action.tool.T ?? 0;
    const first = plan.steps.findIndex(({ tried }) => tried.action.tool.T === last);
    const changed = planOf({ ...request, withoutTools: [last] }, { keep: keysOf(plan) });
    expect(keysOf(changed).slice(0, first)).toEqual(keysOf(plan).slice(0, first));
    expect(changed.tools).not.toContain(last);
  });

  test("makes what it left before the part is off its bar", () => {
    const keep = keysOf(plan).filter((key) => !key.startsWith("finishInside"));
    expect(keep.at(-1)).toContain("partOff");
    expect(planOf(request, { keep }).isComplete).toBe(true);
  });

  test("takes another way, and keeps it when something else changes", () => {
    const at = plan.steps.findIndex(({ others }) => others.length > 0);
    const actionKey = plan.steps[at]?.others[0]?.tried.action.key ?? "";
    const other = planOf(request, { keep: keysOf(plan), instead: { at, actionKey } });
    expect(other.steps[at]).toMatchObject({ isByHand: true, tried: { action: { key: actionKey } } });
    expect(other.steps[at]?.why).toContainEqual({ kind: "byHand" });
    expect(keysOf(planOf(request, { keep: keysOf(other), hand: { [actionKey]: {} } }))[at]).toBe(actionKey);
  });

  test("keeps values that were changed by hand", () => {
    const key = plan.steps.find(({ tried }) => tried.action.kind === "roughOutside")?.tried.action.key ?? "";
    const hand = { [key]: { Q478: 0.11 } };
    const changed = planOf(request, { keep: keysOf(plan), hand });
    expect(changed.text).toContain("Q478=+0.11 ");
    const step = changed.steps.find(({ tried }) => tried.action.key === key);
    expect(step?.isByHand).toBe(true);
    expect(step && handValuesOf(step.tried.action)).toEqual(hand[key]);
    // The same decisions make the same plan, and without them it is the former one.
    expect(planOf(request, { keep: keysOf(changed), hand }).text).toBe(changed.text);
    expect(planOf(request, { keep: keysOf(plan) }).text).toBe(plan.text);
  });
});

test("what is left says which tool is missing, or what is excluded", () => {
  const request = of("bush");
  const bore = planOf(withOwnTools(request)).residue.find(({ site }) => site === "inside");
  expect(bore).toMatchObject({ why: "tool", missing: { site: "inside", mostDiameter: expect.any(Number) as number } });
  const thread = of("bolt");
  const tools = thread.shop.tools.filter(({ TYPE }) => TYPE === "THREAD").map(({ T }) => T);
  expect(planOf({ ...thread, withoutTools: tools }).residue).toMatchObject([
    { region: null, thread: "M16", why: "excluded", missing: null },
  ]);
  // Between two collars no insert for threads has room: another one is not what is missing.
  const fine = [{ x: 0, z: 0 }, { x: 16 }, { id: "fine", z: -14 }];
  const between = [{ x: 30 }, { z: -20 }, { x: 16 }, { id: "thread", z: -28 }, { x: 30 }, { z: -34 }];
  const marks = { fine: { thread: "M16x1.5" }, thread: { thread: "M16" } };
  const collared = requestOf(barPart("COLLARED", [...fine, ...between], { marks }));
  expect(collared && planOf(collared).residue).toMatchObject([{ thread: "M16", why: "fault", missing: null }]);
});

test("a search says how far it is at every try", () => {
  const told = [...planning(of("thin-shaft"))];
  expect(told.map(({ tries }) => tries)).toEqual(told.map(({ tries }) => tries).toSorted((a, b) => a - b));
  expect(told.at(-1)).toMatchObject({ done: expect.any(Array) as unknown[], left: expect.any(Number) as number });
});
