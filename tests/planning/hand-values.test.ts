import { describe, expect, test } from "vitest";
import { tryValues } from "../../src/app/calculation/part-plan.ts";
import { actionSources } from "../../src/planning/actions/index.ts";
import { handValuesOf, settableValues, withHandValues } from "../../src/planning/hand-values.ts";
import { boxAround } from "../../src/kernel/area/box.ts";
import { intersection, union } from "../../src/kernel/area/clip.ts";
import { at } from "../../src/kernel/geometry/point.ts";
import type { Action, ActionKind, PlanRequest } from "../../src/planning/types.ts";
import { builtInTools } from "../../src/program/iso-codes/usual-tools.ts";
import { partOfTrade } from "./parts.ts";
import { requestOf } from "./plan-laws.ts";

/** The finished part on the rest of its bar. */
function onBar({ part }: PlanRequest) {
  const { left, high } = boxAround(part.rings);
  return union(part.rings, [[at(left - 20, 0), at(left, 0), at(left, high), at(left - 20, high)]]);
}

const FACED = [[at(-1000, 0), at(0, 0), at(0, 1000), at(-1000, 1000)]];

/** An operation of a kind on the faced blank, the last one on the finished part. */
function firstAction(name: string, kind: ActionKind): Action {
  const request = requestOf(partOfTrade(name));
  if (!request) throw new Error(name);
  const stock = kind === "partOff" ? onBar(request) : intersection(request.blank, FACED);
  const state = { stock, done: [], threads: new Set<string>() };
  const [action] = actionSources.filter((s) => s.kind === kind).flatMap((s) => s.actions(state, request));
  if (!action) throw new Error(`${name}: ${kind}`);
  return action;
}

/** Some values of each kind of operation: of a cycle, of a drilling cycle, and of path blocks. */
const CASES = [
  ["bush", "roughOutside", ["Q463", "Q478", "Q483", "speed", "limit", "start.x", "start.z"]],
  ["bush", "drill", ["Q206", "speed"]],
  ["knob", "partOff", ["feed", "speed"]],
] as const;

describe.each(CASES)("%s, %s", (name, kind, some) => {
  const action = firstAction(name, kind);
  const all = settableValues(action);

  test("has its values, and every planned value with a reason", () => {
    expect(all.map(({ q }) => q)).toEqual(expect.arrayContaining([...some]));
    for (const { q, value, planned, reason } of all) {
      expect([q, value]).toEqual([q, planned]);
      if (reason) expect([q, value]).toEqual([q, reason.value]);
    }
  });

  test.each(all.filter(({ field }) => !field.choices).map((each) => [each.q, each] as const))(
    "%s is set, shown and taken back",
    (q, { value, planned }) => {
      const set = { [q]: value + 0.5 };
      const changed = withHandValues(action, set);
      expect(handValuesOf(changed)).toEqual(set);
      expect(settableValues(changed).find((each) => each.q === q)).toMatchObject({ value: value + 0.5, planned });
      expect(withHandValues(changed, {})).toEqual(action);
      // Another set of values replaces the former one.
      expect(withHandValues(changed, { [q]: value + 1 })).toEqual(withHandValues(action, { [q]: value + 1 }));
    },
  );

  test("a value that it does not have changes nothing", () => {
    expect(withHandValues(action, { Q999: 1 })).toEqual(action);
  });
});

/** What an operation with such values takes, and what is said about it before they are applied. */
const SAID = [
  ["bush", "roughOutside", { Q463: 1 }, true, []],
  ["bush", "roughOutside", { "start.x": 50 }, false, ["toolUnfit"]],
] as const;

test.each(SAID)("%s, %s with %o is previewed", (name, kind, values, cuts, codes) => {
  const part = partOfTrade(name),
    request = requestOf(part);
  if (!request) throw new Error(name);
  const { usualTools = [], withoutTools, withoutCycles, shop } = request;
  const order = {
    part,
    usualTools,
    withoutTools,
    withoutCycles,
    ncLanguage: "en",
    shop: { table: builtInTools.table, rapid: shop.rapid, control: "TNC 640", machine: null },
  } as const;
  const { tried, issues } = tryValues(
    order,
    request,
    intersection(request.blank, FACED),
    firstAction(name, kind),
    values,
  );
  expect(tried.cut > 1).toBe(cuts);
  expect(issues.map(({ code }) => code)).toEqual(codes);
});
