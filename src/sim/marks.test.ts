import { expect, test } from "vitest";
import { unpacked } from "../kernel/area/clip.ts";
import type { Move } from "../kernel/plan/move.ts";
import type { Pt, Ring } from "../kernel/geometry/point.ts";
import type { Step } from "../kernel/time/step.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import { axial, feed, length, radius } from "../kernel/units.ts";
import { MOST_CONTACTS } from "./check.ts";
import { stockIssues } from "./issues.ts";
import { marksOf } from "./marks.ts";
import { simulate } from "./simulate.ts";
import { playerOf } from "./stock.ts";

const at = (z: number, r: number): Pt => ({ z: axial(z), r: radius(r) });
const box = (z0: number, r0: number, z1: number, r1: number): Ring => [at(z0, r0), at(z1, r0), at(z1, r1), at(z0, r1)];
const tool: Tool = { T: 3, NAME: "BUTTON", TYPE: "BUTTON", TO: 2, RS: length(0.7) };
const blank = [box(-90, 0, 0, 31)];

/** Moves that each cut a little in a different place. */
function steps(count: number, kind: "rapid" | "feed"): Step[] {
  const purpose = { phase: "rough", run: "rough", step: 1 } as const;
  let from = at(2, 33);
  return Array.from({ length: count }, (_, i) => {
    const to = i % 2 === 0 ? at(-0.41 * ((i * 7) % 211), 29.3 - (i % 5) * 0.37) : at(-0.41 * ((i * 7) % 211), 33);
    const move: Move =
      kind === "rapid" ? { kind, to, ...purpose } : { kind, to, feed: feed(0.2), feedUnit: "mm/rev", ...purpose };
    const step: Step = { from, move, tool, block: 10 + i, operation: null, seconds: 1 };
    from = to;
    return step;
  });
}

test("stored stocks respect the point limit, keep the first, and never lose a mark", () => {
  const marks = marksOf([], 500);
  for (let i = 0; i < 1000; i += 1) marks.add(i * 50, [box(-i - 1, 0, 0, 1 + i)]);
  const all = marks.all();
  expect(all.map((m) => m.step)).toEqual(Array.from({ length: 1000 }, (_, i) => i * 50));
  const kept = all.filter((m) => m.stock);
  expect(kept.length * 4).toBeLessThanOrEqual(500);
  expect(kept.length * 4).toBeGreaterThan(200);
  expect(all[0]?.stock).not.toBeNull();
  for (const { step, stock } of kept) expect(unpacked(stock ?? [])).toEqual([box(-step / 50 - 1, 0, 0, 1 + step / 50)]);
});

test("a run with few stored stocks gives the same stock at every moment, to the last bit, in any order", () => {
  const whole = simulate({ blank, steps: steps(900, "feed"), operations: [], unproved: [] });
  expect(whole.checkpoints.length).toBeGreaterThan(15);
  const thin = { ...whole, checkpoints: whole.checkpoints.map((c, i) => (i % 8 === 0 ? c : { ...c, stock: null })) };
  const [one, other] = [playerOf(whole), playerOf(thin)];
  for (const step of [0, 1, 49, 50, 51, 399, 400, 401, 120, 777, 778, 900, 3, 850])
    for (const fraction of [0, 0.37]) expect(other.at({ step, fraction })).toEqual(one.at({ step, fraction }));
});

test("after a thousand damaging moves the check stops, and reports where", () => {
  const clean = simulate({ blank, steps: steps(2 * MOST_CONTACTS + 300, "feed"), operations: [], unproved: [] });
  expect(clean.proof.uncheckedFrom).toBeNull();
  const bad = steps(2 * MOST_CONTACTS + 300, "rapid").map((s, i) => ({
    ...s,
    from: at(-0.043 * i - 0.3, 33),
    move: { ...s.move, to: at(-0.043 * i - 0.3, 25) },
  }));
  const s = simulate({ blank, steps: bad, operations: [], unproved: [] });
  const unlooked = s.proof.uncheckedFrom;
  expect(unlooked?.step).toBeGreaterThanOrEqual(MOST_CONTACTS);
  expect(unlooked?.block).toBe(10 + (unlooked?.step ?? 0));
  expect(s.findings.reduce((sum, f) => sum + f.moves, 0)).toBe(MOST_CONTACTS);
  expect(stockIssues(s).filter((i) => i.issue.code === "contactsUnlooked")).toMatchObject([
    {
      issue: { severity: "error" },
      block: unlooked?.block,
    },
  ]);
});
