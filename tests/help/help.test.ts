import { describe, expect, test } from "vitest";
import { labelsOverlap } from "../../src/view/help/labels.ts";
import { helpSvg } from "../../src/view/help/svg.ts";
import { cycles, drawn, exampleOf, flat } from "./drawings.ts";
import { cases, laws } from "./laws.ts";

const size = { width: 400, height: 280 };

describe.each(cycles.map((c) => [c.number, c] as const))("help picture of cycle %i", (number, cycle) => {
  test("draws the printed example as it did", async () => {
    const drawing = drawn(cycle, exampleOf(cycle), null, size);
    expect(drawing).not.toBeNull();
    if (drawing) await expect(helpSvg(drawing)).toMatchFileSnapshot(`${number}-example.svg`);
  });

  test.each(Object.keys(cycle.params))("%s is highlighted", (q) => {
    const drawing = drawn(cycle, exampleOf(cycle), q, size);
    expect(flat(drawing?.marks ?? []).filter((m) => m.active && m.q === q && m.kind !== "detail")).not.toEqual([]);
  });

  test.each(Object.keys(cycle.params).filter((q) => cycle.params[q]?.kind !== "choice"))("%s shows its value", (q) => {
    const drawing = drawn(cycle, exampleOf(cycle), q, size);
    const texts = (drawing?.marks ?? []).flatMap((m) => (m.kind === "text" && m.active && m.role === "value" ? [m.text] : []));
    expect(texts.join()).toContain(String(Math.abs(cycle.params[q]?.example ?? NaN)));
  });
});

test("a drawing holds no colours, only roles", () => {
  const text = cycles.map((c) => helpSvg(drawn(c, exampleOf(c), null, size) ?? { size, marks: [], labels: [] })).join("");
  expect(text).not.toMatch(/fill="|stroke="/);
});

describe("laws of the help picture", () => {
  laws("no text covers another, all stays finite, the active parameter shows", ({ cycle, values, q, size: s }) => {
    const drawing = drawn(cycle, values, q, s);
    if (!drawing) return;
    const all = flat(drawing.marks);
    expect(helpSvg(drawing)).not.toMatch(/NaN|Infinity|undefined/);
    expect(all.some((m) => m.active && m.q === q)).toBe(true);
    if (cycle.params[q]?.kind !== "choice") expect(all.some((m) => m.kind === "text" && m.active && m.role === "value")).toBe(true);
    drawing.labels.forEach((a, i) =>
      drawing.labels.slice(i + 1).forEach((b) => expect(labelsOverlap(a, b), JSON.stringify([a, b])).toBe(false))
    );
  });
  test("the random values make contours often enough to mean something", () => {
    const made = cases(300).filter(({ cycle, values, q, size: s }) => drawn(cycle, values, q, s) !== null);
    expect(made.length).toBeGreaterThan(100);
  });
});
