import { expect, test } from "vitest";
import { fetchTexts, texts } from "../../app/base/settings/loaded-texts.ts";
import { readRows } from "../../program/job/contour-rows.ts";
import { newRow } from "../../program/job/job.ts";
import { placedDimensions } from "../../view/dimensions/placed-dimensions.ts";
import { contourDrawing } from "../../view/help/contour-drawing.ts";
import { labelsOverlap, type LabelBox } from "../../view/dimensions/labels.ts";
import { drawnDimensions } from "./drawing-dimensions.ts";
import { holdSigns } from "./hold-signs.ts";

const rows = [
  newRow("e1", { x: "28", z: "0" }),
  newRow("e2", { x: "30", z: "-1" }),
  newRow("e3", { z: "-20" }),
  newRow("e4", { x: "24", z: "-28" }),
  newRow("e5", { z: "-38" }),
  newRow("e6", { kind: "RND", r: "2" }),
  newRow("e7", { x: "42", z: "-44" }),
  newRow("e8", { z: "-55" }),
  newRow("e9", { kind: "RND", r: "1.5" }),
  newRow("e10", { x: "60" }),
];
const reading = readRows(rows);

test.each([
  [480, 300],
  [650, 760],
  [980, 640],
  [1650, 900],
])("on a drawing of %d × %d no text, sign or number covers another or a point", async (width, height) => {
  await fetchTexts("en");
  const size = { width, height };
  const picture = contourDrawing({
    contour: reading.contour.segments,
    rowOfSegment: reading.rowOfSegment,
    ends: reading.rows.map((r) => r.end),
    faulty: new Set(),
    active: null,
    size,
    margin: { left: 66, right: 100, top: 34, bottom: 78 },
  });
  const signs = holdSigns(rows, reading, picture, null);
  const kept = [...picture.kept, ...signs.map(({ box }) => box)];
  const dimensions = placedDimensions(
    {
      camera: picture.camera,
      size,
      unit: 1,
      room: { x: 48, y: 2, width: width - 50, height: height - 26 },
      target: { width: 40, height: 22 },
      kept,
      free: { x: width - 60, y: height - 80 },
      avoid: picture.avoid,
    },
    drawnDimensions({ rows, reading, chosen: null, language: "en", texts: texts("en").contour }),
  );
  expect(signs.length).toBeGreaterThan(1);
  expect(dimensions.length).toBeGreaterThan(5);
  // The middle of a rounding may lie at the point before it.
  const numbers: readonly LabelBox[] = picture.kept.slice(rows.length),
    marks = [...numbers, ...signs.map(({ box }) => box), ...dimensions.map(({ box }) => box)];
  marks.forEach((box, i) => {
    for (const other of [...picture.kept.slice(0, rows.length), ...marks.slice(0, i)])
      expect(labelsOverlap(box, other), JSON.stringify([box, other])).toBe(false);
  });
});
