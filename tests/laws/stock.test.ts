import fc from "fast-check";
import { expect, test } from "vitest";
import { areaOf } from "../../src/kernel/area/area.ts";
import { difference } from "../../src/kernel/area/clip.ts";
import { insertOutline } from "../../src/kernel/cutter/insert.ts";
import type { Move } from "../../src/kernel/plan/move.ts";
import { part, type Pt, type Ring } from "../../src/kernel/geometry/point.ts";
import type { Step } from "../../src/kernel/time/step.ts";
import { pathOf, travelOf } from "../../src/kernel/time/time.ts";
import { CHORD } from "../../src/kernel/tolerance.ts";
import { TOOL_TYPES, type TipOrientation, type Tool } from "../../src/kernel/plan/tool.ts";
import { axial, degrees, feed, length, radius } from "../../src/kernel/units.ts";
import type { PlayPosition, Simulation } from "../../src/sim/simulation.ts";
import { simulate } from "../../src/sim/simulate.ts";
import { playerOf, stockAt } from "../../src/sim/stock.ts";

/* Random tools on random paths through a cylinder: laws for any motion. */

const RUNS = { numRuns: 60 };
const at = (z: number, r: number): Pt => ({ z: axial(z), r: radius(r) });
const box = (z0: number, r0: number, z1: number, r1: number): Ring => [at(z0, r0), at(z1, r0), at(z1, r1), at(z0, r1)];
const blank = [box(-60, 5, 0, 40)];
const grid = (min: number, max: number) => fc.integer({ min: min * 1000, max: max * 1000 }).map((n) => n / 1000);

const tools = fc
  .record({
    type: fc.constantFrom(...TOOL_TYPES),
    orientation: fc.constantFrom(1, 2, 3, 4, 5, 6, 7, 8, 9),
    nose: grid(0.1, 1.2),
    angle: grid(91, 110),
    point: grid(35, 69),
    width: grid(2.5, 6),
    edge: grid(4, 20),
  })
  .map((t): Tool => ({
    T: 1,
    NAME: "ANY",
    TYPE: t.type,
    TO: t.orientation as TipOrientation,
    RS: length(t.nose),
    "T-ANGLE": degrees(t.angle),
    "P-ANGLE": degrees(t.point),
    CUTWIDTH: length(t.width),
    CUTLENGTH: length(t.edge),
  }));
const places = fc.tuple(grid(-65, 5), grid(0, 45)).map(([z, r]) => at(z, r));
const purpose = { phase: "rough", run: "rough", step: 1 } as const;
type Way = { to: Pt; kind: "rapid" | "feed" | "arc"; bulge: number; turn: "cw" | "ccw" };
const ways: fc.Arbitrary<Way> = fc.record({
  to: places,
  kind: fc.constantFrom("rapid", "feed", "feed", "arc"),
  bulge: grid(-2, 2),
  turn: fc.constantFrom("cw", "ccw"),
});

function moveOf(from: Pt, way: Way): Move {
  if (way.kind === "rapid") return { kind: "rapid", to: way.to, ...purpose };
  const feeding = { feed: feed(0.2), feedUnit: "mm/rev", ...purpose } as const;
  if (way.kind === "feed") return { kind: "feed", to: way.to, ...feeding };
  const [dz, dr] = [way.to.z - from.z, way.to.r - from.r];
  const centre = at((from.z + way.to.z) / 2 - dr * way.bulge, (from.r + way.to.r) / 2 + dz * way.bulge);
  return { kind: "arc", to: way.to, centre, turn: way.turn, ...feeding };
}
const programs = fc.tuple(tools, places, fc.array(ways, { minLength: 1, maxLength: 70 })).map(([tool, start, list]) => {
  let from = start;
  return list.map((way): Step => {
    const step = { from, move: moveOf(from, way), tool, block: 1, operation: null, seconds: 1 };
    from = way.to;
    return step;
  });
});
const run = (steps: readonly Step[]): Simulation => simulate({ blank, steps, operations: [], unproved: [] });
const momentOf = ({ steps }: Simulation, fraction: number): PlayPosition => {
  const all = fraction * steps.length;
  return { step: Math.floor(all), fraction: all - Math.floor(all) };
};
/** The stock together with the pieces that came off. */
const wholeOf = ({ final, proof }: Simulation): readonly Ring[] => [
  ...final,
  ...proof.loose.flatMap(({ rings }) => rings),
];
const unit = fc.double({ min: 0, max: 1, noNaN: true });

/** Playing, stepping back and seeking give the same stock, bit for bit; it only shrinks, and is always finite. */
function playsAlike(simulation: Simulation, fractions: readonly number[]): void {
  const { steps } = simulation;
  const player = playerOf(simulation);
  const shown = [0, ...fractions, 1].map((fraction) => {
    const position = momentOf(simulation, fraction),
      stock = stockAt(simulation, position);
    expect(player.at(position)).toEqual(stock);
    return { fraction, stock };
  });
  const stepped = playerOf(simulation);
  for (let step = 0; step < steps.length; step += 1) stepped.at({ step, fraction: 0.5 });
  expect(stepped.at({ step: steps.length, fraction: 0 })).toEqual(simulation.final);
  expect(shown.at(-1)?.stock).toEqual(simulation.final);

  let before: readonly Ring[] = blank;
  for (const { stock } of shown.sort((a, b) => a.fraction - b.fraction)) {
    expect(stock.flat().every((p) => Number.isFinite(p.z) && Number.isFinite(p.r))).toBe(true);
    expect(Math.abs(areaOf(difference(stock, before)))).toBeLessThan(1e-3);
    before = stock;
  }
}

test("the stock is the same however its moment is reached, and only shrinks; the same path again cuts nothing", () => {
  fc.assert(
    fc.property(programs, fc.array(unit, { minLength: 3, maxLength: 6 }), (steps, fractions) => {
      const simulation = run(steps);
      playsAlike(simulation, fractions);
      const back: Step = {
        ...(steps[0] as Step),
        from: (steps.at(-1) as Step).move.to,
        move: { kind: "rapid", to: (steps[0] as Step).from, ...purpose },
      };
      const [once, twice] = [run([...steps, back]), run([...steps, back, ...steps])];
      expect(Math.abs(areaOf(once.final) - areaOf(twice.final))).toBeLessThan(2e-3);
    }),
    RUNS,
  );
});

test("a straight slot removes exactly the width of the insert", () => {
  fc.assert(
    fc.property(tools, grid(-55, -5), (tool, z) => {
      const step = { tool, block: 1, operation: null, seconds: 1 };
      const down: Step = {
        ...step,
        from: at(z, 80),
        move: { kind: "feed", to: at(z, -60), feed: feed(1), feedUnit: "mm/rev", ...purpose },
      };
      const widths = insertOutline(tool, CHORD).map((p) => Math.min(0, Math.max(-60, p.z + z)));
      const gone = (Math.max(...widths) - Math.min(...widths)) * 35;
      expect(Math.abs(areaOf(blank) - areaOf(wholeOf(run([down]))) - gone)).toBeLessThan(0.01);
      expect(gone).toBeGreaterThan(1);
    }),
    RUNS,
  );
});

/** Signed distance of a point from a convex outline at a tip position: negative inside. */
function outside(outline: Ring, tip: Pt, p: { z: number; r: number }): number {
  let worst = -Infinity;
  let a = outline[outline.length - 1] as Pt;
  for (const b of outline) {
    const [ez, er] = [b.z - a.z, b.r - a.r];
    const size = Math.hypot(ez, er);
    if (size > 0) worst = Math.max(worst, (er * (p.z - tip.z - a.z) - ez * (p.r - tip.r - a.r)) / size);
    a = b;
  }
  return worst;
}

function holds(rings: readonly Ring[], p: { z: number; r: number }): boolean {
  let odd = false;
  for (const ring of rings) {
    let a = ring[ring.length - 1] as Pt;
    for (const b of ring) {
      if (a.r <= p.r !== b.r <= p.r && a.z + ((b.z - a.z) * (p.r - a.r)) / (b.r - a.r) > p.z) odd = !odd;
      a = b;
    }
  }
  return odd;
}

test("point by point: removed exactly where the insert has been", () => {
  const samples = fc.array(fc.tuple(grid(-59.9, -0.1), grid(5.1, 39.9)), { minLength: 40, maxLength: 40 });
  const short = programs.map((steps) => steps.slice(0, 6));
  fc.assert(
    fc.property(short, samples, (steps, points) => {
      const simulation = run(steps),
        whole = wholeOf(simulation);
      const outline = insertOutline((steps[0] as Step).tool, CHORD);
      const tips = steps.flatMap((s) => {
        const path = pathOf(s.from, s.move);
        const count = Math.max(1, Math.ceil(travelOf(path) / 0.1));
        return Array.from({ length: count + 1 }, (_, i) => part.pointOn(path, i / count));
      });
      const reach = Math.max(...outline.map((p) => Math.hypot(p.z, p.r))) + 0.06;
      for (const [z, r] of points) {
        // The workpiece rotates: a cut at -r also cuts at r.
        const near = [r, -r].flatMap((side) =>
          tips
            .filter((tip) => Math.hypot(z - tip.z, side - tip.r) <= reach)
            .map((tip) => outside(outline, tip, { z, r: side })),
        );
        const nearest = Math.min(Infinity, ...near);
        if (nearest < -0.01) expect(holds(simulation.final, { z, r })).toBe(false);
        else if (nearest > 0.06) expect(holds(whole, { z, r })).toBe(true);
      }
    }),
    { numRuns: 25 },
  );
});
