import { expect, test } from "vitest";
import { c831 } from "../../src/cycles/c831.ts";
import { at } from "../../src/kernel/geometry/point.ts";
import { shippedTools } from "../../src/program/tools/shipped-tools.ts";
import type { Situation } from "./situation.ts";
import { planOf, simulated } from "./worked-plans.ts";

const example = Object.fromEntries(Object.entries(c831.params).map(([q, p]) => [q, p.example as number]));
/** A thread on a shaft of 40 mm, cut into its blank. */
function cut(own: Readonly<Record<string, number>>) {
  const start = at(24, 12);
  const s: Situation = {
    values: { ...example, Q460: 6, Q491: 40, Q494: -16.3, Q476: 0, ...own },
    given: { contour: null, start },
    tool: shippedTools.find((t) => t.T === 12) as Situation["tool"],
    start,
    blank: [[at(0, 0), at(0, 20), at(-40, 20), at(-40, 0)]],
  };
  const plan = planOf(c831, s);
  return { plan, proof: simulated([plan], s).proof };
}

test.each([
  { grooves: 1, angle: 0 },
  { grooves: 1, angle: 250 },
  { grooves: 3, angle: 0 },
  { grooves: 3, angle: 40 },
])(
  "the teeth of $grooves grooves from $angle° on stand in the stock as the finished part has them",
  ({ grooves, angle }) => {
    const { plan, proof } = cut({ Q472: 1.7 * grooves, Q475: grooves, Q470: angle });
    const begun = plan.moves.flatMap((m, i) =>
      m.kind === "thread" && plan.moves[i - 1]?.kind !== "thread" ? [m.angle] : [],
    );
    const every = Array.from({ length: grooves }, (_, i) => (angle + (360 * i) / grooves) % 360);
    expect([...new Set(begun)]).toEqual(every);
    expect(proof.gouge).toBe(0);
    expect(proof.residual).toEqual([]);
  },
);

test.each([
  { out: 4.3, flank: 30 },
  { out: 16.3, flank: 30 },
  { out: 1, flank: 29 },
  { out: 4.3, flank: 0 },
])("passes that rise along a run-out of $out mm, fed in at $flank°, leave the part that they say", ({ out, flank }) => {
  const { plan, proof } = cut({ Q472: 2, Q475: 1, Q474: out, Q467: flank, Q463: 0.25 });
  const rises = plan.moves.filter((m) => m.kind === "thread" && Math.abs(m.to.z + 16.3) < 1e-9);
  expect(rises.length).toBe(plan.passes);
  for (const m of rises) expect(m.to.r).toBeCloseTo(20, 9);
  expect(proof.gouge).toBe(0);
  expect(proof.residual).toEqual([]);
});
