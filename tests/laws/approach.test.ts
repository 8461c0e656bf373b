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
type Done = ReturnType<typeof runs>;
const moved = (done: Done) => done.plane.filter((s) => s.centre || apart(s.from, s.to) > 1e-6);

/** The path has no gap in the plane and in the axis, and no number is NaN. */
function isContinuous({ plane: steps }: Done): void {
  const wrong: string[] = [];
  JSON.stringify(steps, (key, v: unknown) => {
    if (typeof v === "number" && !Number.isFinite(v)) wrong.push(`${key} ${v}`);
    return v;
  });
  steps.forEach((step, i) => {
    const before = steps[i - 1]?.to ?? step.from;
    const gap = apart(before, step.from);
    if (gap >= 1e-9 || step.from.z !== before.z) wrong.push(`step ${i} begins ${gap} off, at Z${step.from.z}`);
    const radii = step.centre ? [apart(step.from, step.centre), apart(step.to, step.centre)] : [0, 0];
    if (Math.abs((radii[0] as number) - (radii[1] as number)) >= 1e-8) wrong.push(`arc ${i} has radii ${radii.join()}`);
  });
  expect(wrong).toEqual([]);
}

/** The tool comes from PS over PH exactly to PA, and leaves from PE exactly to PN. */
function goesOverItsPoints(done: Done): void {
  const visits = done.plane.flatMap((step) => [step.from, step.to]);
  for (const a of done.approaches)
    for (const p of Object.values(a.points)) expect(Math.min(...visits.map((v) => apart(v, p)))).toBeLessThan(1e-9);
  if (done.approaches.length < 2) return;
  const end = done.approaches[1]?.points.PN;
  if (end) expect(apart(done.plane.at(-1)?.to ?? end, end)).toBeLessThan(1e-9);
}

/** Without issues the path onto and off the contour is smooth, or square for LN. Returns the forms that were judged. */
function isSmooth(done: Done): readonly string[] {
  if (done.issues.some((f) => f.issue.severity === "error" && f.issue.code !== "missing")) return [];
  const steps = moved(done);
  return done.approaches.flatMap((a) => {
    const p = a.departing ? a.points.PE : a.points.PA;
    if (!p || a.tip.x !== 0) return [];
    const i = a.departing
      ? steps.findLastIndex((step) => apart(step.from, p) < 1e-9)
      : steps.findIndex((step) => apart(step.to, p) < 1e-9);
    const [one, two] = a.departing ? [steps[i - 1], steps[i]] : [steps[i], steps[i + 1]];
    if (!one || !two || apart(one.to, p) > 1e-9) return [];
    const [before, after] = [direction(pathOf(one), p), direction(pathOf(two), p)];
    const cosine = before.x * after.x + before.y * after.y;
    if (Math.min(apart(one.from, one.to), apart(two.from, two.to)) < 0.05 || two.block === one.block) return [];
    expect(Math.abs(a.shape === "LN" ? cosine : cosine - 1)).toBeLessThan(1e-9);
    return [a.shape];
  });
}

const mirrored = (p: PlanePoint) => ({ x: p.x, y: -p.y });

/** RL in the mirror is RR. */
function isMirrored(s: Situation, done: Done): void {
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
  expect(image.plane.length).toBe(done.plane.length);
  const apartFrom = image.plane.map((step, i) => apart(mirrored(step.to), done.plane[i]?.to ?? step.to));
  expect(Math.max(0, ...apartFrom)).toBeLessThan(1e-6);
  expect(image.issues.map((f) => f.issue.code)).toEqual(done.issues.map((f) => f.issue.code));
}

describe("programs with every approach and departure", () => {
  test("the path has no gap, goes over its points, touches the contour smoothly, and is mirrored with its side", () => {
    const judged: string[] = [];
    fc.assert(
      fc.property(situation, (s) => {
        const done = runs(s);
        isContinuous(done);
        goesOverItsPoints(done);
        judged.push(...isSmooth(done));
        isMirrored(s, done);
      }),
      { numRuns: 600 },
    );
    expect(judged.length).toBeGreaterThan(200);
    expect(judged.filter((shape) => shape === "LN").length).toBeGreaterThan(20);
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
