import { describe, expect, test } from "vitest";
import { at, part, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import { featuresOnPart, type TurnedContour } from "./found-features.ts";

const chain = (...points: readonly Pt[]) => points.slice(1).map((to, i) => part.line(points[i] ?? to, to));
/** A bush of 60 mm with a shoulder of 50 mm and a bore of 30 mm, from a bar of 62 mm. */
const finished: readonly Ring[] = [[at(0, 15), at(0, 25), at(-20, 25), at(-20, 30), at(-50, 30), at(-50, 15)]];
const blank: readonly Ring[] = [[at(-80, 0), at(1, 0), at(1, 31), at(-80, 31)]];
const outside: TurnedContour = { segments: chain(at(0, 15), at(0, 25), at(-20, 25), at(-20, 30), at(-50, 30)) };
const bore: TurnedContour = { segments: chain(at(0, 15), at(-50, 15)) };

function said(contours: readonly TurnedContour[], of = finished) {
  const { cylinders, positions } = featuresOnPart(contours, of, blank);
  return {
    cylinders: cylinders.map(
      ({ r, isBore, extent, thread }) =>
        `${isBore ? "bore" : "shaft"} ${2 * r} ${+extent.toFixed(2)}${thread ? ` ${thread.starts}×${thread.lead}` : ""}`,
    ),
    positions: positions.map(({ from, extent }) => `${from.z} ${+extent.toFixed(2)}`),
  };
}

describe("the features of what a program turns", () => {
  test("are its cylinders, shafts and bores, and its faces", () => {
    const found = said([outside, bore]);
    expect(found.cylinders).toEqual(["shaft 50 20", "shaft 60 30", "bore 30 50"]);
    expect(found.positions).toContain("-20 5");
    expect(found.positions).toContain("0 10");
  });

  test("carry their thread", () => {
    expect(said([{ ...outside, thread: { lead: 1.5, starts: 2 } }]).cylinders).toEqual([
      "shaft 50 20 2×1.5",
      "shaft 60 30 2×1.5",
    ]);
  });

  test("are only those on the part: oversize may still be on it, another contour is none of it", () => {
    const away = (by: number): TurnedContour => ({ segments: chain(at(-2, 25 + by), at(-12, 25 + by)) });
    expect(said([away(0.7)]).cylinders).toEqual(["shaft 51.4 10"]);
    expect(said([away(0.9)]).cylinders).toEqual([]);
    // The roughing contour of a shaft runs out beyond the part.
    const beyond: TurnedContour = { segments: chain(at(4, 25), at(-20, 25), at(-20, 40)) };
    expect(said([beyond]).positions.some((p) => p.startsWith("4 "))).toBe(false);
  });

  test("without broken edges, and without sides of grooves that hardly leave their axis", () => {
    const broken: TurnedContour = { segments: chain(at(0, 24.5), at(-0.5, 25), at(-20, 25), at(-20, 30), at(-50, 30)) };
    expect(said([broken]).cylinders).toEqual(["shaft 50 19.5", "shaft 60 30"]);
  });

  test("are those of the part itself where nothing is turned, less what the blank already has", () => {
    const { cylinders } = said([], [[at(-80, 0), at(0, 0), at(0, 25), at(-20, 25), at(-20, 31), at(-80, 31)]]);
    expect(cylinders).toEqual(["shaft 50 20"]);
  });
});
