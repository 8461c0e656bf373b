import fc from "fast-check";
import { expect, test } from "vitest";
import boring from "../../tests/programs/cycle-851.h?raw";
import { insertOutline } from "../kernel/cutter/insert.ts";
import type { Move } from "../kernel/plan/move.ts";
import { at, type Pt } from "../kernel/geometry/point.ts";
import type { Step } from "../kernel/time/step.ts";
import { CHORD, SAME } from "../kernel/tolerance.ts";
import { feed } from "../kernel/units.ts";
import { parse } from "../nc/parse.ts";
import { run } from "../program/run/run.ts";
import { shippedTools } from "../program/tools/shipped-tools.ts";
import { sweptBy } from "./sweep.ts";
import { touchIndex } from "./touch-index.ts";

const [tool, other] = shippedTools as [Step["tool"], Step["tool"]];

/** Reference result, from every sweep. */
function latestOf(steps: readonly Step[], z: number, r: number, now: number, fraction: number): number {
  const touches = (step: Step, part: number) =>
    step.move.kind !== "rapid" &&
    (step.move.to.z !== step.from.z || step.move.to.r !== step.from.r) &&
    sweptBy(insertOutline(step.tool, CHORD), step, part).pieces.some(({ box, sides }) => {
      if (z < box.left - SAME || z > box.right + SAME || r < box.low - SAME || r > box.high + SAME) return false;
      return (
        sides.length > 0 &&
        sides.every((nz, i) => i % 3 !== 0 || nz * z + (sides[i + 1] ?? 0) * r - (sides[i + 2] ?? 0) <= SAME)
      );
    });
  return steps.findLastIndex((step, i) =>
    i < now ? touches(step, 1) : i === now && fraction > 0 && touches(step, fraction),
  );
}

const place = fc
  .record({ z: fc.integer({ min: -4000, max: 300 }), r: fc.integer({ min: -300, max: 2500 }) })
  .map(({ z, r }) => at(z / 97, r / 97));
const FEEDING = { feed: feed(0.2), feedUnit: "mm/rev", phase: "rough", run: "rough", step: 1 } as const;
const move = fc.record({
  to: place,
  kind: fc.constantFrom("rapid", "feed", "feed", "arc"),
  near: place,
  second: fc.boolean(),
});

/** Successive moves with two tools; an arc is centred square to the middle of its chord. */
function stepsOf(start: Pt, moves: readonly { to: Pt; kind: "rapid" | "feed" | "arc"; second: boolean }[]): Step[] {
  let from = start;
  return moves.map(({ to, kind, second }): Step => {
    const centre = at((from.z + to.z - (to.r - from.r)) / 2, (from.r + to.r + (to.z - from.z)) / 2);
    const made: Move = kind === "arc" ? { kind, to, centre, turn: "ccw", ...FEEDING } : { kind, to, ...FEEDING };
    const step = { from, move: made, tool: second ? other : tool, block: 4, operation: null, seconds: 1 };
    from = to;
    return step;
  });
}

test("the index finds the same latest touching move as a test of each move", () => {
  fc.assert(
    fc.property(
      place,
      fc.array(move, { minLength: 1, maxLength: 90 }),
      fc.array(place, { maxLength: 12 }),
      fc.nat(),
      fc.nat(9),
      (start, moves, places, seed, tenths) => {
        const steps = stepsOf(start, moves),
          now = seed % (steps.length + 1),
          index = touchIndex(steps);
        // Ends of moves lie on edges of the sweep.
        for (const { z, r } of [...places, ...moves.slice(0, 9).map(({ to }) => to)])
          expect(index.latest(z, r, { step: now, fraction: tenths / 10 }, -1)).toBe(
            latestOf(steps, z, r, now, tenths / 10),
          );
      },
    ),
    { numRuns: 60 },
  );
});

test("an index derived from a run with the same beginning gives the same answers", () => {
  const { steps } = run(parse(boring), { tools: shippedTools, rapid: 10_000 });
  const more = [...steps, ...steps.slice(3, 71)],
    first = touchIndex(steps),
    end = { step: more.length, fraction: 0 };
  first.latest(-10, 20, end, -1);
  const again = first.of(more),
    less = again.of(steps.slice(0, 77)),
    own = touchIndex(more),
    short = touchIndex(steps.slice(0, 77));
  for (const {
    move: { to },
    from,
  } of more)
    for (const p of [to, at((from.z + to.z) / 2, to.r)]) {
      expect(again.latest(p.z, p.r, end, -1)).toBe(own.latest(p.z, p.r, end, -1));
      expect(less.latest(p.z, p.r, end, -1)).toBe(short.latest(p.z, p.r, end, -1));
      expect(own.latest(p.z, p.r, end, 9)).toBe(
        Math.max(own.latest(p.z, p.r, end, -1), 9) === 9 ? -1 : own.latest(p.z, p.r, end, -1),
      );
    }
});
