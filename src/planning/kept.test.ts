import { describe, expect, test } from "vitest";
import { cycleByNumber } from "../cycles/index.ts";
import type { Cycle } from "../cycles/define.ts";
import { ncLabels } from "../i18n/nc-labels.ts";
import { AnswerCache } from "../kernel/answer-cache.ts";
import { at, part, type Ring } from "../kernel/geometry/point.ts";
import { length } from "../kernel/units.ts";
import { shippedTools } from "../program/tools/shipped-tools.ts";
import { contourJob, planOf } from "./actions/contour-job.ts";
import { face } from "./actions/face.ts";
import { perObject, perText } from "../nc/per-object.ts";
import { localKey, ofPieces, stockKey, turnedVolume } from "./stock-key.ts";
import { finishes, Tries } from "./tries.ts";
import type { Action, PlanRequest } from "./types.ts";

const box = (left: number, right: number, low: number, high: number): Ring => [
  at(left, low),
  at(right, low),
  at(right, high),
  at(left, high),
];
const corners = [at(0, 0), at(0, 20), at(-40, 20), at(-40, 28), at(-60, 28)];
const request: PlanRequest = {
  part: {
    name: "PIN",
    outside: {
      segments: corners.slice(1).map((to, i) => part.line(corners[i] ?? to, to)),
      marks: corners.slice(1).map((_, i) => ({ row: `e${i}` })),
    },
    inside: { segments: [], marks: [] },
    rings: [[...corners, at(-60, 0)].reverse()],
  },
  blank: [box(-80, 2, 0, 30)],
  clamping: null,
  shop: { tools: shippedTools, rapid: 10_000, memory: new AnswerCache(50_000_000) },
  material: "C45",
  rules: {
    toolChange: 5,
    usualTool: 0,
    finishBeforeRough: 60,
    insideBeforeOutside: 5,
    thinBeforeLong: 20,
    tolerancedLast: 20,
    allowance: { diameter: 0.5, z: 0.1 },
  },
  partsOff: false,
  withoutCycles: [],
  withoutTools: [],
  labels: ncLabels("en"),
};

describe("what a search keeps", () => {
  test("an answer for each object and for each text, also where the answer is nothing", () => {
    let asked = 0;
    const ofObject = perObject(({ n }: { readonly n: number }) => ((asked += 1), n > 0 ? n : undefined));
    const [one, alike, none] = [{ n: 1 }, { n: 1 }, { n: 0 }];
    expect([one, one, alike, none, none].map(ofObject)).toEqual([1, 1, 1, undefined, undefined]);
    expect(asked).toBe(3);
    const [ofText, other] = [perText<number | null>(), perText<number | null>()];
    const make = (answer: number | null) => () => ((asked += 1), answer);
    expect([
      ofText("a", make(1)),
      ofText("a", make(2)),
      ofText("b", make(3)),
      other("a", make(null)),
      other("a", make(5)),
    ]).toEqual([1, 1, 3, null, null]);
    expect(asked).toBe(6);
  });

  test("the plan of a cycle for a tool, a contour, a start and values: each of them makes another one", () => {
    const memory = new AnswerCache(10_000_000);
    const cycle = cycleByNumber(810) as Cycle;
    const [, , cylinder, , end] = request.part.outside.segments;
    const work = (z: number) =>
      contourJob(cycle, {
        segments: [part.line(at(0, 20), at(z, 20)), cylinder ?? part.line(at(z, 20), at(z, 28))],
        way: "ahead",
        stock: request.blank,
      });
    const job = work(-40);
    const tool = shippedTools[0] as (typeof shippedTools)[number];
    const with_ = (q: string, value: string) => ({
      ...job,
      drafts: { ...job.drafts, 810: { ...job.drafts[810], [q]: value } },
    });
    const asked = [
      [job, tool],
      [with_("Q463", "1.1"), tool],
      [with_("Q483", "0.9"), tool],
      [work(-33), tool],
      [{ ...job, start: { ...job.start, x: "75" } }, tool],
      [job, { ...tool, RS: length(0.2) }],
    ] as const;
    const moves = asked.map(([each, cutter]) => planOf(cycle, each as typeof job, cutter, memory)?.moves ?? []);
    expect(moves.every((each) => each.length > 4)).toBe(true);
    asked.forEach(([each, cutter], i) =>
      expect([i, moves[i]]).toEqual([i, planOf(cycle, each as typeof job, cutter)?.moves]),
    );
    expect(new Set(moves.map((each) => JSON.stringify(each))).size).toBe(asked.length);
    expect(planOf(cycle, job, { ...tool }, memory)?.moves).toBe(moves[0]);
    expect(end).toBeUndefined();
  });
});

describe("the key of a stock", () => {
  const stock = [box(-50, 0, 0, 20), box(5, 9, 1, 2)];
  test.each<[string, readonly Ring[], boolean]>([
    ["rings in another order", stock.toReversed(), true],
    ["rings that begin elsewhere", stock.map((ring) => [...ring.slice(2), ...ring.slice(0, 2)]), true],
    [
      "points that differ by less than the grid",
      [[at(-50, 0), at(0, 0), at(0.001, 20.001), at(-50, 20)], box(5, 9, 1, 2)],
      true,
    ],
    ["a point twice", [[...stock[0]!, at(-50, 20)], box(5, 9, 1, 2)], true],
    ["a size that differs", [box(-50, 0, 0, 20.01), box(5, 9, 1, 2)], false],
    ["a ring less", [box(-50, 0, 0, 20)], false],
  ])("%s", (_, other, isSame) => expect(stockKey(other) === stockKey(stock)).toBe(isSame));

  test("in the place of an action counts what stands there, on its way in, and two millimetres around it", () => {
    const action = (site: Action["site"]) =>
      ({ site, place: { front: -10, rear: -30, high: 20, low: 15 } }) as unknown as Action;
    const matters = (site: Action["site"], extra: Ring) =>
      localKey([box(-100, -90, 0, 5), extra], action(site)) !== localKey([box(-100, -90, 0, 5)], action(site));
    const inPlace = box(-25, -20, 16, 18);
    const above = box(-25, -20, 40, 50);
    const under = box(-25, -20, 1, 3);
    const inFront = box(10, 20, 16, 18);
    const behind = box(-60, -50, 16, 18);
    const rows = (["outside", "inside", "face"] as const).map((site) =>
      [inPlace, above, under, inFront, behind].map((extra) => matters(site, extra)),
    );
    expect(rows).toEqual([
      [true, true, false, false, false],
      [true, false, true, true, false],
      [true, false, false, true, false],
    ]);
    const beside = (z: number) => matters("outside", box(z, z + 0.5, 16, 18));
    expect([-32.6, -31.9, -8.4, -7.9].map(beside)).toEqual([false, true, true, false]);
    expect([matters("outside", box(-25, -20, 12, 12.9)), matters("outside", box(-25, -20, 12, 13.2))]).toEqual([
      false,
      true,
    ]);
    expect([matters("inside", box(-25, -20, 22.1, 23)), matters("inside", box(-25, -20, 21.8, 23))]).toEqual([
      false,
      true,
    ]);
  });

  test("the volume of a turned area is that of its bodies", () => {
    expect(turnedVolume([box(-50, 0, 0, 20)])).toBeCloseTo(Math.PI * 400 * 50, 6);
    expect(turnedVolume([box(-50, 0, 10, 20), box(5, 7, 0, 3)])).toBeCloseTo(Math.PI * (300 * 50 + 9 * 2), 6);
    // A cone, and a hole in a ring.
    expect(turnedVolume([[at(-30, 0), at(0, 0), at(-30, 10)]])).toBeCloseTo((Math.PI * 100 * 30) / 3, 6);
    expect(turnedVolume([box(-50, 0, 0, 20), box(-40, -30, 5, 10).toReversed()])).toBeCloseTo(
      Math.PI * (400 * 50 - 75 * 10),
      6,
    );
  });

  test("each piece is asked about once, whatever stands beside it; the question counts too", () => {
    const asked: string[] = [];
    const ask = (name: string, area: readonly Ring[], least = 1) =>
      ofPieces(
        area,
        least,
        name,
        (piece) => (asked.push(`${name}${piece.flat().length}`), [turnedVolume(piece)]),
        request,
      ).length;
    const [one, other, small] = [box(-50, 0, 0, 20), box(5, 9, 1, 3), box(20, 20.5, 0, 1)];
    expect([ask("a", [one]), ask("a", [one, other]), ask("b", [one]), ask("a", [other, one, small])]).toEqual([
      1, 2, 1, 2,
    ]);
    expect(asked).toEqual(["a4", "a4", "b4"]);
    expect(ask("a", [small], 0.1)).toBe(1);
  });
});

describe("tries", () => {
  const facing = () => face.actions({ stock: request.blank, done: [], threads: new Set() }, request);
  const [action] = facing() as [Action];

  test("are made once for an action in a stock, and again for another action or another stock in its place", () => {
    const tries = new Tries(request);
    const first = tries.of(action, { stock: request.blank });
    expect([first.works, tries.count]).toEqual([true, 1]);
    const counts = [
      // The same action that was made again, and the same stock.
      tries.of({ ...action }, { stock: request.blank.map((ring) => [...ring]) }),
      // Stock far behind its place.
      tries.of(action, { stock: [box(-80, 2, 0, 30), box(-200, -190, 0, 5)] }),
      tries.of(action, { stock: [box(-80, 3, 0, 30)] }),
      tries.of({ ...action, key: "another" }, { stock: request.blank }),
      tries.of(
        { ...action, job: { ...action.job, start: { ...action.job.start, x: "77" } } },
        { stock: request.blank },
      ),
    ].map(() => tries.count);
    expect(counts.at(-1)).toBe(4);
  });

  test("elsewhere in the same place take the same from another stock", () => {
    const tries = new Tries(request);
    const [near, far] = [box(-80, 2, 0, 30), box(-200, -190, 0, 5)];
    const own = tries.of(action, { stock: [near] });
    const other = tries.of(action, { stock: [near, far] });
    expect([tries.count, other.cut, other.seconds]).toEqual([1, own.cut, own.seconds]);
    expect(turnedVolume(other.stock)).toBeCloseTo(turnedVolume(own.stock) + turnedVolume([far]), 0);
    expect(tries.expectedOf(action, { stock: [near, far] })).toMatchObject({ works: true, seconds: own.seconds });
    expect(tries.expectedOf(action, { stock: [box(-80, 3, 0, 30)] })).toBeNull();
    // A search that is made again tries each stock.
    const again = new Tries(request, tries);
    again.of(action, { stock: [near] });
    again.of(action, { stock: [near, far] });
    expect(again.count).toBe(3);
  });

  test("say how fast material goes at best", () => {
    const tries = new Tries(request);
    expect(tries.leastFor(1000)).toBe(0);
    const { stock, seconds } = tries.of(action, { stock: request.blank });
    const rate = (turnedVolume(request.blank) - turnedVolume(stock)) / seconds;
    expect(tries.rate).toBeCloseTo(rate, 6);
    expect([tries.leastFor(1000), tries.leastFor(-5)]).toEqual([expect.closeTo(1000 / rate, 9), 0]);
    // Facing finishes: what only finishing takes goes no faster.
    expect(finishes(action)).toBe(true);
    expect(tries.leastFor(1000, true)).toBeCloseTo(1000 / rate, 9);
    expect((["drill", "roughOutside", "partOff", "ream", "thread"] as const).map((kind) => finishes({ kind }))).toEqual(
      [false, false, false, true, true],
    );
  });
});
