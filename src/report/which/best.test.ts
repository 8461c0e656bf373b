import { describe, expect, test } from "vitest";
import type { ShapeRequest } from "../../cycles/shape-request.ts";
import { axial, diameter, length } from "../../kernel/units.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { bestFirst, bestOf } from "./best.ts";
import type { TriedOption } from "./try-way.ts";
import { cyclesFor, waysFor } from "./ways.ts";

type Measured = Pick<TriedOption, "works" | "suitsDepth" | "unreached" | "seconds" | "passes">;
const PLAIN: Measured = { works: true, suitsDepth: true, unreached: 1, seconds: 100, passes: 5 };
const option = (id: string, own: Partial<Measured>) => ({ ...PLAIN, ...own, id }) as TriedOption;

/** What one option has and the other has not, the better one first; null where they are alike. */
const PAIRS: readonly (readonly [string | null, Partial<Measured>, Partial<Measured>])[] = [
  ["only", { suitsDepth: false, unreached: 9, seconds: 900, passes: 50 }, { works: false }],
  ["tool", { unreached: 9, seconds: 900, passes: 50 }, { suitsDepth: false }],
  ["least", { seconds: 900, passes: 50 }, { unreached: 1.06 }],
  ["fast", { unreached: 1.04, passes: 50 }, { seconds: 101.2 }],
  ["passes", { unreached: 1.04, seconds: 100.9 }, { passes: 6 }],
  [null, { unreached: 1.04, seconds: 100.9 }, {}],
  // A hundredth of the longer time, not of the shorter one.
  [null, { seconds: 99.005 }, {}],
  ["fast", { seconds: 98.9 }, {}],
];

describe("the order of the options", () => {
  test.each(PAIRS)("%s", (because, one, other) => {
    const [a, b] = [option("a", one), option("b", other)];
    const ids = (all: readonly TriedOption[]) => bestFirst(all).map(({ id }) => id);
    expect(ids([a, b])).toEqual(["a", "b"]);
    expect(ids([b, a])).toEqual(because === null ? ["b", "a"] : ["a", "b"]);
    expect(bestOf([a, b])).toEqual({ id: "a", because: because ?? "equal" });
    if (because !== null) expect(bestOf([b, a])).toEqual({ id: "a", because });
  });

  test("what does not work comes last and is never the best", () => {
    const none = [option("a", { works: false, seconds: 1 }), option("b", { works: false, seconds: 2 })];
    expect(bestOf(none)).toBeNull();
    expect(bestFirst([...none.toReversed(), option("c", { seconds: 900 })]).map(({ id }) => id)).toEqual([
      "c",
      "a",
      "b",
    ]);
  });

  test("the advantage is that over the second best, not over the last", () => {
    const all = [option("a", { seconds: 300 }), option("b", { seconds: 100 }), option("c", { suitsDepth: false })];
    expect(bestOf(all)).toEqual({ id: "b", because: "fast" });
  });
});

const corner = (d: number, z: number) => ({ diameter: diameter(d), z: axial(z) });
const wanted = (given: Partial<ShapeRequest>): ShapeRequest => ({
  site: "outside",
  shape: "step",
  from: corner(75.3, 0),
  to: corner(48.71, -41.237),
  angle: 0,
  pitch: 1.75,
  contour: null,
  allowance: 0,
  ...given,
});
const FACE = { site: "face", to: corner(48.71, -7.313) } as const;
const BORE = { site: "inside", from: corner(30.3, 0), to: corner(48.71, -31.237) } as const;
const THREAD = { shape: "thread", from: corner(30, 0), to: corner(30, -25.3) } as const;

/** The cycles that are proposed, the likeliest first. */
const PROPOSED: readonly (readonly [string, Partial<ShapeRequest>, readonly number[]])[] = [
  ["a step outside: along the axis before across it", {}, [811, 821]],
  ["a step in a bore", BORE, [811, 821]],
  ["a step on a face: across before along", FACE, [821, 811]],
  ["a tapered step", { angle: 3.217 }, [812, 822]],
  ["a tapered step on a face", { ...FACE, angle: 3.217 }, [822, 812]],
  ["a step with a chamfer", { chamfer: length(1.7) }, [812]],
  ["a preformed step: along its contour first", { allowance: length(2.3) }, [815, 811, 821]],
  ["a preformed step on a face", { ...FACE, allowance: length(1.1) }, [815, 821, 811]],
  ["a groove outside", { shape: "groove", from: corner(75.3, -20.31), to: corner(58.77, -32.123) }, [841, 861]],
  ["a groove in a face", { ...FACE, shape: "groove" }, [851, 871]],
  ["a thread", THREAD, [831]],
  ["a thread on a face", { ...THREAD, site: "face" }, [832]],
];

describe("the cycles that are proposed", () => {
  test.each(PROPOSED)("%s", (_, given, cycles) =>
    expect(cyclesFor(wanted(given)).map(({ number }) => number)).toEqual(cycles),
  );

  test("each first with the tool that suits it best; then the other choice and another tool, the likeliest cycle first", () => {
    const listed = (given: Partial<ShapeRequest>) =>
      waysFor(wanted(given), null, shippedTools).map(({ id, suitsDepth }) => (suitsDepth ? id : `${id} too deep`));
    expect(listed({})).toEqual([
      "811 1 Q506=0",
      "821 1 Q506=0",
      "811 1 Q506=1",
      "811 3 Q506=0 too deep",
      "821 1 Q506=1",
      "821 3 Q506=0 too deep",
    ]);
    // 1.8 mm on the diameter are not too deep for a finishing insert along the axis; across it are 41 mm.
    expect(listed({ to: corner(73.5, -41) }).filter((id) => id.includes(" 3 "))).toEqual([
      "811 3 Q506=0",
      "821 3 Q506=0 too deep",
    ]);
    expect(listed(BORE)).toEqual([
      "811 5 Q506=0",
      "821 5 Q506=0",
      "811 5 Q506=1",
      "811 14 Q506=0",
      "821 5 Q506=1",
      "821 11 Q506=0",
    ]);
    // Of two usual inserts that rough, the one with the larger nose is the stronger.
    const [rough] = shippedTools;
    const larger = rough && { ...rough, T: 91, RS: length(1.2) };
    expect(larger && waysFor(wanted({}), null, [...shippedTools, larger])[0]?.tool.T).toBe(91);
    // More than eight would be too many.
    expect(listed({ allowance: length(2.3) })).toHaveLength(8);
  });
});
