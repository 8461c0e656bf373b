import { beforeEach, describe, expect, test } from "vitest";
import { cuttingCycles } from "../../../cycles/index.ts";
import { measure as texts } from "../../../i18n/en/measure.ts";
import { at, type Pt, type Segment } from "../../../kernel/geometry/point.ts";
import { exampleJob } from "../../../program/job/job.ts";
import { toScreen } from "../../../view/camera.ts";
import { measuredFigure } from "../../../view/measure/figure.ts";
import { measuredIn } from "../../document/edits.ts";
import { createViewport } from "../lathe/viewport.ts";
import { openFirstWork, useEditor } from "../../document/store.ts";
import { measureHand } from "./hand.ts";
import { createMeasuring } from "./measuring.ts";
import type { MeasureSource } from "./source.ts";

const line = (from: Pt, to: Pt): Segment => ({ kind: "line", from, to });
/** A chamfer, a cylinder, a fillet, a face and a cone. */
const shaft: readonly Segment[] = [
  line(at(0, 7.35), at(-1.15, 8.5)),
  line(at(-1.15, 8.5), at(-13.27, 8.5)),
  { kind: "arc", from: at(-13.27, 8.5), to: at(-14.87, 10.1), centre: at(-13.27, 10.1), turn: "cw" },
  line(at(-14.87, 10.1), at(-14.87, 21.0175)),
  line(at(-14.87, 21.0175), at(-41.3, 23.33)),
];
const sourceOf = (contour: readonly Segment[]): MeasureSource => ({
  plane: "ZX",
  contours: [contour],
  blank: [],
  path: () => [],
  moment: () => null,
  stock: () => [],
  fingerprintOf: () => "",
});

function measuringShaft({ served = true } = {}) {
  const measuring = createMeasuring(),
    viewport = createViewport(true);
  viewport.setSize({ width: 613, height: 407 });
  viewport.setBounds({ left: -43, right: 3, low: -25, high: 25 });
  let source = sourceOf(shaft);
  const serve = () => measuring.serve(measureHand(measuring, { viewport, source: () => source, texts: () => texts }));
  if (served) serve();
  measuring.toggle();
  return {
    measuring,
    serve,
    press: (...keys: readonly string[]) => keys.map((key) => measuring.key(key)),
    over: (p: Pt) => measuring.hover(toScreen(viewport.get(), p)),
    tap: (p: Pt) => measuring.tap(toScreen(viewport.get(), p)),
    redraw: (contour: readonly Segment[]) => void (source = sourceOf(contour)),
    cross: () => measuring.state.getState().cross?.at,
  };
}
const measured = () =>
  measuredIn(useEditor.getState()).map(
    ({ kind, places }) => `${kind} ${measuredFigure(kind, places, true)?.value.toFixed(3) ?? "none"}`,
  );

const [cycle] = cuttingCycles;
if (!cycle) throw new Error("the catalogue is empty");
beforeEach(() => openFirstWork(exampleJob(cycle), "work"));

test("inputs faster than the screen: nothing is drawn between tool, edges and pick", () => {
  const { press } = measuringShaft();
  // Corner, middle of the chamfer, corner, middle of the cylinder; the arc; the cone.
  expect(press("d", "n", "n", "Enter", "n", "n", "Enter", "r", "n", "Enter", "a", "p", "Enter", "Enter")).not.toContain(
    false,
  );
  expect(measured()).toEqual(["diameter 15.850", "diameter 17.000", "radius 1.600", "angle 5.000"]);
});

test("keys pressed before the tools are loaded run afterwards, in order; Escape leaves, and drops them", () => {
  const first = measuringShaft({ served: false });
  expect(first.press("d", "n", "n", "n", "n", "Enter", "+", "Home")).toEqual([
    true,
    true,
    true,
    true,
    true,
    true,
    false,
    false,
  ]);
  expect(measured()).toEqual([]);
  first.serve();
  expect(measured()).toEqual(["diameter 17.000"]);

  const second = measuringShaft({ served: false });
  second.press("r", "n", "Enter", "Escape");
  expect(second.measuring.state.getState().on).toBe(false);
  second.serve();
  second.measuring.toggle();
  expect(measured()).toEqual(["diameter 17.000"]);
});

test("a tap and a drag before the tools are loaded run afterwards", () => {
  const { measuring, serve, tap } = measuringShaft({ served: false });
  measuring.choose("diameter");
  tap(at(-7.3, 8.52));
  measuring.drag({ x: 3, y: 4 }, { x: 5, y: 6 }, false);
  serve();
  expect(measured()).toEqual(["diameter 17.000"]);
});

describe("the first key", () => {
  test.each([
    ["n", at(0, 7.35)],
    ["p", at(-41.3, 23.33)],
  ])("%s goes to an end of the edges, whatever is in the centre of the picture", (key, end) => {
    const { measuring, press, cross } = measuringShaft();
    measuring.choose("diameter");
    press(key);
    expect(cross()).toEqual(end);
  });

  test("Enter with an empty centre shows the cross on an edge of its kind; Enter again picks it", () => {
    const { measuring, press } = measuringShaft();
    measuring.choose("angle");
    press("Enter");
    expect(measured()).toEqual([]);
    press("Enter", "Enter");
    expect(measured()).toHaveLength(1);
  });

  test("Enter shows the cross and measures nothing invisible", () => {
    const { press, cross } = measuringShaft();
    press("Enter");
    expect(cross()).toBeDefined();
    expect(measured()).toEqual([]);
  });
});

describe("a mouse over the picture", () => {
  test("that does not move, or trembles, leaves the cross to the keys", () => {
    const { measuring, press, over, cross } = measuringShaft();
    measuring.choose("diameter");
    over(at(-30.1, 22.3));
    press("n");
    expect(cross()).toEqual(at(0, 7.35));
    over(at(-30.1, 22.3));
    over(at(-30.2, 22.3));
    press("n", "n");
    over(at(-30.1, 22.25));
    expect(cross()).toEqual(at(-1.15, 8.5));
  });

  test("that sent no event before the keys has to move as well", () => {
    const { measuring, press, over, cross } = measuringShaft();
    measuring.choose("diameter");
    press("n");
    over(at(-30.1, 22.3));
    expect(cross()).toEqual(at(0, 7.35));
    over(at(-7.3, 8.52));
    expect(cross()?.r).toBe(8.5);
  });

  test("that clicks takes the cross back", () => {
    const { measuring, press, over, tap, cross } = measuringShaft();
    measuring.choose("diameter");
    press("n");
    tap(at(-7.3, 8.52));
    over(at(-7.4, 8.52));
    expect(cross()?.z).toBeCloseTo(-7.4, 6);
  });
});

test("another tool drops the first place, the same one keeps it; off and on starts over", () => {
  const { measuring, press } = measuringShaft();
  press("l", "n", "Enter", "l");
  expect(measuring.state.getState().first?.at).toEqual(at(0, 7.35));
  press("s");
  expect(measuring.state.getState()).toMatchObject({ kind: "depth", first: null, cross: { at: at(0, 7.35) } });
  measuring.toggle();
  measuring.toggle();
  expect(measuring.state.getState()).toMatchObject({ kind: "depth", cross: null });
});

test("keys walk the present drawing, also when the contour changes between two of them", () => {
  const { press, cross, redraw } = measuringShaft();
  press("d", "n", "n", "n");
  redraw(shaft.slice(1));
  expect(cross()).toEqual(at(-1.15, 8.5));
  press("p");
  expect(cross()).toEqual(at(-41.3, 23.33));
});

test("a repeated measurement is listed once, and a caliper in the air says that there is nothing", () => {
  const { measuring, press, tap } = measuringShaft();
  press("d");
  tap(at(-7.3, 8.5));
  tap(at(-30.1, 15.3));
  expect(measuring.state.getState()).toMatchObject({ said: texts.none.surface, done: null });
  const [one] = measuredIn(useEditor.getState());
  tap(one?.places[0]?.at ?? at(0, 0));
  tap(one?.places[0]?.at ?? at(0, 0));
  expect(measured()).toEqual(["diameter 17.000"]);
  expect(measuring.state.getState().done?.places).toBe(one?.places);
});
