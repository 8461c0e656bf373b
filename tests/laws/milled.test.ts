import fc from "fast-check";
import { describe, expect, test } from "vitest";
import type { Ring } from "../../src/kernel/geometry/point.ts";
import { parse } from "../../src/nc/parse.ts";
import { milledStock } from "../../src/sim/plane/milled.ts";
import { run } from "../../src/program/run/run.ts";
import type { PlaneStep } from "../../src/program/tools/plane-types.ts";

/*
 * Laws over the stock of whole milling programs with RL and RR: the removed area is compared with sample points of a
 * second calculation that knows only distances, neither offsets nor polygons.
 */
interface Spot {
  readonly x: number;
  readonly y: number;
}
/** A point of the programmed contour, and all directions perpendicular to it on the side of the tool. */
interface Sample extends Spot {
  readonly off: readonly Spot[];
}
const far = (a: Spot, b: Spot) => Math.hypot(a.x - b.x, a.y - b.y);
const round3 = (n: number) => Math.round(n * 1000) / 1000;
const word = (axis: string, value: number) => `${axis}${value < 0 ? "" : "+"}${round3(value)}`;
const at = (p: Spot) => `${word("X", p.x)} ${word("Y", p.y)}`;

const corner = fc.record({
  turn: fc.integer({ min: -115, max: 115 }),
  long: fc.integer({ min: 3, max: 60 }),
  bend: fc.constantFrom(0, 0, 0.6, -0.6, 1.5, -1.5, 3),
});
const situation = fc.record({
  corners: fc.array(corner, { minLength: 2, maxLength: 7 }),
  side: fc.constantFrom("RL", "RR"),
  tool: fc.integer({ min: 1, max: 24 }).map((n) => round3(n / 2 + 0.137)),
  form: fc.constantFrom("LT", "LN", "CT", "LCT"),
  end: fc.constantFrom("LT", "LN", "CT", "LCT"),
  size: fc.integer({ min: 2, max: 30 }),
  away: fc.integer({ min: 20, max: 60 }),
  heading: fc.integer({ min: 0, max: 359 }),
});
type Situation = typeof situation extends fc.Arbitrary<infer T> ? T : never;

/** An element: a line, or an arc of less than half a circle. */
interface Element {
  readonly from: Spot;
  readonly to: Spot;
  readonly centre: Spot | null;
  readonly ccw: boolean;
}
const unit = (degrees: number): Spot => ({
  x: Math.cos((degrees * Math.PI) / 180),
  y: Math.sin((degrees * Math.PI) / 180),
});

function elementsOf(s: Situation): Element[] {
  let heading = s.heading,
    from: Spot = { x: 0, y: 0 };
  return s.corners.map(({ turn, long, bend }) => {
    const way = unit(heading),
      to = { x: round3(from.x + way.x * long), y: round3(from.y + way.y * long) };
    const half = far(from, to) / 2,
      r = bend === 0 ? 0 : round3(half * (1 + Math.abs(bend)));
    const deep = Math.sqrt(Math.max(0, r * r - half * half)),
      sign = bend > 0 ? 1 : -1;
    const made: Element = {
      from,
      to,
      centre:
        bend === 0
          ? null
          : {
              x: (from.x + to.x) / 2 - (sign * deep * (to.y - from.y)) / (2 * half),
              y: (from.y + to.y) / 2 + (sign * deep * (to.x - from.x)) / (2 * half),
            },
      ccw: bend > 0,
    };
    heading += turn;
    from = to;
    return made;
  });
}

const sizes = (form: string, { size }: Situation) =>
  form === "LCT" ? `R${size}` : form === "CT" ? `CCA90 R+${size}` : `LEN${size}`;

function text(s: Situation, elements: readonly Element[]): string {
  const first = elements[0]?.from ?? { x: 0, y: 0 },
    left = s.side === "RL" ? 1 : -1;
  const out = (p: Spot, e: Element | undefined, back: number): Spot => {
    const long = e ? far(e.from, e.to) : 1,
      wx = e ? (e.to.x - e.from.x) / long : 1,
      wy = e ? (e.to.y - e.from.y) / long : 0;
    return {
      x: round3(p.x - left * wy * s.away + back * wx * s.away),
      y: round3(p.y + left * wx * s.away + back * wy * s.away),
    };
  };
  const start = out(first, elements[0], -1),
    last = elements.at(-1),
    finish = out(last?.to ?? first, last, 1);
  return [
    "BEGIN PGM LAW MM",
    "BLK FORM 0.1 Z X-400 Y-400 Z-20",
    "BLK FORM 0.2 X+400 Y+400 Z+0",
    `TOOL DEF 1 L+0 R+${s.tool}`,
    "TOOL CALL 1 Z S4000",
    "L Z+50 R0 FMAX",
    `L ${at(start)} R0 FMAX`,
    "L Z-5 R0 F300",
    `APPR ${s.form} ${at(first)} ${sizes(s.form, s)} ${s.side} F200`,
    ...elements.map((e) =>
      e.centre ? `CR ${at(e.to)} R+${round3(far(e.from, e.centre))} DR${e.ccw ? "+" : "-"}` : `L ${at(e.to)}`,
    ),
    `DEP ${s.end}${s.end === "LCT" ? ` ${at(finish)}` : ""} ${sizes(s.end, s)} F300`,
    "L Z+60 R0 FMAX M2",
    "END PGM LAW MM",
  ].join("\n");
}

const RUNS = 40;
/** Between two points of a contour, mm. */
const STEP = 0.2;
/** The contour as dense points; a corner has every direction between those of its neighbours. */
function samplesOf(elements: readonly Element[], side: string): Sample[] {
  const left = side === "RL" ? 1 : -1;
  const pieces = elements.map((e) => {
    const a = e.centre ? Math.atan2(e.from.y - e.centre.y, e.from.x - e.centre.x) : 0;
    const b = e.centre ? Math.atan2(e.to.y - e.centre.y, e.to.x - e.centre.x) : 0;
    const r = e.centre ? far(e.from, e.centre) : 0,
      sweep = e.ccw ? (b - a + 4 * Math.PI) % (2 * Math.PI) : -((a - b + 4 * Math.PI) % (2 * Math.PI));
    const count = Math.ceil((e.centre ? Math.abs(sweep) * r : far(e.from, e.to)) / STEP);
    return Array.from({ length: count + 1 }, (_, i): Sample => {
      const k = i / count;
      if (e.centre) {
        const angle = a + sweep * k,
          n = (e.ccw ? -1 : 1) * left;
        return {
          x: e.centre.x + r * Math.cos(angle),
          y: e.centre.y + r * Math.sin(angle),
          off: [{ x: n * Math.cos(angle), y: n * Math.sin(angle) }],
        };
      }
      const long = far(e.from, e.to),
        wx = (e.to.x - e.from.x) / long,
        wy = (e.to.y - e.from.y) / long;
      return { x: e.from.x + wx * long * k, y: e.from.y + wy * long * k, off: [{ x: -left * wy, y: left * wx }] };
    });
  });
  const corners = pieces.slice(1).map((piece, i): Sample[] => {
    const [one, two] = [pieces[i]?.at(-1), piece[0]],
      [n, m] = [one?.off[0], two?.off[0]];
    if (!one || !n || !m) return [];
    const a = Math.atan2(n.y, n.x),
      turn = Math.atan2(n.x * m.y - n.y * m.x, n.x * m.x + n.y * m.y);
    if (turn * left > 0) return [];
    const count = Math.ceil(Math.abs(turn) / 0.01) + 1;
    return [
      {
        x: one.x,
        y: one.y,
        off: Array.from({ length: count }, (_, k) => ({
          x: Math.cos(a + (turn * k) / count),
          y: Math.sin(a + (turn * k) / count),
        })),
      },
    ];
  });
  return [...pieces.flat(), ...corners.flat()];
}

/** The distance of a point from a motion in the plane, calculated independently. */
function fromMotion(p: Spot, s: PlaneStep): number {
  if (s.centre && s.turn) {
    const c = s.centre,
      r = far(s.from, c),
      angle = (q: Spot) => Math.atan2(q.y - c.y, q.x - c.x);
    const from = angle(s.from),
      whole = 2 * Math.PI,
      sign = s.turn === "ccw" ? 1 : -1;
    const turnTo = (q: Spot) => (((sign * (angle(q) - from)) % whole) + whole) % whole;
    const sweep = far(s.from, s.to) < 1e-9 ? whole : turnTo(s.to);
    return turnTo(p) <= sweep ? Math.abs(far(p, c) - r) : Math.min(far(p, s.from), far(p, s.to));
  }
  const dx = s.to.x - s.from.x,
    dy = s.to.y - s.from.y,
    long = dx * dx + dy * dy;
  const k = long === 0 ? 0 : Math.max(0, Math.min(1, ((p.x - s.from.x) * dx + (p.y - s.from.y) * dy) / long));
  return far(p, { x: s.from.x + dx * k, y: s.from.y + dy * k });
}

const isIn = (rings: readonly Ring[], p: Spot): boolean => {
  let inside = false;
  for (const ring of rings)
    ring.forEach((a, i) => {
      const b = ring[(i + 1) % ring.length] ?? a;
      if (a.r > p.y !== b.r > p.y && p.x < a.z + ((p.y - a.r) / (b.r - a.r)) * (b.z - a.z)) inside = !inside;
    });
  return inside;
};

function worked(s: Situation) {
  const elements = elementsOf(s),
    done = run(parse(text(s, elements)), { tools: [], rapid: 10_000, control: "TNC 640" });
  const stock = milledStock({ motions: done.plane, bodies: [{ step: 0, body: { block: done.cuboid, turned: null } }] });
  stock?.advance(Infinity);
  const standing = stock?.at({ step: done.plane.length, fraction: 0 }).standing[0] ?? [];
  return { elements, done, standing };
}
/** Random points round a contour, the same in every run. */
function* points(elements: readonly Element[], reach: number, count: number): Generator<Spot> {
  const xs = elements.flatMap((e) => [e.from.x, e.to.x]),
    ys = elements.flatMap((e) => [e.from.y, e.to.y]);
  const [left, right, low, high] = [
    Math.min(...xs) - reach,
    Math.max(...xs) + reach,
    Math.min(...ys) - reach,
    Math.max(...ys) + reach,
  ];
  for (let i = 1; i <= count; i += 1)
    yield { x: left + (right - left) * ((i * 0.7548776662) % 1), y: low + (high - low) * ((i * 0.569840291) % 1) };
}

/** Tolerance of the second calculation by points, mm. */
const LEAST = 0.5;
const isLow = (m: PlaneStep) => (m.to.z ?? 1) < 0 && (m.from.z ?? 1) < 0;
const codes = (done: ReturnType<typeof worked>["done"]) =>
  done.issues.filter((i) => i.issue.severity !== "info").map((i) => i.issue.code);
/** The low motions along the contour, and those of approach and departure. */
function waysOf({
  plane,
  approaches,
}: ReturnType<typeof worked>["done"]): readonly [readonly PlaneStep[], readonly PlaneStep[]] {
  const leads = new Set(approaches.map((a) => a.index)),
    low = plane.filter(isLow);
  return [low.filter((m) => !leads.has(m.index)), low.filter((m) => leads.has(m.index))];
}
/** Centres at which a tool touches the contour on the side of RL or RR and cuts it nowhere. */
function freeCentres(elements: readonly Element[], { side, tool }: Situation): Spot[] {
  const samples = samplesOf(elements, side);
  const touching = samples.flatMap((q) => q.off.map((n) => ({ x: q.x + n.x * tool, y: q.y + n.y * tool })));
  return touching.filter((c) => samples.every((o) => far(o, c) >= tool - 0.01));
}

/** The same with turns to the side of the tool: pockets with narrow mouths. */
const inward = situation.map((s): Situation => ({
  ...s,
  corners: s.corners.map((c, i) => (i % 3 === 2 ? c : { ...c, turn: (s.side === "RL" ? 1 : -1) * Math.abs(c.turn) })),
}));
/** A fixed selection: with a few of them the tool cuts into the contour, and another radius would not. */
const SOME_CUT: [Situation][] = fc.sample(inward, { numRuns: RUNS, seed: 47 }).map((s) => [s]);
/** Whether a contour crosses itself: the side of the material is then undefined. */
function crosses(elements: readonly Element[], side: string): boolean {
  const samples = elements.map((e) => samplesOf([e], side));
  return samples.some((one, i) =>
    samples.slice(i + 2).some((other) => one.some((p) => other.some((q) => far(p, q) < STEP))),
  );
}

/** Whether a contour reverses, as where two circles touch: rounding then decides the side of that corner. */
const turnsBack = (elements: readonly Element[], side: string) =>
  elements.slice(1).some((e, i) => {
    const [n, m] = [samplesOf(elements.slice(i, i + 1), side).at(-1)?.off[0], samplesOf([e], side)[0]?.off[0]];
    return n !== undefined && m !== undefined && n.x * m.x + n.y * m.y < -0.995;
  });

describe("the stock of programs with RL and RR", () => {
  test("loses exactly the area within the tool radius of a motion", () => {
    let seen = 0;
    fc.assert(
      fc.property(situation, (s) => {
        const { elements, done, standing } = worked(s),
          low = done.plane.filter(isLow),
          said = text(s, elements);
        for (const p of points(elements, 2 * s.tool + s.away, 300)) {
          const gap = Math.min(...low.map((m) => fromMotion(p, m))) - s.tool;
          if (Math.abs(gap) < 0.02) continue;
          seen += 1;
          expect(isIn(standing, p), said).toBe(gap > 0);
        }
      }),
      { numRuns: RUNS },
    );
    expect(seen).toBeGreaterThan(250 * RUNS);
  });

  test("loses the area of a tool that touches the contour wherever possible", () => {
    let free = 0;
    fc.assert(
      fc.property(situation, (s) => {
        const { elements, done } = worked(s);
        if (codes(done).length > 0 || crosses(elements, s.side) || turnsBack(elements, s.side)) return;
        free += 1;
        const centres = freeCentres(elements, s),
          [own, leads] = waysOf(done),
          said = text(s, elements);
        for (const p of points(elements, 2 * s.tool, 300)) {
          const should = Math.min(...centres.map((c) => far(c, p))) - s.tool,
            does = Math.min(...own.map((m) => fromMotion(p, m))) - s.tool;
          if (should < -LEAST) expect(does, said).toBeLessThan(LEAST);
          if (should > LEAST && leads.every((m) => fromMotion(p, m) > s.tool))
            expect(does, said).toBeGreaterThan(-LEAST);
        }
      }),
      { numRuns: RUNS },
    );
    expect(free).toBeGreaterThan(RUNS / 6);
  });

  test("is not cut beyond the contour without a finding with the depth and a radius that passes", () => {
    let [clear, said, offered] = [0, 0, 0];
    fc.assert(
      fc.property(inward, (s) => {
        const { elements, done } = worked(s),
          found = done.issues.find(({ issue }) => issue.code === "pathCutsContour")?.issue;
        if (crosses(elements, s.side) || codes(done).includes("toolRadiusTooLarge")) return;
        const samples = samplesOf(elements, s.side),
          [own] = waysOf(done);
        const deep = s.tool - Math.min(...samples.flatMap((q) => own.map((m) => fromMotion(q, m))));
        if (found?.code !== "pathCutsContour") {
          clear += 1;
          expect(deep, text(s, elements)).toBeLessThan(0.05);
          return;
        }
        said += 1;
        expect(Math.abs(deep - found.data.depth), text(s, elements)).toBeLessThan(0.1);
        if (found.data.nearest === undefined) return;
        offered += 1;
        const then = codes(worked({ ...s, tool: found.data.nearest }).done);
        expect(
          then.filter((code) => code === "pathCutsContour" || code === "toolRadiusTooLarge"),
          text(s, elements),
        ).toEqual([]);
      }),
      { numRuns: 2 * RUNS, examples: SOME_CUT },
    );
    expect(clear).toBeGreaterThan(RUNS);
    expect(said).toBeGreaterThan(0);
    expect(offered).toBeGreaterThan(0);
  });
});
