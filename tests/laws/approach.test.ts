import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { plane, type PlanePoint, type PlaneSegment } from "../../src/kernel/plane/plane.ts";
import { parse } from "../../src/nc/parse.ts";
import type { PlaneStep } from "../../src/program/tools/plane-types.ts";
import { run } from "../../src/program/run/run.ts";

const { apart, direction } = plane;

/*
 * Laws over whole programs: random contours in all quadrants, every form of APPR and DEP, both sides, read from text as
 * on a control.
 */
const word = (axis: string, value: number) => `${axis}${value < 0 ? "" : "+"}${Math.round(value * 1000) / 1000}`;
const at = (p: PlanePoint) => `${word("X", p.x)} ${word("Y", p.y)}`;
const coordinate = fc.integer({ min: -120, max: 120 });
const point = fc.record({ x: coordinate, y: coordinate });
const APPROACHES = ["LT", "LN", "CT", "LCT", "PLT", "PLN", "PCT", "PLCT"] as const;
const DEPARTURES = ["LT", "LN", "CT", "LCT", "PLCT"] as const;

const situation = fc.record({
  form: fc.constantFrom(...APPROACHES),
  end: fc.constantFrom(...DEPARTURES),
  side: fc.constantFrom("RL", "RR"),
  pole: point,
  far: fc.integer({ min: 5, max: 80 }),
  angle: fc.integer({ min: -180, max: 180 }),
  start: point,
  finish: point,
  corners: fc.array(point, { minLength: 1, maxLength: 5 }),
  kinds: fc.array(fc.constantFrom("L", "L", "CR+", "CR-"), { minLength: 5, maxLength: 5 }),
  rounding: fc.constantFrom(0, 0, 2),
  length: fc.integer({ min: 1, max: 40 }),
  radius: fc.integer({ min: 1, max: 30 }),
  sweep: fc.integer({ min: 5, max: 360 }),
  tool: fc.constantFrom(0, 3, 8.5),
  depth: fc.boolean(),
  control: fc.constantFrom("TNC 640" as const, "TNC7" as const),
});
type Situation = typeof situation extends fc.Arbitrary<infer T> ? T : never;

const sizes = (form: string, s: Situation) =>
  form.endsWith("LCT")
    ? `R${s.radius}`
    : form.endsWith("CT")
      ? `CCA${s.sweep} ${word("R", s.radius)}`
      : `LEN${s.length}`;

function text(s: Situation): string {
  const first = s.form.startsWith("P") ? `${word("PR", s.far)} ${word("PA", s.angle)}` : at(s.corners[0] ?? s.start);
  const path = s.corners.map((p, i) => {
    const kind = s.kinds[i] ?? "L";
    return kind === "L" ? `L ${at(p)}` : `CR ${at(p)} R+300 DR${kind.slice(2)}`;
  });
  const last = s.end === "LCT" ? at(s.finish) : s.end === "PLCT" ? `${word("PR", s.far)} ${word("PA", s.angle)}` : "";
  return [
    "BEGIN PGM LAW MM",
    `TOOL DEF 1 L+0 R${word("", s.tool)}`,
    "TOOL CALL 1 Z S4000",
    "L Z+50 R0 FMAX",
    `L ${at(s.start)} R0 F900`,
    `CC ${at(s.pole)}`,
    `APPR ${s.form} ${first}${s.depth ? " Z-5" : ""} ${sizes(s.form, s)} ${s.side} F200`,
    ...path.flatMap((p, i) => (s.rounding > 0 && i === 1 && path.length > 2 ? [p, `RND R${s.rounding}`] : [p])),
    `DEP ${s.end} ${last}${s.depth ? " Z+50" : ""} ${sizes(s.end, s)} F300`,
    "L Z+60 R0 FMAX M2",
    "END PGM LAW MM",
  ].join("\n");
}

const pathOf = (s: PlaneStep): PlaneSegment =>
  s.centre && s.turn
    ? { kind: "arc", from: s.from, to: s.to, centre: s.centre, turn: s.turn }
    : { kind: "line", from: s.from, to: s.to };
const runs = (s: Situation) => run(parse(text(s)), { tools: [], rapid: 10_000, control: s.control });
const moved = (done: ReturnType<typeof runs>) => done.plane.filter((s) => s.centre || apart(s.from, s.to) > 1e-6);
const RUNS = { numRuns: 600 };

describe("programs with every approach and departure", () => {
  test("the path is continuous in the plane and in the axis, and no number is NaN", () => {
    fc.assert(
      fc.property(situation, (s) => {
        const done = runs(s);
        JSON.stringify(done.plane, (_, v: unknown) => {
          if (typeof v === "number") expect(Number.isFinite(v)).toBe(true);
          return v;
        });
        done.plane.slice(1).forEach((step, i) => {
          const before = done.plane[i]?.to ?? step.from;
          expect(apart(before, step.from)).toBeLessThan(1e-9);
          expect(step.from.z).toBe(before.z);
        });
        for (const step of done.plane)
          if (step.centre)
            expect(Math.abs(apart(step.from, step.centre) - apart(step.to, step.centre))).toBeLessThan(1e-8);
      }),
      RUNS,
    );
  });

  test("the tool comes from PS over PH exactly to PA, and leaves from PE exactly to PN", () => {
    fc.assert(
      fc.property(situation, (s) => {
        const done = runs(s);
        const visits = done.plane.flatMap((step) => [step.from, step.to]);
        for (const a of done.approaches)
          for (const p of Object.values(a.points))
            expect(Math.min(...visits.map((v) => apart(v, p)))).toBeLessThan(1e-9);
        if (done.approaches.length < 2) return;
        const end = done.approaches[1]?.points.PN;
        if (end) expect(apart(done.plane.at(-1)?.to ?? end, end)).toBeLessThan(1e-9);
      }),
      RUNS,
    );
  });

  test("without issues the path onto and off the contour is smooth, or square for LN", () => {
    let [seen, square] = [0, 0];
    fc.assert(
      fc.property(situation, (s) => {
        const done = runs(s);
        if (done.issues.some((f) => f.issue.severity === "error" && f.issue.code !== "missing")) return;
        const steps = moved(done);
        for (const a of done.approaches) {
          const p = a.departing ? a.points.PE : a.points.PA;
          if (!p || a.tip.x !== 0) continue;
          const i = a.departing
            ? steps.findLastIndex((step) => apart(step.from, p) < 1e-9)
            : steps.findIndex((step) => apart(step.to, p) < 1e-9);
          const [one, two] = a.departing ? [steps[i - 1], steps[i]] : [steps[i], steps[i + 1]];
          if (!one || !two || apart(one.to, p) > 1e-9) continue;
          const [before, after] = [direction(pathOf(one), p), direction(pathOf(two), p)];
          const cosine = before.x * after.x + before.y * after.y;
          if (Math.min(apart(one.from, one.to), apart(two.from, two.to)) < 0.05 || two.block === one.block) continue;
          seen += 1;
          if (a.shape !== "LN") expect(Math.abs(cosine - 1)).toBeLessThan(1e-9);
          else {
            square += 1;
            expect(Math.abs(cosine)).toBeLessThan(1e-9);
          }
        }
      }),
      RUNS,
    );
    expect(seen).toBeGreaterThan(200);
    expect(square).toBeGreaterThan(20);
  });

  test("RL in the mirror is RR", () => {
    const mirrored = (p: PlanePoint) => ({ x: p.x, y: -p.y });
    fc.assert(
      fc.property(situation, (s) => {
        const image = runs({
          ...s,
          side: s.side === "RL" ? "RR" : "RL",
          pole: mirrored(s.pole),
          angle: -s.angle,
          start: mirrored(s.start),
          finish: mirrored(s.finish),
          corners: s.corners.map(mirrored),
          kinds: s.kinds.map((k) => (k === "CR+" ? "CR-" : k === "CR-" ? "CR+" : k)),
        });
        const done = runs(s);
        expect(image.plane.length).toBe(done.plane.length);
        image.plane.forEach((step, i) =>
          expect(apart(mirrored(step.to), done.plane[i]?.to ?? step.to)).toBeLessThan(1e-6),
        );
        expect(image.issues.map((f) => f.issue.code)).toEqual(done.issues.map((f) => f.issue.code));
      }),
      RUNS,
    );
  });

  test("a proposed start point, LEN or R makes the path free", () => {
    let free = 0;
    fc.assert(
      fc.property(situation, (s) => {
        const done = runs({ ...s, tool: 8.5, end: "LT" });
        const a = done.approaches[0];
        if (!a?.free || a.departing) return;
        free += 1;
        const { free: way } = a;
        const again = runs(
          way.kind === "point"
            ? { ...s, tool: 8.5, end: "LT", start: way.point }
            : { ...s, tool: 8.5, end: "LT", [way.word === "LEN" ? "length" : "radius"]: way.value },
        );
        expect(again.approaches[0]?.cut ?? null).toBeNull();
      }),
      { numRuns: 250 },
    );
    expect(free).toBeGreaterThan(5);
  });
});
