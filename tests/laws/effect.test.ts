import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { neutralValueOf, hasNoEffect } from "../../src/cycles/effect.ts";
import { cuttingCycles } from "../../src/cycles/index.ts";
import { roundedTo } from "../../src/program/values/field.ts";
import type { Param } from "../../src/cycles/params.ts";
import { casesOf, situations, type Situation } from "./situation.ts";
import { planOf } from "./worked-plans.ts";

/*
 * A value that a cycle's file declares to be without effect must have none: plan and outline are the same for any
 * value.
 */
const CASES = Number(process.env["LAW_CASES"] ?? 6);

/** Another allowed value, from a share of the range; feeds may be FAUTO. */
function valueAt({ kind, range: [min, max], choices, decimals }: Param, share: number): number | "auto" {
  if (choices) return choices[Math.floor(share * choices.length)] as number;
  if (kind === "feed" && share > 0.9) return "auto";
  // Sizes of a real part, within the range: nobody turns 99 m.
  const [low, high] = [Math.max(min, -300), Math.min(max, 300)];
  return roundedTo(low + share * (high - low), decimals);
}

const share = fc.integer({ min: 0, max: 999 }).map((n) => n / 1000);

const describeResult = (cycle: (typeof cuttingCycles)[number], s: Situation) =>
  JSON.stringify([planOf(cycle, s), cycle.outline(s.values as never, s.given)]);

for (const operation of [0, 1, 2, 3])
  describe.each(situations(operation))(`cycle $cycle.number, Q215 = ${operation}`, ({ cycle, arbitrary }) => {
    const conditions = Object.values<Param>(cycle.params).flatMap((p) => (p.condition === null ? [] : [p.condition.q]));
    const set = [...new Set(conditions)].filter((q) => q !== "Q215" && cycle.params[q]?.choices);

    test("a value without effect changes nothing", () => {
      fc.assert(
        fc.property(arbitrary, fc.array(share, { minLength: 40, maxLength: 40 }), (drawn, shares) => {
          const chosen = Object.fromEntries(
            set.map((q, i) => [q, valueAt(cycle.params[q] as Param, shares[i] as number)]),
          );
          const s = { ...drawn, values: { ...drawn.values, ...chosen } as Situation["values"] };
          const quiet = Object.entries<Param>(cycle.params).filter(([, p]) => hasNoEffect(p, s.values));
          if (quiet.length === 0) return;
          const other = Object.fromEntries(quiet.map(([q, p], i) => [q, valueAt(p, shares[10 + i] as number)]));
          const neutral = Object.fromEntries(quiet.map(([q, p]) => [q, neutralValueOf(p)]));
          const before = describeResult(cycle, s);
          expect(describeResult(cycle, { ...s, values: { ...s.values, ...other } as never })).toBe(before);
          expect(describeResult(cycle, { ...s, values: { ...s.values, ...neutral } })).toBe(before);
        }),
        { numRuns: casesOf(cycle, CASES) },
      );
    });
  });

/** Most set-ups per operation that are tried until every prompt of a cycle has had an effect. */
const LOOKED_AT = 40;

test.each(cuttingCycles.map((cycle) => [cycle.number, cycle] as const))(
  "cycle %s: every prompt that counts changes something",
  (number, cycle) => {
    const drawn = [0, 1, 2, 3].map((operation) =>
      situations(operation)
        .filter((s) => s.cycle.number === number)
        .flatMap(({ arbitrary }) => fc.sample(fc.tuple(arbitrary, share), LOOKED_AT)),
    );
    const waiting = new Set(Object.entries<Param>(cycle.params).flatMap(([q, p]) => (p.reserved ? [] : [q])));
    for (let k = 0; k < LOOKED_AT && waiting.size > 0; k += 1)
      for (const [s, at] of drawn.flatMap((row) => row.slice(k, k + 1)))
        for (const q of [...waiting]) {
          const p = cycle.params[q] as Param;
          const others = p.choices ?? [valueAt(p, at), p.example, p.range[0], p.range[1]];
          const counting =
            p.condition === null || p.condition.q === "Q215"
              ? {}
              : { [p.condition.q]: p.condition.among[k % p.condition.among.length] };
          const plans = others.map((value) =>
            describeResult(cycle, { ...s, values: { ...s.values, ...counting, [q]: value } as never }),
          );
          if (new Set(plans).size > 1) waiting.delete(q);
        }
    expect([...waiting]).toEqual([]);
  },
);

test("a condition names a choice of the same list, and only values that it has", () => {
  const wrong = cuttingCycles.flatMap((cycle) =>
    Object.entries<Param>(cycle.params)
      .filter(([, p]) => {
        const on = p.condition === null ? undefined : cycle.params[p.condition.q];
        return p.condition !== null && on !== undefined && !p.condition.among.every((n) => on.choices?.includes(n));
      })
      .map(([q]) => `${cycle.number} ${q}`),
  );
  expect(wrong).toEqual([]);
});
