import fc from "fast-check";
import { expect, test } from "vitest";
import { withDifference, differenceOf, fingerprint, type Json } from "./difference.ts";

const { value } = fc.letrec<{ value: Json }>((tie) => ({
  value: fc.oneof(
    { maxDepth: 3 },
    fc.constantFrom<Json>(null, true, "", "Q494=-3.25", "Q494=-3.2", 41.3, 0),
    fc.string(),
    fc.array(tie("value"), { maxLength: 4 }),
    fc.dictionary(fc.constantFrom("x", "z", "__proto__", "text", "r"), tie("value"), { noNullPrototype: true }),
  ),
}));

test("applying the difference gives the other value", () => {
  fc.assert(
    fc.property(value, value, (a, b) => {
      expect(
        withDifference(a, JSON.parse(JSON.stringify(differenceOf(a, b))) as ReturnType<typeof differenceOf>),
      ).toEqual(b);
    }),
    { numRuns: 1500 },
  );
});

test("unchanged parts are shared, and cost nothing", () => {
  const rows = Array.from({ length: 90 }, (_, i) => ({ x: String(i), z: "-7.5" }));
  const before: Json = { name: "A", contour: rows, drafts: { 1: { Q1: "4" } } };
  const after: Json = { ...before, drafts: { 1: { Q1: "41" } } };
  const found = differenceOf(before, after);
  expect(JSON.stringify(found).length).toBeLessThan(100);
  expect((withDifference(before, found) as { contour: Json }).contour).toBe(rows);
});

test("a fingerprint ignores the order of fields, and differs between values", () => {
  expect(fingerprint({ a: 1, b: { c: "x", d: [2, 3] } })).toBe(fingerprint({ b: { d: [2, 3], c: "x" }, a: 1 }));
  expect(fingerprint({ a: "12" })).not.toBe(fingerprint({ a: "21" }));
  fc.assert(
    fc.property(value, value, (a, b) => {
      expect(fingerprint(a) === fingerprint(b)).toBe(differenceOf(a, b) === 0);
    }),
  );
});
