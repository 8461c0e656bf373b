import { describe, expect, test } from "vitest";
import { contourFrom, type ContourElement } from "./contour.ts";
import type { Groove } from "./groove.ts";
import { at, part, type Segment } from "../geometry/point.ts";
import { undercutOfDiameter, undercutOfPitch } from "./undercut-table.ts";
import type { RecessWords, Undercut } from "./undercut.ts";
import { diameter } from "../units.ts";

const { direction, lengthOf } = part;

const to = (z: number, r: number): ContourElement => ({ kind: "line", to: at(z, r) });
const udc = (form: Undercut["form"], words: RecessWords): Undercut => ({ kind: "undercut", form, words });
const grv = (direction: Groove["direction"], words: RecessWords): Groove => ({ kind: "groove", direction, words });
/** The printed example: a shaft of 40 mm from Z0 to Z-30, and the face up to 60 mm. */
const shaft = (e: ContourElement) => contourFrom([to(0, 20), to(-30, 20), e, to(-30, 30)]);

function expectPoints(segments: readonly Segment[], points: readonly (readonly [number, number])[]): void {
  const ends = [segments[0]?.from, ...segments.map((s) => s.to)].map((p) => [p?.z ?? NaN, p?.r ?? NaN]);
  expect(ends.length).toBe(points.length);
  points.forEach(([z, r], i) => {
    expect(ends[i]?.[0]).toBeCloseTo(z, 4);
    expect(ends[i]?.[1]).toBeCloseTo(r, 4);
  });
}
const tangential = (a: Segment, b: Segment) => {
  const [one, two] = [direction(a, a.to), direction(b, b.from)];
  return one.z * two.z + one.r * two.r > 1 - 1e-9;
};
const centres = (segments: readonly Segment[]) =>
  segments.flatMap((s) => (s.kind === "arc" ? [[s.centre.z, s.centre.r]] : []));

describe("UDC", () => {
  test("TYPE_E R1 DEPTH2 BREADTH15, the printed example", () => {
    const c = shaft(udc("E", { R: 1, DEPTH: 2, BREADTH: 15 }));
    // 15 degrees: the slope is 2 / tan 15 = 7.4641 long; its rounding takes tan 7.5 = 0.13165 off either side.
    expectPoints(c.segments, [
      [0, 20],
      [-15, 20],
      [-22.33694, 18.03407],
      [-22.59575, 18],
      [-29, 18],
      [-30, 19],
      [-30, 30],
    ]);
    expect(centres(c.segments)).toEqual([
      [expect.closeTo(-22.59575, 4), expect.closeTo(19, 9)],
      [expect.closeTo(-29, 9), expect.closeTo(19, 9)],
    ]);
    expect(c.issues).toMatchObject([
      { code: "undercutDefaults", severity: "info", data: { element: 3, words: "ANGLE15" } },
    ]);
    expect(c.elements).toEqual([2, 3, 3, 3, 3, 4]);
  });

  test("TYPE_E with every word reports nothing, and without any takes DIN 509", () => {
    expect(shaft(udc("E", { R: 1, DEPTH: 2, BREADTH: 15, ANGLE: 20 })).issues).toEqual([]);
    const c = shaft(udc("E", {}));
    expect(c.issues).toMatchObject([{ code: "undercutDefaults", data: { words: "R0.6 DEPTH0.3 BREADTH2.5 ANGLE15" } }]);
    expect(Math.min(...c.segments.map((s) => s.to.r))).toBeCloseTo(19.7, 9);
    expect(c.segments[0]?.to.z).toBeCloseTo(-27.5, 9);
  });

  test("TYPE_E in a bore goes outwards, and towards the front it is the mirror image", () => {
    const bore = contourFrom([
      to(0, 20),
      to(-30, 20),
      udc("E", { R: 1, DEPTH: 2, BREADTH: 15, ANGLE: 15 }),
      to(-30, 10),
    ]);
    expectPoints(bore.segments, [
      [0, 20],
      [-15, 20],
      [-22.33694, 21.96593],
      [-22.59575, 22],
      [-29, 22],
      [-30, 21],
      [-30, 10],
    ]);
    const back = contourFrom([
      to(-30, 30),
      to(-30, 20),
      udc("E", { R: 1, DEPTH: 2, BREADTH: 15, ANGLE: 15 }),
      to(0, 20),
    ]);
    expectPoints(back.segments, [
      [-30, 30],
      [-30, 19],
      [-29, 18],
      [-22.59575, 18],
      [-22.33694, 18.03407],
      [-15, 20],
      [0, 20],
    ]);
  });

  test("TYPE_F reaches FACEDEPTH into the face and leaves it at FACEANGLE", () => {
    const c = shaft(udc("F", { R: 1, DEPTH: 2, BREADTH: 15, ANGLE: 15, FACEDEPTH: 0.5, FACEANGLE: 8 }));
    expect(c.issues).toEqual([]);
    const arcs = c.segments.filter((s) => s.kind === "arc");
    // Centre of the second arc: R above the floor, R in front of the deepest point of the face.
    expect(arcs[1]?.kind === "arc" && arcs[1].centre).toMatchObject({
      z: expect.closeTo(-29.5, 9),
      r: expect.closeTo(19, 9),
    });
    // Tangent point (-30.5 + 1 - cos 8, 19 + sin 8), then 8 degrees back to the face: 0.490268 / tan 8 = 3.488464
    // higher.
    const end = c.segments.at(-2);
    expect(end?.from.z).toBeCloseTo(-30.490268, 5);
    expect(end?.from.r).toBeCloseTo(19.139173, 5);
    expect(end?.to.z).toBeCloseTo(-30, 9);
    expect(end?.to.r).toBeCloseTo(22.627637, 4);
  });

  test("TYPE_H rounds slope and face with one arc", () => {
    const c = shaft(udc("H", { R: 1, BREADTH: 5, ANGLE: 20 }));
    // The slope would meet the face at 20 - 5 tan 20 = 18.180149; the arc touches the face 1 / tan 35 higher.
    expectPoints(c.segments, [
      [0, 20],
      [-25, 20],
      [-28.65798, 18.668604],
      [-30, 19.608297],
      [-30, 30],
    ]);
    expect(tangential(c.segments[1] as Segment, c.segments[2] as Segment)).toBe(true);
  });

  test("TYPE_K cuts a wedge into the corner, DEPTH below the cylinder", () => {
    const c = shaft(udc("K", { R: 0.5, DEPTH: 2, ROT: 45, ANGLE: 40 }));
    const arc = c.segments.find((s) => s.kind === "arc");
    expect(arc?.kind === "arc" && [arc.centre.z, arc.centre.r]).toEqual([
      expect.closeTo(-31.5, 9),
      expect.closeTo(18.5, 9),
    ]);
    // By symmetry cylinder and face are met at the same distance from the corner.
    const [onCylinder, onFace] = [c.segments[0]?.to, c.segments.at(-1)?.from];
    expect((onCylinder?.z ?? 0) + 30).toBeCloseTo((onFace?.r ?? 0) - 20, 9);
    // Apex 0.5 / sin 20 = 1.461902 behind the centre on the diagonal: -32.533721; back at 25 degrees from 17.466279 to
    // 20.
    expect(onCylinder?.z).toBeCloseTo(-27.100139, 5);
  });

  test("TYPE_U is a square recess beside the face with a broken edge", () => {
    const c = shaft(udc("U", { R: 0.5, DEPTH: 2, BREADTH: 6, CHF: 0.4 }));
    expectPoints(c.segments, [
      [0, 20],
      [-23.6, 20],
      [-24, 19.6],
      [-24, 18.5],
      [-24.5, 18],
      [-29.5, 18],
      [-30, 18.5],
      [-30, 30],
    ]);
  });

  test("THREAD takes DIN 76 by its pitch, outside and inside", () => {
    const c = shaft(udc("THREAD", { PITCH: 2 }));
    expect(c.issues).toMatchObject([{ code: "undercutDefaults", data: { words: "R1 DEPTH1.5 BREADTH7 ANGLE30" } }]);
    expect(c.segments[0]?.to.z).toBeCloseTo(-23, 9);
    expect(Math.min(...c.segments.map((s) => s.to.r))).toBeCloseTo(18.5, 9);
    expect(undercutOfPitch(2, { bore: diameter(20) })).toMatchObject({ DEPTH: 0.25, BREADTH: 10.3 });
    expect(undercutOfPitch(2.1, "shaft")).toBeNull();
    expect(shaft(udc("THREAD", { PITCH: 2.1, DEPTH: 1.6, BREADTH: 7.4 })).issues.map((i) => i.code)).toEqual([
      "undercutDefaults",
    ]);
    // 0.0787 and 0.7874 inch: a pitch of 2 mm in a bore of 20 mm.
    expect(undercutOfPitch(1.99898, "shaft")).toEqual(undercutOfPitch(2, "shaft"));
    expect(undercutOfPitch(1.98, "shaft")).toBeNull();
    expect(undercutOfPitch(1.99898, { bore: diameter(19.99996) })?.DEPTH).toBeCloseTo(0.25, 4);
    expect(undercutOfDiameter(diameter(100))).toMatchObject({ R: 1, DEPTH: 0.4, BREADTH: 4, FACEDEPTH: 0.3 });
  });

  // Floor at nominal + I: of a listed size programmed as such, of the size whose core is this bore, of an unlisted
  // size.
  test.each<[bore: number, pitch: number, floor: number]>([
    [17.835, 2, 20.5],
    [17.98, 2, 20.5],
    [20, 2, 20.5],
    [37.835, 2, 40.5],
    [38, 2, 40.5],
    [40, 2, 40.5],
    [17.294, 2.5, 20.5],
    [17.5, 2.5, 20.5],
    [8.376, 1.5, 10.5],
    [6.647, 1.25, 8.5],
    [2.459, 0.5, 3.3],
    [2.013, 0.45, 2.7],
    [91.7, 3, 95.4478],
  ])("THREAD in a bore of %d with pitch %d has its floor at %d", (bore, PITCH, floor) => {
    const c = contourFrom([to(0, bore / 2), to(-50, bore / 2), udc("THREAD", { PITCH }), to(-50, 0.3)]);
    expect(c.issues).toMatchObject([{ code: "undercutDefaults" }]);
    expect(Math.max(...c.segments.map((s) => s.to.r))).toBeCloseTo(floor / 2, 6);
  });

  test.each<[string, ContourElement, object]>([
    [
      "a pitch that is not listed",
      udc("THREAD", { PITCH: 2.1 }),
      {
        code: "pitchNotListed",
        data: { pitch: 2.1, below: 2, above: 2.5, words: "DEPTH BREADTH" },
      },
    ],
    [
      "a pitch that is not listed, with one of its words",
      udc("THREAD", { PITCH: 7, DEPTH: 4 }),
      {
        code: "pitchNotListed",
        data: { pitch: 7, below: 6, words: "BREADTH" },
      },
    ],
    ["no pitch at all", udc("THREAD", {}), { code: "recessWord", data: { word: "DEPTH" } }],
    [
      "wider than the cylinder",
      udc("E", { DEPTH: 2, BREADTH: 31 }),
      { code: "cornerElementTooLong", data: { size: 31, max: 30 } },
    ],
    [
      "a slope longer than the breadth",
      udc("E", { DEPTH: 2, BREADTH: 7 }),
      { code: "recessWord", data: { word: "BREADTH" } },
    ],
    [
      "deeper than the axis",
      udc("E", { DEPTH: 21, BREADTH: 30, ANGLE: 60 }),
      { code: "recessWord", data: { word: "DEPTH" } },
    ],
    [
      "a radius wider than the floor",
      udc("U", { R: 4, DEPTH: 5, BREADTH: 6 }),
      { code: "cornerElementTooLong", data: { size: 4 } },
    ],
    ["a wedge without its angle", udc("K", { DEPTH: 2 }), { code: "recessWord", data: { word: "ANGLE" } }],
  ])("%s is an error at the element", (_, e, expected) => {
    const c = shaft(e);
    expect(c.issues.filter((i) => i.severity === "error")).toMatchObject([
      {
        ...expected,
        severity: "error",
        data: { element: 3, ...(expected as { data: object }).data },
      },
    ]);
    expect(c.segments.every((s) => lengthOf(s) > 0)).toBe(true);
  });

  test("an undercut needs a cylinder, a face and a corner of its own", () => {
    const e = udc("E", { R: 0.5, DEPTH: 1, BREADTH: 10 });
    expect(contourFrom([to(0, 18), to(-30, 20), e, to(-30, 30)]).issues).toMatchObject([
      { code: "undercutNeighbours" },
    ]);
    expect(contourFrom([to(0, 20), to(-30, 20), e]).issues).toMatchObject([{ code: "undercutNeighbours" }]);
    expect(contourFrom([to(0, 20), to(-30, 20), e, { kind: "round", size: 1 }, to(-30, 30)]).issues).toMatchObject([
      {
        code: "undercutNeighbours",
      },
    ]);
    expect(
      contourFrom([to(0, 20), to(-30, 20), e, e, to(-30, 30)]).issues.filter((i) => i.severity === "error"),
    ).toMatchObject([
      {
        code: "undercutNeighbours",
      },
    ]);
  });
});

describe("GRV", () => {
  test("RADIAL in the cylinder before it, with different edges", () => {
    const c = shaft(grv("radial", { CENTER: -15, DEPTH: -5, BREADTH: 10, CHF: 1, FAR_RND: 1 }));
    expect(c.issues).toEqual([]);
    expectPoints(c.segments, [
      [0, 20],
      [-9, 20],
      [-10, 19],
      [-10, 15],
      [-20, 15],
      [-20, 19],
      [-21, 20],
      [-30, 20],
      [-30, 30],
    ]);
  });

  test.each([{ ANGLE: 45 }, { ANG_WIDTH: 90 }])(
    "%j: both flanks lean by 45°, DIAM names the floor, R rounds it",
    (angle) => {
      const c = shaft(grv("radial", { CENTER: -15, DIAM: 16, BREADTH: 10, R: 0.5, ...angle }));
      // Walls at 45 degrees; the rounding takes 0.5 tan 22.5 = 0.207107 off floor and wall.
      expectPoints(c.segments, [
        [0, 20],
        [-10, 20],
        [-13.853553, 16.146447],
        [-14.207107, 16],
        [-15.792893, 16],
        [-16.146447, 16.146447],
        [-20, 20],
        [-30, 20],
        [-30, 30],
      ]);
    },
  );

  test("ANGLE inclines each flank against the perpendicular to the element", () => {
    const c = shaft(grv("radial", { CENTER: -15, DEPTH: -2.5, BREADTH: 10.4, ANGLE: 31.7 }));
    // 2.5 tan 31.7 = 1.544029.
    expectPoints(c.segments, [
      [0, 20],
      [-9.8, 20],
      [-11.344029, 17.5],
      [-18.655971, 17.5],
      [-20.2, 20],
      [-30, 20],
      [-30, 30],
    ]);
  });

  test("AXIAL in a face, and two recesses in one cylinder in any order", () => {
    const face = contourFrom([to(0, 40), to(0, 10), grv("axial", { CENTER: 25, DEPTH: -3, BREADTH: 6 }), to(-10, 10)]);
    expectPoints(face.segments, [
      [0, 40],
      [0, 28],
      [-3, 28],
      [-3, 22],
      [0, 22],
      [0, 10],
      [-10, 10],
    ]);
    const [a, b] = [
      grv("radial", { CENTER: -8, DEPTH: -1, BREADTH: 2 }),
      grv("radial", { CENTER: -20, DEPTH: -1, BREADTH: 2 }),
    ];
    const points = [
      [0, 20],
      [-7, 20],
      [-7, 19],
      [-9, 19],
      [-9, 20],
      [-19, 20],
      [-19, 19],
      [-21, 19],
      [-21, 20],
      [-30, 20],
      [-30, 30],
    ] as const;
    for (const order of [
      [a, b],
      [b, a],
    ])
      expectPoints(contourFrom([to(0, 20), to(-30, 20), ...order, to(-30, 30)]).segments, points);
  });

  test.each<[string, ContourElement, object]>([
    [
      "on a cylinder for a face",
      grv("axial", { CENTER: 15, DEPTH: -5, BREADTH: 10 }),
      {
        code: "undercutNeighbours",
      },
    ],
    [
      "beside its element",
      grv("radial", { CENTER: 5, DEPTH: -5, BREADTH: 10 }),
      { code: "recessWord", data: { word: "CENTER" } },
    ],
    ["without depth", grv("radial", { CENTER: -15, BREADTH: 10 }), { code: "recessWord", data: { word: "DEPTH" } }],
    [
      "wider than its place",
      grv("radial", { CENTER: -5, DEPTH: -5, BREADTH: 12 }),
      {
        code: "cornerElementTooLong",
        data: { size: 12, max: 10 },
      },
    ],
    [
      "flanks that meet above the floor",
      grv("radial", { CENTER: -15, DEPTH: -5, BREADTH: 10, ANGLE: 45 }),
      {
        code: "recessWord",
        data: { word: "ANGLE" },
      },
    ],
    [
      "an opening angle whose flanks meet above the floor",
      grv("radial", { CENTER: -15, DEPTH: -5, BREADTH: 10, ANG_WIDTH: 90 }),
      {
        code: "recessWord",
        data: { word: "ANG_WIDTH" },
      },
    ],
    [
      "a flank along its element",
      grv("radial", { CENTER: -15, DEPTH: -5, BREADTH: 10, ANGLE: 90 }),
      {
        code: "recessWord",
        data: { word: "ANGLE" },
      },
    ],
    [
      "an opening of a straight angle",
      grv("radial", { CENTER: -15, DEPTH: -5, BREADTH: 10, ANG_WIDTH: 180 }),
      {
        code: "recessWord",
        data: { word: "ANG_WIDTH" },
      },
    ],
    [
      "depth and diameter",
      grv("radial", { CENTER: -15, DEPTH: -5, DIAM: 15, BREADTH: 10 }),
      {
        code: "recessWordsExclusive",
        data: { element: 3, word: "DIAM", other: "DEPTH" },
      },
    ],
    [
      "flank and opening angle",
      grv("radial", { CENTER: -15, DEPTH: -5, BREADTH: 10, ANGLE: 10.5, ANG_WIDTH: 21 }),
      {
        code: "recessWordsExclusive",
        data: { element: 3, word: "ANG_WIDTH", other: "ANGLE" },
      },
    ],
    [
      "a rounding and a chamfer on one edge",
      grv("radial", { CENTER: -15, DEPTH: -5, BREADTH: 10, FAR_RND: 1, FAR_CHF: 0.5 }),
      {
        code: "recessWordsExclusive",
        data: { element: 3, word: "FAR_CHF", other: "FAR_RND" },
      },
    ],
  ])("%s is an error at the element", (_, e, expected) => {
    expect(shaft(e).issues).toMatchObject([expected]);
  });
});
