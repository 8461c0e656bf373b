import fc from "fast-check";
import { expect, test } from "vitest";
import { z } from "zod/mini";
import { jsonGauge, sieved } from "./bounded.ts";

/** Nesting, values and longest name of a text, from what it was written from. */
function sizeOf(value: unknown): { depth: number; values: number; name: number } {
  if (typeof value !== "object" || value === null) return { depth: 0, values: 0, name: -1 };
  const inner = Object.values(value).map(sizeOf);
  const names = Array.isArray(value) ? [] : Object.keys(value).map((each) => JSON.stringify(each).length - 2);
  return {
    name: Math.max(-1, ...names, ...inner.map(({ name }) => name)),
    depth: 1 + Math.max(0, ...inner.map(({ depth }) => depth)),
    values: inner.reduce((sum, { values }) => sum + values, 1) + Math.max(0, inner.length - 1),
  };
}

test("a JSON text is measured as it is nested, wherever it is cut, with brackets and quotes in its texts", () => {
  const text = fc.stringMatching(/^["\\[\]{},a]{0,5}$/);
  const value = fc.jsonValue({ maxDepth: 4, stringUnit: fc.constantFrom(...'"\\[]{},a') });
  fc.assert(
    fc.property(fc.tuple(value, fc.dictionary(text, text), fc.array(text)), fc.nat(), (all, at) => {
      const written = JSON.stringify(all);
      const cut = at % written.length;
      const exact = { ...sizeOf(JSON.parse(written)), length: written.length };
      const fits = (bounds: typeof exact) => {
        const gauge = jsonGauge(bounds);
        return gauge(written.slice(0, cut)) && gauge(written.slice(cut));
      };
      expect(fits(exact)).toBe(true);
      for (const key of ["depth", "values", "length", "name"] as const)
        expect(fits({ ...exact, [key]: exact[key] - 1 })).toBe(exact[key] < 0);
    }),
  );
});

test("a row that does not pass, or has the id of another, costs no other row", () => {
  const row = z.object({ id: z.string(), n: z.number() });
  const [one, alike, bad, two] = [
    { id: "a", n: 1 },
    { id: "a", n: 2 },
    { id: "b", n: "x", name: "BAD" },
    { id: "b", n: 3 },
  ];
  const list = sieved({ rows: [one, alike, bad, { id: "c", n: 4 }], other: 5 }, "rows", row);
  expect(list.raw).toEqual({ rows: [one, { id: "c", n: 4 }], other: 5 });
  expect(list.unread).toEqual([
    { name: "a", raw: alike },
    { name: "BAD", raw: bad },
  ]);
  expect(sieved({ rows: { p: one, q: bad, r: two } }, "rows", row)).toEqual({
    raw: { rows: { p: one, r: two } },
    unread: [{ name: "BAD", raw: bad }],
  });
  for (const raw of [null, [], "", { rows: null }, { rows: [one] }])
    expect(sieved(raw, "rows", row)).toEqual({ raw, unread: [] });
});
