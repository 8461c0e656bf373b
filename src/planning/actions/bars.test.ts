import { expect, test } from "vitest";
import { requestOf } from "../../../tests/planning/plan-laws.ts";
import { at, type Ring } from "../../kernel/geometry/point.ts";
import { newRow } from "../../program/job/job.ts";
import { applyAction } from "../apply-action.ts";
import { newPart } from "../part/finished-part.ts";
import { finishInside } from "./finish-inside.ts";
import { roughInside } from "./rough-inside.ts";

/** Radii of a bore along Z, and of the hole that was drilled into it. */
const BORES = [
  {
    name: "the cone of a drill, in front of the axis for the back of the insert",
    bore: { 0: 11.5, [-34]: 11.5, [-40.91]: 0 },
    hole: { 0: 11.5, [-33.8]: 11.5, [-33.81]: 11, [-40.4]: 0 },
    rear: [-39.5, -38],
  },
  {
    name: "a taper, in front of the place where the collar of a bar meets the face",
    bore: { 0: 6, [-79]: 5 },
    hole: { 0: 5.8, [-79]: 4.8, [-99]: 4.8 },
    rear: [-40.5, -38],
  },
  {
    name: "a cylinder, with its way off the wall in front of that place",
    bore: { 0: 5, [-50]: 5 },
    hole: { 0: 4.6, [-99]: 4.6 },
    rear: [-40.5, -38],
  },
  {
    name: "a bore as wide as their row says, though the hole is narrower",
    bore: { 0: 5.5, [-99]: 5.5 },
    hole: { 0: 5.1, [-99]: 5.1 },
    rear: [-101, -99],
  },
];

const points = (radii: object) =>
  Object.entries(radii)
    .map(([z, r]) => at(Number(z), Number(r)))
    .toSorted((a, b) => b.z - a.z);
const rows = (radii: object) => points(radii).map(({ z, r }, i) => newRow(`${i}`, { z: `${z}`, x: `${2 * r}` }));

test.each(BORES)("bars finish $name", ({ bore, hole, rear: [rear = 0, front = 0] }) => {
  const blank = { outside: "40", bore: "0", length: "130", allowance: "0" };
  const part = { ...newPart("BORE"), outside: rows({ 0: 20, [-99]: 20 }), inside: rows(bore), blank };
  const request = requestOf(part);
  if (!request) throw new Error("no part");
  const inner = points(hole);
  const stock: Ring[] = [[...inner.toReversed(), at(0, 20), at(-130, 20), at(-130, inner.at(-1)?.r ?? 0)]];
  const state = { stock, done: [], threads: new Set<string>() };
  const works = finishInside.actions(state, request).filter((action) => applyAction(action, state, request).works);
  const deepest = Math.min(...works.map(({ place }) => place.rear));
  expect(deepest).toBeGreaterThan(rear);
  expect(deepest).toBeLessThan(front);
});

test("bars rough a bore behind a neck that their shank is clear of", () => {
  const blank = { outside: "60", bore: "0", length: "60", allowance: "0" };
  const bore = rows({ 0: 12.5, [-7.2]: 12.5, [-10.8]: 16.5, [-18]: 16.5 });
  const part = { ...newPart("NECK"), outside: rows({ 0: 26.5, [-18]: 26.5 }), inside: bore, blank };
  const request = requestOf(part);
  if (!request) throw new Error("no part");
  const stock = [[at(0, 12.5), at(0, 30), at(-60, 30), at(-60, 12.45), at(-8.3, 12.45), at(-8.3, 12.5)].toReversed()];
  const state = { stock, done: [], threads: new Set<string>() };
  const actions = roughInside.actions(state, request);
  expect(actions.length).toBeGreaterThan(0);
  for (const action of actions)
    expect([action.key, applyAction(action, state, request).faults]).toEqual([action.key, []]);
});

test("bars that may touch a wall take no place of bars that are clear of it", () => {
  const blank = { outside: "100", bore: "0", length: "80", allowance: "0" };
  const bore = rows({ 0: 20.5, [-35.1]: 20.5, [-35.14]: 12.5, [-45]: 12.5 });
  const part = { ...newPart("STEP"), outside: rows({ 0: 50, [-45]: 50 }), inside: bore, blank };
  const request = requestOf(part);
  if (!request) throw new Error("no part");
  const hole = points({ 0: 20.1, [-34.83]: 20.1, [-34.84]: 12.843, [-35.943]: 11, [-47]: 11, [-53.6]: 0 });
  const state = {
    stock: [[...hole.toReversed(), at(0, 50), at(-80, 50), at(-80, 0)]],
    done: [],
    threads: new Set<string>(),
  };
  const tried = roughInside.actions(state, request).map((action) => applyAction(action, state, request));
  const touching = tried.filter(({ faults }) => faults.some(({ kind }) => kind === "holderContact"));
  expect(touching.length).toBeGreaterThan(0);
  expect(tried.filter(({ works }) => works).length).toBeGreaterThan(0);
});
