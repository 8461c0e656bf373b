import { describe, expect, test } from "vitest";
import type { Plan, ThreadPlan } from "../kernel/plan/plan.ts";
import { at, type Pt, type Ring } from "../kernel/geometry/point.ts";
import { length } from "../kernel/units.ts";
import { crestMissing } from "./crest.ts";
import { stockIssues } from "./issues.ts";
import type { OperationProof, StockFinding, ThreadWay } from "./simulation.ts";

const DEPTH = 1.2;
/** A thread of pitch 2 along these points. */
function planOf(crest: readonly Pt[], openSide: Pt): Plan {
  const thread: ThreadPlan = {
    pitch: length(2),
    lead: length(2),
    starts: 1,
    depths: [0.6, DEPTH].map(length),
    slope: 0,
    out: openSide,
    above: [],
    crest,
    end: at(-26, 20),
    runIn: length(5),
    side: [],
  };
  const none = { moves: [], issues: [], contour: [], area: [], part: [], reach: [], oversizeReach: [] };
  return { ...none, passes: 2, infeed: length(0.6), maxInfeed: length(0.6), openSide, thread };
}
const outside = planOf([at(0, 20), at(-24, 20)], at(0, 1));
const inside = planOf([at(0, 20), at(-24, 20)], at(0, -1));
const shaft = (r: number, ...more: readonly Pt[]): Ring => [at(-60, 0), at(0, 0), at(0, r), ...more, at(-60, r)];

describe("a crest is missing", () => {
  test("where the shaft is thinner than the thread by more than a tenth of its depth", () => {
    expect(crestMissing(outside, [shaft(20)])).toBeNull();
    expect(crestMissing(outside, [shaft(19.89)])).toBeNull();
    expect(crestMissing(outside, [shaft(19.87)])).toMatchObject({
      missing: expect.closeTo(0.13, 9),
      r: 20,
      inFace: false,
    });
    // Thinner than the root: nothing will be cut, and the finding is the same.
    expect(crestMissing(outside, [shaft(15)])).toMatchObject({ missing: expect.closeTo(5, 9), r: 20 });
    expect(crestMissing(outside, [])).toBeNull();
  });

  test("where the bore is wider", () => {
    const bored = (r: number): Ring => [at(-60, r), at(0, r), at(0, 30), at(-60, 30)];
    expect(crestMissing(inside, [bored(20)])).toBeNull();
    expect(crestMissing(inside, [bored(20.11)])).toBeNull();
    expect(crestMissing(inside, [bored(20.6)])).toMatchObject({ missing: expect.closeTo(0.6, 9), r: 20 });
  });

  test("not at a chamfer or a relief, but over more than half of the thread", () => {
    const chamfered: Ring = [
      at(-60, 0),
      at(0, 0),
      at(0, 18),
      at(-2, 20),
      at(-18, 20),
      at(-18, 18),
      at(-25, 18),
      at(-25, 20),
      at(-60, 20),
    ];
    expect(crestMissing(outside, [chamfered])).toBeNull();
    const stepped = (z: number): Ring => [at(-60, 0), at(0, 0), at(0, 19), at(z, 19), at(z, 20), at(-60, 20)];
    expect(crestMissing(outside, [stepped(-10)])).toBeNull();
    expect(crestMissing(outside, [stepped(-15)])).toMatchObject({ missing: expect.closeTo(1, 9) });
  });

  test("not where its grooves exist already: the material between them counts", () => {
    const grooves = (r: number): Pt[] =>
      Array.from({ length: 12 }, (_, k) => [
        at(-2 * k - 0.1, r),
        at(-2 * k - 1, r - DEPTH),
        at(-2 * k - 1.9, r),
      ]).flat();
    expect(crestMissing(outside, [shaft(20, ...grooves(20))])).toBeNull();
    expect(crestMissing(outside, [shaft(19.5, ...grooves(19.5))])).toMatchObject({ missing: expect.closeTo(0.5, 9) });
  });

  test("on tapers and faces as well, in either direction", () => {
    const cone = planOf([at(-24, 21.2), at(0, 20)], at(0, 1));
    const turnedTo = (less: number): Ring => [
      at(-60, 0),
      at(0, 0),
      at(0, 20 - less),
      at(-24, 21.2 - less),
      at(-60, 21.2 - less),
    ];
    expect(crestMissing(cone, [turnedTo(0)])).toBeNull();
    const { missing, r } = crestMissing(cone, [turnedTo(0.6)]) ?? {};
    // Within one pitch, the higher side counts.
    expect(missing).toBeGreaterThan(0.53);
    expect(r).toBeGreaterThan(20.3);
    expect(r).toBeLessThan(20.9);
    const face = planOf([at(0, 40), at(0, 20)], at(1, 0));
    const faced = (z: number): Ring => [at(-60, 0), at(z, 0), at(z, 45), at(-60, 45)];
    expect(crestMissing(face, [faced(0)])).toBeNull();
    expect(crestMissing(face, [faced(-0.3)])).toMatchObject({ missing: expect.closeTo(0.3, 9), inFace: true, z: 0 });
  });
});

describe("damage behind the end of a thread", () => {
  const none: OperationProof = {
    cut: 5,
    airPasses: 0,
    crest: null,
    thread: null,
    deepest: null,
    thickest: null,
    behindLimits: [],
    startInMaterial: null,
    hasFailed: false,
    isQuestioned: false,
  };
  function told(place: Pt, thread: ThreadWay | null) {
    const finding: StockFinding = {
      kind: "gouge",
      step: 3,
      block: 18,
      operation: 0,
      place,
      area: 1.5,
      rings: [],
      moves: 2,
    };
    const proof = {
      operations: [{ ...none, thread }],
      residual: [],
      stated: [],
      uncheckedFrom: null,
      remarks: [],
      loose: [],
      unheld: null,
    };
    return stockIssues({ findings: [finding], proof } as unknown as Parameters<typeof stockIssues>[0])[0]?.issue;
  }
  const way: ThreadWay = { crest: outside.thread?.crest ?? [], stop: at(-26, 18.8), openSide: at(0, 1) };

  test("gives the overrun of the thread, and whether a flank hit a shoulder", () => {
    expect(told(at(-25.5, 19.2), way)).toMatchObject({
      code: "threadOverruns",
      severity: "error",
      data: { meets: "shaft", axis: "Z", end: -24, to: -26, x: 38.4, z: -25.5 },
    });
    expect(told(at(-27.5, 21), way)).toMatchObject({ code: "threadOverruns", data: { meets: "shoulder" } });
  });

  test("is plain contour damage elsewhere, or where no thread was cut", () => {
    expect(told(at(-23.9, 19.2), way)).toMatchObject({ code: "gouge" });
    expect(told(at(3, 19.2), way)).toMatchObject({ code: "gouge" });
    expect(told(at(-25.5, 19.2), null)).toMatchObject({ code: "gouge" });
  });

  test("is reported along X on a face, with diameters", () => {
    const inFace: ThreadWay = { crest: [at(0, 40), at(0, 20)], stop: at(-1.2, 18), openSide: at(1, 0) };
    expect(told(at(-0.8, 18.5), inFace)).toMatchObject({ data: { meets: "shaft", axis: "X", end: 40, to: 36 } });
    expect(told(at(0.8, 17.5), inFace)).toMatchObject({ data: { meets: "shoulder" } });
    expect(told(at(-0.8, 41), inFace)).toMatchObject({ code: "gouge" });
  });
});
