import { describe, expect, test } from "vitest";
import plate from "../../examples/plate.h?raw";
import { parse } from "../../nc/parse.ts";
import { run } from "../../program/run/run.ts";
import { fitted } from "../camera.ts";
import { labelsOverlap, textBox, type LabelBox } from "../dimensions/labels.ts";
import { planeNames } from "./plane-names.ts";
import { planeScene } from "./plane-scene.ts";

const { approaches, plane } = run(parse(plate), { tools: [], rapid: 10_000 });
const { bounds } = planeScene(plane, [], new Set());
const text = (p: { x: number; y: number }) => `X${p.x.toFixed(3)} Y${p.y.toFixed(3)}`;
const speech = { number: String, point: text, contour: text };

const namesOf = (isNamed: (block: number) => boolean, zoom: number, taken?: readonly LabelBox[]) => {
  const size = { width: 620, height: 480 },
    fit = fitted(bounds, size, { left: 60, right: 20, top: 24, bottom: 40 }, true);
  const shown = approaches.map(({ points, departing, request: { element, toolRadius }, block }) => ({
    points,
    departing,
    toolRadius,
    contact: departing ? element.to : element.from,
    isNamed: isNamed(block),
  }));
  return planeNames(shown, { ...fit, scale: fit.scale * zoom }, size, speech, taken);
};
const blocks = [...new Set(approaches.map(({ block }) => block)), null];

describe.each([0.4, 0.7, 1, 1.3, 2.6])("at zoom %d", (zoom) => {
  test.each(blocks)("names of block %j (null: all) cover neither each other nor a point", (block) => {
    const names = namesOf((each) => block === null || each === block, zoom);
    const boxes = names.map(({ marks }) =>
      marks.flatMap((m) => (m.kind === "text" ? [textBox(m.place, m.text, 0, m.size)] : [])),
    );
    const of = boxes.flatMap((all, i) => all.map((box) => ({ box, i })));
    for (const a of of)
      for (const b of of) if (a.i !== b.i) expect(labelsOverlap(a.box, b.box), `${a.i} ${b.i}`).toBe(false);
    for (const { box } of of)
      for (const { place } of names)
        expect(place.x > box.x && place.x < box.x + box.width && place.y > box.y && place.y < box.y + box.height).toBe(
          false,
        );
  });
});

test("only the chosen approach has names; PA is where the block says, apart from the tool centre", () => {
  const names = namesOf((block) => block === 9, 1);
  const [pa] = names.filter((each) => each.names.includes("PA"));
  expect(pa).toMatchObject({ at: { x: 5, y: 5 }, onContour: true });
  expect(pa?.marks.map((m) => m.kind === "text" && m.text)).toEqual(["PA", "X5.000 Y5.000"]);
  expect(names.find(({ at }) => at.x === -5 && at.y === 5)).toMatchObject({ names: [], marks: [], onContour: false });
  expect(names.flatMap((each) => each.names).sort()).toEqual(["PA", "PH", "PS"]);
});

test("no name touches the tool where it waits", () => {
  const [approach] = approaches;
  const names = namesOf((block) => block === approach?.block, 1);
  const { scale } = fitted(bounds, { width: 620, height: 480 }, { left: 60, right: 20, top: 24, bottom: 40 }, true);
  const { place } = names.find((each) => each.names.includes("PS"))!;
  const r = (approach?.request.toolRadius ?? 0) * scale;
  expect(r).toBeGreaterThan(20);
  const boxes = names.flatMap(({ marks }) =>
    marks.flatMap((m) => (m.kind === "text" ? [textBox(m.place, m.text, 0, m.size)] : [])),
  );
  expect(boxes.length).toBeGreaterThan(0);
  for (const { x, y, width, height } of boxes) {
    const near = Math.hypot(
      place.x - Math.max(x, Math.min(place.x, x + width)),
      place.y - Math.max(y, Math.min(place.y, y + height)),
    );
    expect(near).toBeGreaterThan(r);
  }
});

test("a name gives way to the mark of a finding", () => {
  const boxOf = (names: ReturnType<typeof namesOf>) =>
    names
      .filter((each) => each.names.includes("PA"))
      .flatMap(({ marks }) => marks.flatMap((m) => (m.kind === "text" ? [textBox(m.place, m.text, 0, m.size)] : [])));
  const mark = boxOf(namesOf((block) => block === 9, 1))[0]!;
  const moved = boxOf(namesOf((block) => block === 9, 1, [mark]));
  expect(moved).toHaveLength(2);
  for (const box of moved) expect(labelsOverlap(box, mark)).toBe(false);
});
