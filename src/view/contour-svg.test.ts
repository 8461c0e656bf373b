import { expect, test } from "vitest";
import { at, type Segment } from "../kernel/geometry/point.ts";
import { contourSvg } from "./contour-svg.ts";

const contour: readonly Segment[] = [
  { kind: "line", from: at(1.25, 9.875), to: at(-17.3, 9.875) },
  {
    kind: "arc",
    from: at(-17.3, 9.875),
    to: at(-20.8, 13.375),
    centre: at(-17.3, 13.375),
    turn: "cw",
  },
  { kind: "line", from: at(-20.8, 13.375), to: at(-31.25, 13.375) },
];

test("a contour is drawn in its true size, arcs as arcs, with room round it", () => {
  expect(contourSvg([{ name: "CONTOUR", segments: contour }])).toBe(
    `<svg xmlns="http://www.w3.org/2000/svg" width="42.5mm" height="13.5mm" viewBox="-36.25 -18.375 42.5 13.5">
 <g transform="scale(1 -1)" fill="none" stroke="#000000" stroke-width="0.25" stroke-linejoin="round">
  <path id="CONTOUR" d="M1.25 9.875L-17.3 9.875A3.5 3.5 0 0 0 -20.8 13.375L-31.25 13.375"/>
 </g>
</svg>
`,
  );
});

test("an arc that bulges beyond its ends is inside the drawing; no contour gives no drawing", () => {
  const bow: Segment = { kind: "arc", from: at(0, 10), to: at(-20, 10), centre: at(-10, 10), turn: "ccw" };
  expect(contourSvg([{ name: "A", segments: [bow] }])).toContain('viewBox="-25 -25 30 20"');
  expect(contourSvg([])).toBe(null);
});
