import { describe, expect, test } from "vitest";
import { c852 } from "../../src/cycles/c852.ts";
import { defineCycle, type Cycle } from "../../src/cycles/define.ts";
import { choice, diameterParam, lengthParam, radial } from "../../src/cycles/params.ts";
import { recessOutline } from "../../src/cycles/recess-outline.ts";
import { emptyPlan } from "../../src/kernel/strategy/leveled.ts";
import { axial, degrees, diameter, length } from "../../src/kernel/units.ts";
import type { Numbers } from "../../src/view/help/lettering.ts";
import { labelsOverlap } from "../../src/view/dimensions/labels.ts";
import { helpSvg } from "../../src/view/help/svg.ts";
import { cycles, exampleOf, flat, partlyPictured, pictured } from "./drawings.ts";
import { laws, RUNS } from "./laws.ts";

const size = { width: 400, height: 280 };

describe.each(cycles.map((c) => [c.number, c] as const))("help picture of cycle %i", (number, cycle) => {
  const picture = pictured(cycle, exampleOf(cycle));
  test("draws the printed example as it did", async () => {
    await expect(picture && helpSvg(picture(null, size))).toMatchFileSnapshot(`${number}-example.svg`);
  });

  test.each(Object.keys(cycle.params))("%s is highlighted, and shows its value", (q) => {
    const marks = picture?.(q, size).marks ?? [];
    expect(flat(marks).filter((m) => m.active && m.q === q && m.kind !== "detail")).not.toEqual([]);
    if (cycle.params[q]?.kind === "choice") return;
    const texts = marks.flatMap((m) => (m.kind === "text" && m.active && m.role === "value" ? [m.text] : []));
    expect(texts.join()).toContain(String(Math.abs(Number(exampleOf(cycle)[q]))));
  });
});

/** A groove along the axis that is not in the catalogue, without known texts and without a plan. */
const madeUp = defineCycle({
  number: 1,
  group: "recessTurning",
  manual: { section: "", document: "" },
  evidence: "I",
  contour: "own",
  params: {
    Q1: choice("how", [0, 1], 0, { shown: "operation" }),
    Q2: diameterParam("wide", [0, 999], 80),
    Q3: choice("last corner", [0, 1, 2], 2, { shown: "element", place: "end" }),
    Q4: lengthParam("its size", [0, 99], 2, { sizes: "Q3", place: "end" }),
    Q5: radial("deep", [0, 99], 3, { shown: "infeed" }),
    Q6: lengthParam("kept", [0, 99], 0.2, { shown: "oversizeZ" }),
  },
  setup: c852.setup,
  steps: { rough: 0, finish: 0 },
  outline: (v) => {
    const box = {
      Q491: v.Q2,
      Q492: axial(-10),
      Q493: diameter(60),
      Q494: axial(-30),
      Q495: degrees(5),
      Q496: degrees(0),
    };
    const corners = { Q501: 0, Q502: length(0), Q500: length(1), Q503: v.Q3, Q504: v.Q4 };
    return recessOutline({ ...box, ...corners }, { transverse: false, signU: -1, signV: 1 });
  },
  plan: () => emptyPlan([]),
});

test.each(Object.keys(madeUp.params))("a cycle that the picture has never seen shows %s", (q) => {
  const drawing = pictured(madeUp as unknown as Cycle, exampleOf(madeUp as unknown as Cycle))?.(q, size);
  expect(flat(drawing?.marks ?? []).filter((m) => m.active && m.q === q)).not.toEqual([]);
  expect(drawing && helpSvg(drawing)).not.toMatch(/NaN|Infinity|undefined/);
});

test("a drawing holds no colours, only roles", () => {
  const text = cycles
    .map((c) => helpSvg(pictured(c, exampleOf(c))?.(null, size) ?? { size, marks: [], labels: [] }))
    .join("");
  expect(text).not.toMatch(/fill="|stroke="/);
});

describe("while values are missing", () => {
  test.each<[number, string, Numbers]>([
    [812, "Q502", { Q215: 1, Q460: 1.7, Q491: 38.46, Q492: 1.7, Q493: 26.04, Q494: -17.3, Q495: 2.5, Q501: 2 }],
    [820, "Q478", { Q215: 0, Q463: 1.35 }],
    [831, "Q494", { Q471: 0, Q491: 23.9, Q492: -3.2 }],
    [852, "Q494", { Q215: 0, Q491: 61.37, Q492: 0.8, Q493: 42.11 }],
    [861, "Q493", {}],
  ])("cycle %i at %s is drawn with what is typed", async (number, q, typed) => {
    const cycle = cycles.find((c) => c.number === number) as Cycle;
    const drawing = partlyPictured(cycle, typed)?.(q, size);
    await expect(drawing && helpSvg(drawing)).toMatchFileSnapshot(`${number}-partial.svg`);
  });

  test.each(cycles.map((c) => [c.number, c] as const))("cycle %i shows only typed numbers", (_, cycle) => {
    const picture = partlyPictured(cycle, {});
    // The diagrams of a choice contain its numbers.
    for (const q of Object.keys(cycle.params).filter((each) => !cycle.params[each]?.choices)) {
      const marks = flat(picture?.(q, size).marks ?? []);
      const texts = marks.flatMap((m) => (m.kind === "text" && m.role === "value" ? [m.text] : []));
      expect(texts).toContain(q);
      expect(
        texts.filter((text) => !/^Q\d+$/.test(text)),
        q,
      ).toEqual([]);
    }
  });
});

test("no text covers another, all stays finite, the active parameter shows", () => {
  let made = 0;
  laws(({ cycle, values, q, size: s }) => {
    const drawing = pictured(cycle, values)?.(q, s);
    if (!drawing) return;
    made += 1;
    const all = flat(drawing.marks);
    expect(helpSvg(drawing)).not.toMatch(/NaN|Infinity|undefined/);
    expect(all.some((m) => m.active && m.q === q)).toBe(true);
    if (cycle.params[q]?.kind !== "choice")
      expect(all.some((m) => m.kind === "text" && m.active && m.role === "value")).toBe(true);
    const over = drawing.labels.flatMap((a, i) =>
      drawing.labels.slice(i + 1).flatMap((b) => (labelsOverlap(a, b) ? [[a, b]] : [])),
    );
    expect(over).toEqual([]);
  });
  expect(made).toBeGreaterThan(RUNS / 3);
});
