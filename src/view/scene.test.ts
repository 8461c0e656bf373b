import { expect, test } from "vitest";
import type { Move } from "../kernel/plan/move.ts";
import type { Pt, Ring, Segment } from "../kernel/geometry/point.ts";
import type { Step } from "../kernel/time/step.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import { axial, degrees, feed, length, radius } from "../kernel/units.ts";
import { fitted } from "./camera.ts";
import { segmentData } from "./path.ts";
import { trackOf } from "./playback.ts";
import { pathRole, sceneOf, toolpath } from "./scene.ts";
import { svgText } from "./svg.ts";
import { timeBar } from "./timeline.ts";
import { tipAt } from "./tip.ts";

const at = (r: number, z: number): Pt => ({ z: axial(z), r: radius(r) });
const tool: Tool = {
  T: 1,
  NAME: "CNMG",
  TYPE: "ROUGH",
  TO: 1,
  RS: length(0.8),
  "T-ANGLE": degrees(95),
  "P-ANGLE": degrees(80),
  CUTLENGTH: length(12),
};
const cut = { feed: feed(0.3), feedUnit: "mm/rev" } as const;
const rough = { phase: "rough", run: "rough", pass: 1 } as const,
  finish = { phase: "finish", run: "finish" } as const;

/** One pass and a finishing cut round a rounded corner, with a falling element in it. */
const moves: readonly Move[] = [
  { kind: "rapid", to: at(22.37, 2), ...rough, step: 1 },
  {
    kind: "feed",
    to: at(22.37, -29.8),
    ...cut,
    ...rough,
    step: 2,
  },
  { kind: "feed", to: at(25.1, -29.8), ...cut, ...rough, step: 3 },
  { kind: "rapid", to: at(25.1, 2), ...rough, step: 5 },
  {
    kind: "rapid",
    to: at(20.13, 2),
    ...finish,
    step: 1,
  },
  { kind: "feed", to: at(20.13, -27.5), ...cut, ...finish, step: 2 },
  {
    kind: "arc",
    to: at(22.63, -30),
    centre: at(22.63, -27.5),
    turn: "cw",
    ...cut,
    ...finish,
    step: 2,
  },
  { kind: "feed", to: at(22.11, -31.7), ...cut, ...finish, step: 2, plunging: true },
  {
    kind: "feed",
    to: at(26, -31.7),
    ...cut,
    ...finish,
    step: 2,
  },
];
const steps: Step[] = [];
moves.forEach((move, i) =>
  steps.push({ from: moves[i - 1]?.to ?? at(26, 2), move, tool, block: 9, operation: 0, seconds: i + 1 }),
);
const blank: Ring[] = [[at(0, -60), at(0, 1), at(25.5, 1), at(25.5, -60)]];
const contour: Segment[] = [
  { kind: "line", from: at(20.13, 0), to: at(20.13, -27.5) },
  {
    kind: "arc",
    from: at(20.13, -27.5),
    to: at(22.63, -30),
    centre: at(22.63, -27.5),
    turn: "cw",
  },
  { kind: "line", from: at(22.63, -30), to: at(25.5, -30) },
];

test("the display list of a small program, X up", async () => {
  const scene = sceneOf({ blank, contours: [contour], steps }),
    size = { width: 800, height: 500 };
  const picture = svgText(
    scene.shapes,
    fitted(scene.bounds, size, { left: 40, right: 20, top: 20, bottom: 40 }, true),
    size,
  );
  await expect(picture).toMatchFileSnapshot("./goldens/small-program.svg");
});

test("thousands of moves are one path per form", () => {
  const many = Array.from({ length: 1000 }, () => steps).flat();
  expect(toolpath(many).map((shape) => shape.role)).toEqual(["rapid", "feed", "plunge", "finish"]);
});

test("every move is drawn once: as many strokes as moves", () => {
  const strokes = toolpath(steps).map((shape) => (shape.d.match(/[LA]/g) ?? []).length);
  expect(strokes.reduce((sum, n) => sum + n, 0)).toBe(steps.length);
});

test("plunging takes precedence over the phase, a rapid over everything", () => {
  expect(steps.map((s) => pathRole(s.move))).toEqual([
    "rapid",
    "feed",
    "feed",
    "rapid",
    "rapid",
    "finish",
    "finish",
    "plunge",
    "finish",
  ]);
});

test("arcs stay arcs, with their turn; a full circle is two halves", () => {
  const arc = (turn: "cw" | "ccw", to: Pt): Segment => ({ kind: "arc", from: at(0, 10), to, centre: at(0, 0), turn });
  expect(segmentData([arc("ccw", at(10, 0))])).toBe("M10 0A10 10 0 0 1 0 10");
  expect(segmentData([arc("cw", at(10, 0))])).toBe("M10 0A10 10 0 1 0 0 10");
  expect(segmentData([arc("ccw", at(0, 10))])).toBe("M10 0A10 10 0 0 1 -10 0A10 10 0 0 1 10 0");
});

test("the tip runs on its line and on its arc", () => {
  expect(tipAt(steps, { step: 1, fraction: 0.5 })).toEqual(at(22.37, -13.9));
  const onArc = tipAt(steps, { step: 6, fraction: 0.3 });
  expect(onArc && Math.hypot(onArc.z + 27.5, onArc.r - 22.63)).toBeCloseTo(2.5, 9);
  expect(tipAt(steps, { step: steps.length, fraction: 0 })).toEqual(at(26, -31.7));
  expect(tipAt([], { step: 0, fraction: 0 })).toBe(null);
});

test("the bar of a run covers its whole time once", () => {
  const bar = timeBar(steps, trackOf(steps));
  expect(bar.operations).toEqual([{ operation: 0, from: 0, to: 1 }]);
  const covered = [bar.cutting, bar.rapid]
    .flatMap((d) => [...d.matchAll(/M([\d.]+) 0H([\d.]+)/g)])
    .reduce((sum, [, from, to]) => sum + Number(to) - Number(from), 0);
  expect(covered).toBeCloseTo(1, 3);
});

test("an empty picture still has bounds", () => {
  expect(sceneOf({ blank: [], contours: [], steps: [] }).shapes).toEqual([]);
});
