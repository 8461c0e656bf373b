import { describe, expect, test } from "vitest";
import { bestWays, triesOf, type BetterWay, type Search } from "./better-ways.ts";
import { gainsOf, isShorter, worthOf, type Measure } from "./measure.ts";

const before: Measure = { seconds: 300, tools: 3, changes: 4, residual: 2, bending: 0.2 };
const after = (own: Partial<Measure>): Measure => ({ ...before, ...own });

describe("what a way gains", () => {
  test.each<[string, Partial<Measure>, readonly string[]]>([
    ["nothing", {}, []],
    ["time", { seconds: 296.9 }, ["seconds"]],
    ["too little time", { seconds: 297.1 }, []],
    ["residue", { residual: 1.95 }, ["residual"]],
    ["too little residue", { residual: 1.951 }, []],
    ["a tool and a change", { tools: 2, changes: 3 }, ["tools", "changes"]],
    ["less bending", { bending: 0.19 }, ["bending"]],
    ["more of everything", { seconds: 400, tools: 4, changes: 5, residual: 3, bending: 0.3 }, []],
  ])("%s", (_, own, gains) => expect(gainsOf(before, after(own))).toEqual(gains));

  test("is no less bending where nothing bends much", () => {
    expect(gainsOf({ ...before, bending: 0.011 }, after({ bending: 0 }))).toEqual([]);
  });

  test.each([
    [20, 19, true],
    [20, 19.1, false],
    [300, 297, true],
    [300, 297.1, false],
    [4000, 3995, true],
    [4000, 3995.1, false],
  ])("a time of %s s is shortened to %s s: %s", (than, seconds, shorter) =>
    expect(isShorter(seconds, than)).toBe(shorter),
  );

  test("is worth seconds: saved ones, and those of tools, changes, residue and the verdict", () => {
    const worth = (own: Partial<Measure>, ...gains: Parameters<typeof worthOf>[2]) =>
      worthOf(before, after(own), gains);
    expect([
      worth({ seconds: 290 }, "seconds"),
      worth({ seconds: 310 }),
      worth({ tools: 2 }),
      worth({ changes: 2 }),
      worth({ residual: 1 }),
      worth({ residual: 3 }),
      worth({}, "verdict"),
      worth({ bending: 0.1 }),
    ]).toEqual([10, -10, 60, 20, 60, -60, 600, 0]);
    expect(worth({ bending: 0.1 }, "bending")).toBeGreaterThan(0);
  });
});

const way = (text: string, worth: number, kind: string, own: object = {}, measured: Partial<Measure> = {}) =>
  ({
    text,
    worth,
    before,
    after: after({ seconds: 300 - worth, ...measured }),
    gains: ["seconds"],
    subject: { kind, units: [0], ...own },
  }) as unknown as BetterWay;

describe("the ways that are offered", () => {
  const names = (ways: readonly BetterWay[]) => bestWays(ways).map(({ text }) => text);
  test.each<[string, readonly BetterWay[], readonly string[]]>([
    ["the best first", [way("a", 3, "feed"), way("b", 9, "depth")], ["b", "a"]],
    ["of the same change the best", [way("a", 3, "feed"), way("b", 9, "feed")], ["b"]],
    [
      "the same change elsewhere is another one",
      [way("a", 3, "feed"), way("b", 9, "feed", { units: [1] })],
      ["b", "a"],
    ],
    ["of several tools for an operation one", [way("a", 3, "otherTool"), way("b", 9, "otherCycle")], ["b"]],
    ["of one result the shorter program", [way("long", 9, "feed"), way("s", 9, "depth")], ["s"]],
    [
      "two tools to save are two ways; in either order they are one",
      [
        way("a", 3, "fewerTools", { tools: [3], instead: 1 }),
        way("b", 9, "fewerTools", { tools: [1], instead: 3 }),
        way("c", 5, "fewerTools", { tools: [5], instead: 1 }),
      ],
      ["b", "c"],
    ],
  ])("%s", (_, ways, offered) => expect(names(ways)).toEqual(offered));

  test("a change that a better way already contains is not tried", () => {
    const candidate = (text: string, units: readonly number[], value = { at: "Q463" }) =>
      ({ text, subject: { kind: "values", units, value } }) as never;
    const search = {
      text: "",
      candidates: [
        candidate("both", [0, 1]),
        candidate("first", [0]),
        candidate("third", [2]),
        candidate("feed", [0], { at: "Q478" }),
      ],
    } as unknown as Search;
    const tries = triesOf(search);
    const tried: string[] = [];
    for (let next = tries.next(null); !next.done;) {
      const { candidate: own } = next.value;
      tried.push(own.text);
      next = tries.next(own.text === "both" ? { ...way("both", 9, "values"), subject: own.subject } : null);
    }
    expect(tried).toEqual(["both", "third", "feed"]);
  });
});
