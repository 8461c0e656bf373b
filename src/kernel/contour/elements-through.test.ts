import { describe, expect, test } from "vitest";
import { areaOf } from "../area/area.ts";
import { elementsThrough } from "./elements-through.ts";
import { at, part, type Pt, type Segment } from "../geometry/point.ts";
import { CHORD, SAME } from "../tolerance.ts";

const near = { line: SAME, arc: 5 * CHORD };
const fillet: Segment = { kind: "arc", from: at(-12.4, 17.3), to: at(-14, 18.9), centre: at(-12.4, 18.9), turn: "cw" };
/**
 * The points of an outline that runs straight into the fillet and on along its face; the arc is in chords of a tool and
 * of a path.
 */
const points = (finer: number): Pt[] => [at(0, 17.3), ...part.flattened(fillet, CHORD / finer), at(-14, 30.1)];

describe("lines and arcs through points", () => {
  test.each([1, 1.7, 6])("an arc between two lines comes back with its radius, chords %s times as fine", (finer) => {
    const found = elementsThrough(points(finer), near);
    expect(found.map(({ kind }) => kind)).toEqual(["line", "arc", "line"]);
    const [, arc] = found;
    expect(arc?.kind === "arc" && [part.radiusOf(arc), arc.turn]).toEqual([expect.closeTo(1.6, 2), "cw"]);
    expect(arc && [arc.from.z, arc.to.r]).toEqual([-12.4, 18.9]);
  });

  test("an arc encloses the same area as its points, however they are rounded", () => {
    const rounded = points(1.7).map(({ z, r }, i) => at(z + (i % 3) * 0.0008, r - (i % 2) * 0.0009));
    const back = elementsThrough(rounded, near).flatMap((s) => part.flattened(s, CHORD));
    const round = (all: readonly Pt[]) => areaOf([[...all, at(-14, 60), at(0, 60)]]);
    expect(Math.abs(round(back) - round(rounded))).toBeLessThan(0.001);
  });

  test("corners become no arcs, and no line absorbs a step", () => {
    const hexagon = Array.from({ length: 7 }, (_, i) =>
      at(10 * Math.cos((i * Math.PI) / 3), 20 + 10 * Math.sin((i * Math.PI) / 3)),
    );
    expect(elementsThrough(hexagon, near).map(({ kind }) => kind)).toEqual(Array.from({ length: 6 }, () => "line"));
    const stepped = [at(0, 10), at(-20, 10), at(-20, 10.0013), at(-41.7, 10.0013)];
    expect(elementsThrough(stepped, near)).toHaveLength(3);
    expect(elementsThrough([at(0, 10), at(-20, 10.00005), at(-41.7, 10)], near)).toHaveLength(1);
  });

  test("no point and a single point give no elements", () => {
    expect([elementsThrough([], near), elementsThrough([at(0, 1)], near)]).toEqual([[], []]);
  });
});
