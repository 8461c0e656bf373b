import { describe, expect, test } from "vitest";
import { at, type Ring } from "../../kernel/geometry/point.ts";
import type { Answer } from "./judgement.ts";
import { threadMarks } from "./threads.ts";

/** Crest and root of the threads, radii in mm, and their ends. */
const [CREST, ROOT, FROM, TO] = [15, 14, 0, -24];

interface Cut {
  /** Z of the middle of each groove. */
  readonly grooves: readonly number[];
  /** Depth of a groove, as a share of the whole one; by the number of the groove. */
  readonly shares?: Readonly<Record<number, number>>;
  readonly isInside?: boolean;
}

const every = (pitch: number, from = -0.6, to = TO) =>
  Array.from({ length: Math.floor((from - to) / pitch) + 1 }, (_, i) => from - i * pitch);

/** A half section with V-shaped grooves of 60°, on a bar or in a ring. */
function stockOf({ grooves, shares = {}, isInside = false }: Cut): Ring[] {
  const radius = (depth: number) => (isInside ? CREST + depth : CREST - depth);
  const half = (CREST - ROOT) * Math.tan(Math.PI / 6);
  const profile = grooves.flatMap((z, i) => {
    const share = shares[i] ?? 1;
    return [at(z + half * share, CREST), at(z, radius((CREST - ROOT) * share)), at(z - half * share, CREST)];
  });
  const back = isInside ? 30 : 0;
  return [[at(1, back), at(1, CREST), ...profile, at(-40, CREST), at(-40, back)]];
}

/** A cut of a thread at some places. */
const operation = (block: number, places: readonly number[]) => ({
  block,
  plan: { thread: {}, moves: places.map((z) => ({ kind: "thread", to: at(z, ROOT) })) },
});

function markOf(cut: Cut, { pitch, operations = [] }: { pitch?: number; operations?: unknown[] } = { pitch: 2 }) {
  const isInside = cut.isInside === true;
  const answer = {
    run: { operations },
    simulation: { final: stockOf(cut), checkpoints: [], proof: { loose: [] } },
  } as unknown as Answer;
  const thread = {
    from: FROM,
    to: TO,
    crest: 2 * CREST,
    root: isInside ? 2 * (CREST + 1) : 2 * ROOT,
    name: "M30",
    ...(pitch !== undefined && { pitch }),
  };
  const [mark] = threadMarks([thread], answer);
  return mark;
}

const even = every(2);
/** The grooves behind a place, all displaced by some mm. */
const jumping = (behind: number, by: number) => even.map((z) => (z < behind ? z + by : z));

describe("the grooves of a thread", () => {
  test.each<[string, Cut, boolean]>([
    ["each at its place", { grooves: even }, true],
    ["each at its place, in a bore", { grooves: even, isInside: true }, true],
    ["a wider first groove, as in a chamfer", { grooves: [-0.3, ...every(2, -2.9)] }, true],
    ["half a groove at the end", { grooves: even, shares: { [even.length - 1]: 0.6 } }, true],
    ["half a groove at the beginning", { grooves: even, shares: { 0: 0.6 } }, true],
    [
      "as deep as a flat of the insert leaves it",
      { grooves: even, shares: Object.fromEntries(even.map((_, i) => [i, 0.88])) },
      true,
    ],
    ["all too shallow", { grooves: even, shares: Object.fromEntries(even.map((_, i) => [i, 0.8])) }, false],
    ["one too shallow among the others", { grooves: even, shares: { 5: 0.7 } }, false],
    ["one too shallow among the others, in a bore", { grooves: even, shares: { 5: 0.7 }, isInside: true }, false],
    ["a pitch that jumps by less than its quarter", { grooves: jumping(-12, 0.4) }, true],
    ["a pitch that jumps forwards", { grooves: jumping(-12, 0.6) }, false],
    ["a pitch that jumps back", { grooves: jumping(-12, -0.6) }, false],
    ["a pitch that jumps beside the second groove", { grooves: jumping(-2.7, -0.6) }, false],
    ["one groove left out", { grooves: even.filter((_, i) => i !== 6) }, false],
    ["the last one nearly one and a half pitches before the end", { grooves: every(2, -1.1, -22) }, true],
    ["the last one further before the end", { grooves: every(2, -0.9, -22) }, false],
    ["the first one nearly one and a half pitches behind the beginning", { grooves: every(2, -2.9) }, true],
    ["the first one further behind the beginning", { grooves: every(2, -3.1) }, false],
    ["one groove", { grooves: [-12] }, false],
    ["none", { grooves: [] }, false],
    ["twice as many", { grooves: every(1) }, false],
    ["a pitch larger by a hundredth", { grooves: every(2.018) }, true],
    ["a pitch larger by more", { grooves: every(2.03) }, false],
    ["a pitch smaller by more", { grooves: every(1.97) }, false],
  ])("%s", (_, cut, passed) => expect(markOf(cut)?.passed).toBe(passed));

  test("of any even pitch where the task states none; their pitch is measured", () => {
    const mark = markOf({ grooves: every(1.7) }, {});
    expect([mark?.passed, mark?.limit]).toEqual([true, undefined]);
    expect(mark?.value).toBeCloseTo(1.7, 1);
    expect(markOf({ grooves: [] })).toMatchObject({ passed: false, value: 0, limit: 2 });
  });

  test("blame the last call that cuts at their place", () => {
    const called = (...operations: unknown[]) => {
      const mark = markOf({ grooves: even }, { pitch: 2, operations });
      return [mark?.operation, mark?.block];
    };
    expect(called(operation(7, [TO]))).toEqual([0, 7]);
    expect(called(operation(7, [TO]), operation(9, [TO - 1.5]))).toEqual([1, 9]);
    // Another thread behind this one, and one in front of it.
    expect(called(operation(7, [TO]), operation(9, [TO - 4.5]), operation(11, [FROM + 2.5]))).toEqual([0, 7]);
    expect(called({ ...operation(7, [TO]), plan: { moves: operation(7, [TO]).plan.moves } })).toEqual([
      undefined,
      undefined,
    ]);
  });

  test("show where they should be", () => {
    const mark = markOf({ grooves: even });
    expect(mark?.place).toEqual(at((FROM + TO) / 2, CREST));
    expect(mark?.rings?.[0]?.map(({ z, r }) => [z, r]).toSorted()).toEqual(
      [at(TO, ROOT), at(FROM, ROOT), at(FROM, CREST), at(TO, CREST)].map(({ z, r }) => [z, r]).toSorted(),
    );
  });
});
