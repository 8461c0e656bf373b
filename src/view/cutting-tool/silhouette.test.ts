import { expect, test } from "vitest";
import { at } from "../../kernel/geometry/point.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { liesBehind, silhouetteOf } from "./silhouette.ts";

/** A disc with a boss in front of it and a groove in its face, and a separate ring further left. */
const groove = [at(-31.3, 42), at(-31.3, 35.5), at(-20.7, 35.5)];
const disc = [
  at(-58, 0),
  at(0.4, 0),
  at(0.4, 12.25),
  at(-20.7, 12.25),
  ...groove.toReversed(),
  at(-20.7, 42),
  at(-20.7, 61.3),
  at(-58, 61.3),
];
const ring = [at(-83, 20), at(-71.1, 20), at(-71.1, 33), at(-83, 30)];
const named = (name: string) => shippedTools.find((tool) => tool.NAME === name) ?? expect.fail(name);

test("the silhouette is the outer edge: hollows do not show, gaps between two pieces do", () => {
  expect(silhouetteOf([disc, ring])).toEqual([
    at(-83, 30),
    at(-71.1, 33),
    at(-71.1, 0),
    at(-58, 0),
    at(-58, 61.3),
    at(-31.3, 61.3),
    at(-20.7, 61.3),
    at(-20.7, 12.25),
    at(0.4, 12.25),
  ]);
  expect(silhouetteOf([])).toEqual([]);
});

test("the bore of a tube does not show either", () => {
  const [outer, bore] = [
    [at(-40, 30), at(0, 30), at(0, 45), at(-40, 45)],
    [at(-12, 33), at(-12, 40), at(-6, 40), at(-6, 33)],
  ];
  expect(silhouetteOf([outer, bore]).every((p) => p.r === 45)).toBe(true);
});

test("a face grooving blade is behind the work in its groove, and in front of it over the boss", () => {
  const blade = named("FACE-RECTURN-3"),
    silhouette = silhouetteOf([disc]);
  expect(liesBehind(blade, [at(-20.1, 36)], silhouette)).toBe(false);
  expect(liesBehind(blade, [at(-27.5, 36)], silhouette)).toBe(true);
  expect(liesBehind(blade, [at(3, 36), at(-27.5, 36)], silhouette)).toBe(true);
});

test("a tool that turns outside only touches the work; a boring bar in a bore is behind it", () => {
  const silhouette = silhouetteOf([disc]);
  expect(liesBehind(named("DNMG-55-R08"), [at(-20.7, 61.3), at(-45.5, 61.3)], silhouette)).toBe(false);
  expect(liesBehind(named("BORE-CCMT-80-R04"), [at(-4, 8.5)], silhouette)).toBe(true);
  expect(liesBehind(named("BORE-CCMT-80-R04"), [at(5.2, 8.5)], silhouette)).toBe(false);
});
