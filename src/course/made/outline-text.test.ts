import { expect, test } from "vitest";
import { areaOf } from "../../kernel/area/area.ts";
import { difference } from "../../kernel/area/clip.ts";
import { targetPart } from "../target-part.ts";
import { outlineText } from "./outline-text.ts";

const solid = ["BLK FORM CYLINDER Z D63.4 L81 DIST+1.5"],
  hollow = ["BLK FORM CYLINDER Z D63.4 L81 DIST+1.5 DI17"];

/** Converts a part to its outline and back; the two must agree within the area between them. */
function taken(part: Parameters<typeof targetPart>[0]) {
  const wanted = targetPart(part),
    lines = outlineText(wanted.rings, wanted.blank);
  const again = targetPart({
    blank: part.blank,
    ...(lines.outside && { outside: [...lines.outside] }),
    ...(lines.bore && { bore: [...lines.bore] }),
  });
  const apart =
    Math.abs(areaOf(difference(wanted.rings, again.rings))) + Math.abs(areaOf(difference(again.rings, wanted.rings)));
  return { lines, apart, issues: again.issues };
}

test("lines come back as they were written", () => {
  const { lines, apart } = taken({ blank: solid, outside: ["L X+0 Z+0", "L X+41.3", "L Z-22.7", "L X+63.4"] });
  expect(lines).toEqual({ outside: ["L X+0 Z+0", "L X+41.3 Z+0", "L X+41.3 Z-22.7", "L X+63.4 Z-22.7"] });
  expect(apart).toBeLessThan(0.001);
});

test("radii come back as arcs, chamfers as lines", () => {
  const { lines, apart } = taken({
    blank: solid,
    outside: ["L X+0 Z+0", "L X+41.3", "CHF 1.3", "L Z-22.7", "RND R2.4", "L X+60 Z-31.9", "L X+63.4"],
  });
  expect(
    lines.outside?.filter((line) => line.startsWith("CR")).map((line) => /R\+[\d.]+ DR.$/.exec(line)?.[0]),
  ).toEqual([expect.stringMatching(/^R\+2\.(39|4)\d* DR-$/)]);
  expect(lines.outside).toHaveLength(7);
  // A thousandth of a millimetre along all of it.
  expect(apart).toBeLessThan(0.08);
});

test("a cone keeps the diameter to which its angle takes it, however near to a hundredth", () => {
  const { lines } = taken({ blank: solid, outside: ["L X+0 Z+0", "L X+50", "L X+59.622 Z-54.989", "L X+63.4"] });
  expect(lines.outside).toEqual(["L X+0 Z+0", "L X+50 Z+0", "L X+59.622 Z-54.99", "L X+63.4 Z-54.99"]);
});

test("a bore is separate from the outside; grooves of the face belong to the outside", () => {
  const { lines, apart, issues } = taken({
    blank: hollow,
    outside: ["L X+35.2 Z+0", "L X+40", "L Z-3.1", "L X+48", "L Z+0", "L X+52.2", "L Z-20", "L X+63.4"],
    bore: ["L X+35.2 Z+0", "L Z-14.6", "RND R1.1", "L X+17"],
  });
  expect(issues).toEqual([]);
  expect(lines.bore?.[0]).toBe("L X+35.2 Z+0");
  expect(lines.outside).toHaveLength(8);
  expect(apart).toBeLessThan(0.05);
});

test("an unmachined blank has no outline", () => {
  const { blank } = targetPart({ blank: hollow });
  expect(outlineText(blank, blank)).toEqual({});
});
