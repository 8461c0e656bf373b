import { describe, expect, test } from "vitest";
import { ncLabels } from "../../i18n/nc-labels.ts";
import { at, part, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { standardReamers } from "../../program/tools/standard-reamers.ts";
import { readList, shippedList } from "../../program/tools/tool-list.ts";
import { changeBefore, priceOf } from "../plan-node.ts";
import type { Action, PlanRequest } from "../types.ts";
import { ream, reamedBy, reamedSkin, reamersOf } from "./ream.ts";

const mills = readList(standardReamers(shippedList).map((cells, i) => ({ id: `r${i}`, cells }))).table.mills ?? [];
const base: Omit<PlanRequest, "part" | "blank"> = {
  clamping: null,
  shop: { tools: shippedTools, mills, rapid: 10_000 },
  material: "C45",
  rules: {
    toolChange: 5,
    usualTool: 90,
    finishBeforeRough: 60,
    insideBeforeOutside: 5,
    thinBeforeLong: 20,
    tolerancedLast: 20,
    allowance: { diameter: 0.5, z: 0.1 },
  },
  partsOff: false,
  withoutCycles: [],
  withoutTools: [],
  labels: ncLabels("en"),
};
/** A ring of 60 mm with a bore; `toleranced`: the cylinders of 10H7. */
function requestOf(bore: readonly Pt[], toleranced: readonly number[]): PlanRequest {
  const segments = bore.slice(1).map((to, i) => part.line(bore[i] ?? to, to));
  const outside = [bore[0] ?? at(0, 5), at(0, 30), at(-30, 30), at(-30, bore.at(-1)?.r ?? 0)];
  const rings: Ring[] = [[...outside.slice(1), ...bore.toReversed()]];
  return {
    ...base,
    part: {
      name: "RING",
      outside: {
        segments: outside.slice(1).map((to, i) => part.line(outside[i] ?? to, to)),
        marks: [{ row: "a" }, { row: "b" }, { row: "c" }],
      },
      inside: {
        segments,
        marks: segments.map((_, i) => ({ row: `i${i}`, ...(toleranced.includes(i) && { tolerance: "H7" }) })),
      },
      rings,
    },
    blank: rings,
  };
}
const R = 5.00375;
const plain = requestOf([at(0, R), at(-30, R)], [0]);
const reamer = reamersOf(plain).find(({ R: r = 0 }) => Math.abs(r - R) < 0.1);
const drilled = (r: number, front = 0): Ring[] => [[at(front, r), at(front, 30), at(-30, 30), at(-30, r)]];

describe("what a reamer makes", () => {
  test.each<[string, readonly Pt[], readonly number[], readonly number[]]>([
    ["the whole bore", [at(0, R), at(-30, R)], [0], [0]],
    ["a cylinder behind a chamfer", [at(0, R + 0.5), at(-0.5, R), at(-30, R)], [1], [1]],
    [
      "two of them, with a groove between",
      [at(0, R), at(-10, R), at(-10, 7), at(-15, 7), at(-15, R), at(-30, R)],
      [0, 4],
      [0, 4],
    ],
    ["none behind a narrower one", [at(0, 4), at(-10, 4), at(-10, R), at(-30, R)], [2], []],
    [
      "none that ends at a narrower one: its lead does not pass",
      [at(0, R), at(-20, R), at(-20, 4), at(-30, 4)],
      [0],
      [],
    ],
    ["none on the cone of a drill that its lead meets", [at(0, R), at(-20, R), at(-23, 0)], [0], []],
    [
      "one that ends before a narrower one",
      [at(0, R), at(-20, R), at(-20, 8), at(-22, 8), at(-22, 4), at(-30, 4)],
      [0],
      [0],
    ],
    ["none of another tolerance", [at(0, R), at(-30, R)], [], []],
  ])("%s", (_, bore, toleranced, made) => {
    const request = requestOf(bore, toleranced);
    const found = reamer && reamedBy(reamer, request.part);
    expect(found?.cylinders.map((s) => request.part.inside.segments.indexOf(s)) ?? []).toEqual(made);
  });

  test("is proposed for a hole of its undersize in a faced stock, to its lead behind the cylinder", () => {
    const proposed = (stock: readonly Ring[], request = plain) =>
      ream
        .actions({ stock, done: [], threads: new Set() }, request)
        .map(({ place, kind, site, tool }) => [kind, site, tool.T, place.front, place.rear]);
    expect(proposed(drilled(4.9))).toEqual([["ream", "inside", reamer?.T, 0, -31]]);
    expect([proposed(drilled(4.6)), proposed(drilled(5.1)), proposed(drilled(0)), proposed(drilled(4.9, 2))]).toEqual([
      [],
      [],
      [],
      [],
    ]);
    expect(proposed(drilled(4.9), { ...plain, withoutTools: [reamer?.T ?? 0] })).toEqual([]);
  });

  test("is left for it: what a bar does not take", () => {
    const [skin, ...more] = reamedSkin(drilled(4.9), plain);
    expect(more).toEqual([]);
    expect(skin?.map(({ z }) => z).toSorted((a, b) => a - b)).toEqual([-30, -30, 0, 0]);
    expect(Math.max(...(skin ?? []).map(({ r }) => r))).toBeGreaterThan(R);
    expect(reamedSkin(drilled(4.6), plain)).toEqual([]);
  });
});

describe("the price of the next tool", () => {
  const action = (T: number) => ({ tool: { T } }) as unknown as Action;
  test("a change of the machine, else of the shop; none for the same tool", () => {
    const machine = { ...plain, shop: { ...plain.shop, machine: { name: "M", toolChange: 7 } } };
    expect([
      changeBefore(action(1), null, plain),
      changeBefore(action(1), action(2), machine),
      changeBefore(action(1), action(1), machine),
    ]).toEqual([5, 7, 0]);
  });
  test("a tool that the operator lacks is bought once", () => {
    const request = { ...plain, usualTools: [2, 3] };
    expect([
      priceOf(action(2), [], request),
      priceOf(action(2), [action(1), action(2)], request),
      priceOf(action(2), [action(3)], request),
      priceOf(action(1), [], request),
      priceOf(action(2), [], plain),
    ]).toEqual([90, 0, 90, 0, 0]);
  });
});
