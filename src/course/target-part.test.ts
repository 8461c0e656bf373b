import { expect, test } from "vitest";
import { areaOf } from "../kernel/area/area.ts";
import { intersection } from "../kernel/area/clip.ts";
import { at } from "../kernel/geometry/point.ts";
import { targetPart } from "./target-part.ts";

const blank = ["BLK FORM CYLINDER Z D63.4 L81 DIST+1.5 DI17"];
/** Area of the half section, mm². */
const area = (part: Parameters<typeof targetPart>[0]) => Math.abs(areaOf(targetPart(part).rings));

test("a part without outlines is its blank", () => {
  expect(area({ blank })).toBeCloseTo((31.7 - 8.5) * 81, 3);
});

test("behind the end of its outside the blank is unmachined, before it nothing protrudes", () => {
  // Face at Z0, ⌀41.3 to Z-22.7: behind it the unmachined blank.
  const outside = ["L X+17 Z+0", "L X+41.3", "L Z-22.7"];
  expect(area({ blank, outside })).toBeCloseTo((20.65 - 8.5) * 22.7 + (31.7 - 8.5) * (81 - 1.5 - 22.7), 2);
});

test("chamfers, radii and grooves of the face belong to the outline", () => {
  const outside = [
    "L X+17 Z+0",
    "L X+25",
    "L Z-3.1",
    "L X+33",
    "L Z+0",
    "L X+45",
    "CHF 1.3",
    "L Z-20",
    "RND R2.2",
    "L X+63.4",
  ];
  const full = (22.5 - 8.5) * 20 + (31.7 - 8.5) * (79.5 - 20);
  expect(area({ blank, outside })).toBeCloseTo(full - 4 * 3.1 - 1.3 ** 2 / 2 + 2.2 ** 2 * (1 - Math.PI / 4), 2);
});

test("a bore is removed from the free end inwards", () => {
  const outside = ["L X+0 Z+0", "L X+63.4"],
    bore = ["L X+35.2 Z+0", "L Z-14.6", "L X+17"];
  expect(area({ blank, outside, bore })).toBeCloseTo((31.7 - 8.5) * 79.5 - (17.6 - 8.5) * 14.6, 2);
});

test("an unreadable outline is reported", () => {
  expect(targetPart({ blank, outside: ["L X+20 Z+0", "CR X+30 Z-40 R2 DR+"] }).issues).not.toEqual([]);
});

test("a thread may be cut between its crest and its root, and nowhere else", () => {
  const { rings, solid } = targetPart({
    blank: ["BLK FORM CYLINDER Z D40 L30 DIST+0"],
    outside: ["L X+36 Z+0", "L Z-22", "L X+40"],
    threads: [{ from: 0, to: -17.5, crest: 36, root: 33.5, name: "M36×2" }],
  });
  expect(areaOf(rings) - areaOf(solid)).toBeCloseTo(17.5 * 1.25, 6);
  expect(areaOf(intersection(solid, [[at(-17.4, 16.8), at(0, 16.8), at(0, 18), at(-17.4, 18)]]))).toBeCloseTo(0, 6);
});
