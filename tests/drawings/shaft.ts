import { arc, asText, dxfGroups, line, MM, utf8, type Entity, type Parts } from "./dxf-file.ts";

/** A shaft with a cove: ⌀24 to Z-18, radius 4, ⌀54 to Z-46. */
export const REFERENCE = "X24 Z0 | Z-18 | CR X32 Z-22 R4 cw | X54 | Z-46";
/** The same in one half of a side view, which begins on the axis. */
export const FACED = `X0 Z0 | ${REFERENCE.replace(" Z0", "")}`;

export const profile = (more?: string): Entity[] => [
  line(0, 12, -18, 12, more),
  arc(-18, 16, 4, 180, 270, more),
  line(-22, 16, -22, 27, more),
  line(-22, 27, -46, 27, more),
];
export const QUARTER = Math.tan(Math.PI / 8);
export const inches = (entity: Entity) => {
  const [type, ...rest] = entity.split(" ");
  const lengths = new Set(["10", "20", "11", "21", "40"]);
  return [
    type,
    ...rest.map((v, i) => (i % 2 === 1 && lengths.has(rest[i - 1] ?? "") ? String(Number(v) / 25.4) : v)),
  ].join(" ");
};
export const text = (parts: Parts) => utf8(asText(dxfGroups(parts)));
export const mm = (entities: readonly Entity[], more: Partial<Parts> = {}) => text({ header: MM, entities, ...more });
/** A side view about y = 0 from x = 0 to the left: both halves, shoulders across the axis. */
export const sideView = (dx = 0, dy = 0, more?: string): Entity[] =>
  [1, -1]
    .flatMap((s) => [
      line(dx, dy + 12 * s, dx - 18, dy + 12 * s, more),
      s > 0 ? arc(dx - 18, dy + 16, 4, 180, 270, more) : arc(dx - 18, dy - 16, 4, 90, 180, more),
      line(dx - 22, dy + 27 * s, dx - 46, dy + 27 * s, more),
    ])
    .concat([
      line(dx, dy - 12, dx, dy + 12, more),
      line(dx - 22, dy - 27, dx - 22, dy + 27, more),
      line(dx - 46, dy - 27, dx - 46, dy + 27, more),
    ]);
export const LAYERS = [
  "LAYER 2 0 70 0 62 7 6 CONTINUOUS",
  "LAYER 2 OFF 70 0 62 -3 6 CONTINUOUS",
  "LAYER 2 ICE 70 1 62 3 6 CONTINUOUS",
];
/** Quarter circle of the cove as a cubic Bézier curve, off the circle by 0.001 mm. */
export const K = 4 * 0.5522847498307936;
export const bezier = `SPLINE 8 0 70 8 71 3 72 8 73 4 74 0 ${[0, 0, 0, 0, 1, 1, 1, 1].map((k) => `40 ${k}`).join(" ")} 10 -18 20 12 10 ${-18 - K} 20 12 10 -22 20 ${16 - K} 10 -22 20 16`;
export const rational = `SPLINE 8 0 70 12 71 2 72 6 73 3 ${[0, 0, 0, 1, 1, 1].map((k) => `40 ${k}`).join(" ")} 41 1 41 ${Math.SQRT1_2} 41 1 10 -18 20 12 10 -22 20 12 10 -22 20 16`;
export const straight = (x1: number, y1: number, x2: number, y2: number) =>
  `SPLINE 8 0 70 8 71 1 72 4 73 2 40 0 40 0 40 1 40 1 10 ${x1} 20 ${y1} 11 0 10 ${x2} 20 ${y2}`.replace(" 11 0", "");
export const lines3 = [line(0, 12, -18, 12), line(-22, 16, -22, 27), line(-22, 27, -46, 27)];
export const old = (vertices: readonly (readonly [number, number, number?])[], flags: number, more = "") =>
  [
    `POLYLINE 8 0 66 1 70 ${flags} ${more}`,
    ...vertices.map(([x, y, b]) => `VERTEX 8 0 10 ${x} 20 ${y}${b === undefined ? "" : ` 42 ${b}`}`),
    "SEQEND 8 0",
  ].flat();
export const BACK = "8 0 210 0 220 0 230 -1";

/** A drawing, the contour it gives, and the codes of the notes that go with it. */
export type Case = readonly [name: string, bytes: Uint8Array, contour: string, notes?: readonly string[]];
