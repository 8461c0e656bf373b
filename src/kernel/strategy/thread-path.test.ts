import { describe, expect, test } from "vitest";
import { passAt, risesAt, type ThreadLine } from "./thread-path.ts";

/** A thread from u = 0 to 20 with its crest at v = 10. */
const line = (own: Partial<ThreadLine> = {}): ThreadLine => ({
  crest: [
    { u: 0, v: 10 },
    { u: 20, v: 10 },
  ],
  depth: 1.2,
  runIn: 5,
  overrun: 2,
  runOut: 0,
  ...own,
});
const SLOPE = Math.tan(Math.PI / 6);
const points = (way: ReturnType<typeof passAt>) => way.map(({ u, v }) => [Number(u.toFixed(6)), Number(v.toFixed(6))]);

describe("a pass of a thread", () => {
  test("without a run-out is set back along the flank in proportion to its missing depth", () => {
    expect(points(passAt(line(), 1.2, SLOPE))).toEqual([
      [-5, 8.8],
      [22, 8.8],
    ]);
    expect(points(passAt(line(), 0.6, SLOPE))).toEqual([
      [-5.34641, 9.4],
      [21.65359, 9.4],
    ]);
    expect(points(passAt(line(), 0.6, 0))).toEqual([
      [-5, 9.4],
      [22, 9.4],
    ]);
  });

  test("rises along a run-out from its own depth to the crest at the end of the thread", () => {
    const rising = line({ runOut: 4 });
    expect(risesAt(rising)).toBe(16);
    expect(points(passAt(rising, 1.2, SLOPE))).toEqual([
      [-5, 8.8],
      [16, 8.8],
      [20, 10],
      [22, 10],
    ]);
    expect(points(passAt(rising, 0.6, SLOPE))).toEqual([
      [-5.34641, 9.4],
      [16, 9.4],
      [20, 10],
      [22, 10],
    ]);
  });

  test("does so on a cone, and over all of the thread", () => {
    const cone = line({
      crest: [
        { u: 0, v: 10 },
        { u: 20, v: 12 },
      ],
      runOut: 20,
    });
    expect(points(passAt(cone, 1.2, 0))).toEqual([
      [-5, 8.3],
      [0, 8.8],
      [20, 12],
      [22, 12.2],
    ]);
    expect(points(passAt(cone, 0.3, 0))).toEqual([
      [-5, 9.2],
      [0, 9.7],
      [20, 12],
      [22, 12.2],
    ]);
  });
});
