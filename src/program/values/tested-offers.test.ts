import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { cycleByNumber } from "../../cycles/index.ts";
import type { Issue } from "../../kernel/plan/issue.ts";
import { offerOf } from "../../kernel/plan/offer.ts";
import { parse } from "../../nc/parse.ts";
import { run } from "../run/run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";

type Numbers = Readonly<Record<string, number>>;
const example = (cycle: number): Numbers =>
  Object.fromEntries(Object.entries(cycleByNumber(cycle)?.params ?? {}).map(([q, param]) => [q, param.example]));

const signed = (n: number) => (n < 0 ? String(n) : `+${n}`);
const contour = "M30\nLBL 2\nL X+75 Z-20\nL X+50\nRND R2\nL X+20 Z-25\nRND R2\nL Z+0\nLBL 0";

function issuesOf(cycle: number, values: Numbers, tool: number, start: readonly [number, number]): readonly Issue[] {
  const words = Object.entries(values)
    .map(([q, n]) => `${q}=${signed(n)}`)
    .join(" ~\n");
  const text =
    `0 BEGIN PGM T MM\nBLK FORM CYLINDER Z D100 L100 DIST+2\nFUNCTION MODE TURN\nTOOL CALL ${tool}\nFUNCTION TURNDATA SPIN ` +
    "VCONST:OFF S500\nM136\n" +
    `L X+120 Z+50 R0 FMAX M303\nCYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 CONTOUR LABEL2\nCYCL DEF ${cycle} NAME ~\n${words}\n` +
    `L X${signed(start[0])} Z${signed(start[1])} FMAX\nCYCL CALL\n${cycle === 820 ? contour : "M30"}\nEND PGM T MM\n`;
  return run(parse(text), { tools: shippedTools, rapid: 10_000 }).issues.map((found) => found.issue as Issue);
}

const keys = (issues: readonly Issue[]) =>
  new Set(issues.filter((each) => each.severity === "error").map((each) => `${each.code} ${each.at ?? ""}`));
const at = (issues: readonly Issue[], code: string, q: string) =>
  issues.find((each) => each.code === code && each.at === q);

const mm = (min: number, max: number) => fc.integer({ min: min * 1000, max: max * 1000 }).map((n) => n / 1000);
const angle = fc.oneof(
  fc.integer({ min: 0, max: 899_999 }).map((n) => n / 1e4),
  fc.constantFrom(0, 30, 89.9999, 90, -1),
);
const size = fc.oneof(mm(0, 40), mm(-1, 2), fc.constantFrom(0, 1000));
/** Values that often conflict with each other or with the tool. */
const odd = {
  Q491: fc.oneof(mm(20, 100), fc.constantFrom(75, 50)),
  Q493: fc.oneof(mm(0, 100), fc.constantFrom(75, 50)),
  Q492: fc.oneof(mm(-20, 2), fc.constantFrom(0, -20)),
  Q494: fc.oneof(mm(-60, 0), fc.constantFrom(0, -20)),
  Q495: angle,
  Q496: angle,
  Q500: size,
  Q502: size,
  Q504: size,
  Q501: fc.integer({ min: 0, max: 3 }),
  Q503: fc.integer({ min: 0, max: 3 }),
  Q463: fc.oneof(mm(1, 6), fc.constantFrom(0, 20, 1000)),
  Q483: fc.oneof(mm(0, 3), fc.constantFrom(100)),
  Q484: mm(0, 2),
  Q508: mm(0, 2),
  Q479: fc.constantFrom(0, 1),
  Q480: mm(0, 90),
  Q482: mm(-40, 10),
  Q215: fc.integer({ min: 0, max: 4 }),
  Q506: fc.constantFrom(0, 1, 2, 3),
};
const cases = fc.constantFrom(812, 812, 820, 852, 852).chain((cycle) => {
  const own = Object.entries(odd).filter(([q]) => q in example(cycle));
  return fc.record({
    cycle: fc.constant(cycle),
    tool: fc.constantFrom(1, 2, 3, 4, 8, 8, 9, 11, 15),
    x: fc.constantFrom(75, 80, 100),
    z: fc.constantFrom(2, 5),
    changes: fc.record(Object.fromEntries(own), { requiredKeys: [] }),
  });
});

describe("an offered value", () => {
  test("removes its finding and adds no error", () => {
    let offers = 0;
    fc.assert(
      fc.property(cases, ({ cycle, tool, x, z, changes }) => {
        const values = { ...example(cycle), ...(changes as Numbers) };
        const before = issuesOf(cycle, values, tool, [x, z]);
        for (const found of before) {
          const offer = offerOf(found);
          if (offer === null || !found.at?.startsWith("Q")) continue;
          offers += 1;
          const after = issuesOf(cycle, { ...values, [found.at]: offer }, tool, [x, z]);
          expect(at(after, found.code, found.at), `${found.at}=${offer} for ${found.code}`).toBeUndefined();
          const added = [...keys(after)].filter((key) => !keys(before).has(key));
          expect(added, `${found.at}=${offer} for ${found.code}`).toEqual([]);
        }
      }),
      { numRuns: 250 },
    );
    expect(offers).toBeGreaterThan(50);
  });

  test("is never a dimension of the drawing: only the limit is named", () => {
    const tooLong = at(
      issuesOf(812, { ...example(812), Q495: 0, Q500: 60, Q502: 0.5 }, 1, [75, 2]),
      "elementTooLong",
      "Q500",
    );
    expect(tooLong?.data).toMatchObject({ size: 60, max: expect.any(Number) });
    expect(tooLong && offerOf(tooLong)).toBeNull();
    const round = at(issuesOf(812, { ...example(812), Q500: 0.4 }, 1, [75, 2]), "cornerSmallerThanInsert", "Q500");
    expect(round && offerOf(round)).toBeNull();
  });

  test("is the other sign of a dimension whose sign is impossible", () => {
    const offered = (q: string, value: number) =>
      issuesOf(812, { ...example(812), [q]: value }, 1, [75, 2])
        .filter(({ code, at: q2 }) => q2 === q && (code === "outOfRange" || code === "notAChoice"))
        .map((each) => offerOf(each));
    expect(offered("Q500", -2)).toEqual([2]);
    expect(offered("Q502", 500)).toEqual([]);
    expect(offered("Q500", 5000)).toEqual([null]);
    expect(offered("Q501", 7)).toEqual([null]);
    expect(offered("Q506", 7)).toEqual([2]);
    const negative = issuesOf(831, { ...example(831), Q475: 1, Q476: 1, Q491: -100 }, 12, [110, 10]);
    expect(negative.map((each) => [each.code, each.at, each.data])).toContainEqual([
      "diameterNegative",
      "Q491",
      {
        value: -100,
        nearest: 100,
      },
    ]);
  });

  test("in place of no infeed or a tiny one is the usual one; if that has too many passes, another round one", () => {
    const fine = at(issuesOf(812, { ...example(812), Q463: 0.001 }, 1, [75, 2]), "tooManyPasses", "Q463");
    expect(fine && offerOf(fine)).toBe(3);
    const none = at(issuesOf(812, { ...example(812), Q463: 0 }, 1, [75, 2]), "outOfRange", "Q463");
    expect(none && offerOf(none)).toBe(3);
    const wide = at(issuesOf(812, { ...example(812), Q491: 900, Q463: 0 }, 1, [900, 2]), "outOfRange", "Q463");
    expect(wide && offerOf(wide)).toBe(5);
    const late = at(issuesOf(820, { ...example(820), Q463: 1000 }, 15, [75, 2]), "outOfRange", "Q463");
    expect(late && offerOf(late)).toBe(5);
  });

  test("is only the usual infeed where no path could be tried", () => {
    const { Q494: _, ...incomplete } = example(812);
    const found = at(issuesOf(812, { ...incomplete, Q463: 0 }, 1, [75, 2]), "outOfRange", "Q463");
    expect(found && offerOf(found)).toBe(3);
  });
});
