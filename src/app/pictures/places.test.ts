import { describe, expect, test, vi } from "vitest";
import { at, type Pt } from "../../kernel/geometry/point.ts";
import { lengthsIn } from "../../i18n/lengths.ts";
import type { ContourRow } from "../../program/job/job.ts";
import { numberIn } from "./help/number-in.ts";
import { createPointedPlace } from "./load/pointed-place.ts";
import { gaugedText } from "./measure/measure-words.ts";
import { elementNear } from "./selection.ts";

const row = (id: string, own: Partial<ContourRow>): ContourRow => ({
  id,
  kind: "L",
  x: "",
  z: "",
  r: "",
  turn: "cw",
  incrementalX: false,
  incrementalZ: false,
  angle: "",
  length: "",
  tangent: false,
  second: false,
  form: "",
  words: {},
  ...own,
});
/** A face at Z0 and a cylinder of 40 mm behind a chamfer. */
const rows = [
  row("begin", { x: "0", z: "0" }),
  row("face", { x: "40" }),
  row("edge", { kind: "CHF", r: "2" }),
  row("side", { z: "-30" }),
];

describe("the element of a place", () => {
  test.each<[string, Pt, number, string | null]>([
    ["on the face", at(0.5, 10), 1, "face"],
    ["on the cylinder", at(-20, 20.5), 1, "side"],
    ["on the chamfer between them", at(-1, 19), 1, "edge"],
    ["nearer to one of two", at(-2.5, 20.4), 5, "side"],
    ["just within reach", at(1, 10), 1.001, "face"],
    ["out of reach", at(1, 10), 0.999, null],
    ["behind the end", at(-45, 20), 10, null],
  ])("%s", (_, place, reach, element) => expect(elementNear(rows, place, reach)).toBe(element));

  test("of no contour is none", () => expect(elementNear([], at(0, 0), 1000)).toBeNull());
});

test("the pointed place tells its listeners of another place, once each, until they stop", () => {
  const place = createPointedPlace();
  const [first, second] = [vi.fn(), vi.fn()];
  const stop = place.subscribe(first);
  place.subscribe(second);
  const p = at(1, 2);
  place.set(p);
  place.set(p);
  expect([place.get(), first.mock.calls.length]).toEqual([p, 1]);
  stop();
  place.set(null);
  expect([place.get(), first.mock.calls.length, second.mock.calls.length]).toEqual([null, 1, 2]);
});

test("numbers of a picture are in the unit of the program", () => {
  const en = numberIn("en", null);
  expect([en(12.5, 3, { kind: "length" }), numberIn("de", null)(12.5, 3, { kind: "length" })]).toEqual([
    "12.5",
    "12,5",
  ]);
  const inch = numberIn("en", { perRevolution: true });
  expect([inch(25.4, 3, { kind: "length" }), inch(30, 3, { kind: "angle" })]).toEqual(["1", "30"]);
});

test("measured values are written as the control writes them", () => {
  const text = (kind: Parameters<typeof gaugedText>[1]) => gaugedText(lengthsIn("en", "mm", 1), kind, 30);
  expect((["diameter", "length", "radius", "angle", "wall"] as const).map(text)).toEqual([
    "⌀30.000",
    "30.000",
    "R30.000",
    "30.000°",
    "30.000",
  ]);
});
