import { expect, test } from "vitest";
import { at, type Segment } from "../kernel/geometry/point.ts";
import { radians } from "../kernel/units.ts";
import { c820 } from "./c820.ts";
import { cycleByNumber } from "./index.ts";

/*
 * Contours by the box rule (decision "The box rule"), their corners calculated by hand: [z, r], in machining direction.
 * All lengths differ, so that any mix-up shows.
 */
const tan = (degrees: number) => Math.tan(radians(degrees));
const plain = { Q500: 0, Q501: 0, Q503: 0, Q495: 0, Q496: 0 };
const box = { Q491: 80, Q492: -20, Q493: 50, Q494: -50 };

const cases: readonly [
  name: string,
  cycle: number,
  values: Record<string, number>,
  corners: readonly (readonly [number, number])[],
][] = [
  [
    "812, both angles lean into the box",
    812,
    { ...plain, ...box, Q495: 3, Q496: 7 },
    (() => {
      // Surface r = 25 + (−20 − z) tan 3°, face z = −50 + (40 − r) tan 7°.
      const r = (25 + (30 - 40 * tan(7)) * tan(3)) / (1 - tan(7) * tan(3));
      return [
        [-20, 25],
        [-50 + (40 - r) * tan(7), r],
        [-50, 40],
      ] as const;
    })(),
  ],
  [
    "812, a chamfer at the start and a longer one at the end",
    812,
    { ...plain, ...box, Q501: 1, Q502: 1.3, Q503: 1, Q504: 2.1 },
    [
      [-20, 23.7],
      [-21.3, 25],
      [-50, 25],
      [-50, 37.9],
      [-52.1, 40],
    ],
  ],
  [
    "822, both angles lean into the box",
    822,
    { ...plain, ...box, Q495: 3, Q496: 7 },
    (() => {
      // Face z = −50 + (40 − r) tan 3°, surface r = 25 + (−20 − z) tan 7°.
      const r = (25 + (30 - 40 * tan(3)) * tan(7)) / (1 - tan(3) * tan(7));
      return [
        [-50, 40],
        [-50 + (40 - r) * tan(3), r],
        [-20, 25],
      ] as const;
    })(),
  ],
  [
    "822, a chamfer at the start and a longer one at the end",
    822,
    { ...plain, ...box, Q501: 1, Q502: 1.3, Q503: 1, Q504: 2.1 },
    [
      [-51.3, 40],
      [-50, 38.7],
      [-50, 25],
      [-22.1, 25],
      [-20, 22.9],
    ],
  ],
  [
    "814, a flank that falls and a face that leans",
    814,
    { ...plain, ...box, Q495: 40, Q496: 17 },
    [
      [-20, 40],
      [-20 - 15 * tan(40), 25],
      [-50 + 15 * tan(17), 25],
      [-50, 40],
    ],
  ],
  [
    "814, a chamfer on either edge",
    814,
    { ...plain, ...box, Q501: 1, Q502: 1.3, Q503: 1, Q504: 2.1 },
    [
      [-18.7, 40],
      [-20, 38.7],
      [-20, 25],
      [-50, 25],
      [-50, 37.9],
      [-52.1, 40],
    ],
  ],
  [
    "813 inside",
    813,
    { Q491: 50, Q492: -20, Q493: 80, Q494: -50, Q495: 40 },
    [
      [-20, 25],
      [-20 - 15 * tan(40), 40],
      [-50, 40],
      [-50, 25],
    ],
  ],
  [
    "824, a flank that falls and a wall that leans",
    824,
    { ...plain, ...box, Q494: -26, Q495: 40, Q496: 17 },
    [
      [-20, 40],
      [-26, 40 - 6 * tan(40)],
      [-26, 25 + 6 * tan(17)],
      [-20, 25],
    ],
  ],
  [
    "823",
    823,
    { ...box, Q494: -26, Q495: 40 },
    [
      [-20, 40],
      [-26, 40 - 6 * tan(40)],
      [-26, 25],
      [-20, 25],
    ],
  ],
  [
    "852, walls of different angle",
    852,
    { ...plain, ...box, Q495: 5, Q496: 17 },
    [
      [-20, 40],
      [-50, 40 - 30 * tan(5)],
      [-50, 25 + 30 * tan(17)],
      [-20, 25],
    ],
  ],
  [
    "852 from inside out",
    852,
    {
      ...plain,
      ...box,
      Q491: 50,
      Q493: 80,
      Q495: 5,
      Q496: 17,
    },
    [
      [-20, 25],
      [-50, 25 + 30 * tan(5)],
      [-50, 40 - 30 * tan(17)],
      [-20, 40],
    ],
  ],
  [
    "852, a chamfer on either edge",
    852,
    {
      ...plain,
      ...box,
      Q501: 1,
      Q502: 1.3,
      Q503: 1,
      Q504: 2.1,
    },
    [
      [-20, 41.3],
      [-21.3, 40],
      [-50, 40],
      [-50, 25],
      [-22.1, 25],
      [-20, 22.9],
    ],
  ],
];

test.each(cases)("%s", (_name, number, values, corners) => {
  const cycle = cycleByNumber(number);
  if (!cycle) throw new Error(`no cycle ${number}`);
  const { contour, issues } = cycle.outline(
    { ...Object.fromEntries(Object.entries(cycle.params).map(([q, p]) => [q, p.example])), ...values } as never,
    { contour: null, start: null },
  );
  expect(issues).toEqual([]);
  expect(contour.every((s) => s.kind === "line")).toBe(true);
  const points = [...contour.slice(0, 1).map((s) => s.from), ...contour.map((s) => s.to)];
  const rounded = (n: number) => Number(n.toFixed(6)) + 0;
  expect(points.map((p) => [rounded(p.z), rounded(p.r)])).toEqual(corners.map(([z, r]) => [rounded(z), rounded(r)]));
});

test("an element 2 is a radius: an arc, tangential on both sides", () => {
  const cycle = cycleByNumber(812);
  const values = {
    ...Object.fromEntries(Object.entries(cycle?.params ?? {}).map(([q, p]) => [q, p.example])),
    ...plain,
    ...box,
    Q501: 2,
    Q502: 1.3,
  };
  const first = cycle?.outline(values as never, { contour: null, start: null }).contour[0];
  expect(first).toMatchObject({
    kind: "arc",
    from: { z: -20, r: 23.7 },
    to: { z: -21.3, r: 25 },
    centre: { z: -21.3, r: 23.7 },
  });
});

test("a free contour that crosses itself, or ends behind itself, is drawn and refused", () => {
  const along = (...points: (readonly [number, number])[]): Segment[] =>
    points
      .slice(1)
      .map((p, i) => ({ kind: "line", from: at(...(points[i] as readonly [number, number])), to: at(...p) }));
  const values = Object.fromEntries(Object.entries(c820.params).map(([q, p]) => [q, p.example])) as never;
  const outlined = (contour: Segment[]) => {
    const { contour: drawn, issues } = c820.outline(values, { contour, start: null });
    return [drawn.length, ...issues.map((i) => i.code)];
  };
  const crossing = along([-6.4, 10], [-12, 30], [-4.5, 37.5], [-2.2, 25], [-13, 26], [-9, 41]);
  expect(outlined(crossing)).toEqual([5, "contourCrossesItself"]);
  expect(outlined(along([-6.4, 10], [-12, 30], [-4.5, 37.5], [-5.1, 33.2]))).toEqual([3, "contourEndCovered"]);
  expect(outlined(along([-6.4, 10], [-4.5, 37.5]))).toEqual([1]);
});

test("a simple shoulder extends from the tip at the call to its end, outside or inside by that tip", () => {
  const corners = (number: number, start: readonly [number, number]) => {
    const cycle = cycleByNumber(number);
    const values = Object.fromEntries(Object.entries(cycle?.params ?? {}).map(([q, p]) => [q, p.example]));
    const contour =
      cycle?.outline({ ...values, Q493: 50, Q494: -30 } as never, { contour: null, start: at(...start) }).contour ?? [];
    return [...contour.slice(0, 1).map((s) => s.from), ...contour.map((s) => s.to)].map((p) => [p.z, p.r]);
  };
  expect(corners(811, [2, 33])).toEqual([
    [2, 25],
    [-30, 25],
    [-30, 33],
  ]);
  expect(corners(811, [-61, 18])).toEqual([
    [-61, 25],
    [-30, 25],
    [-30, 18],
  ]);
  expect(corners(821, [2, 33])).toEqual([
    [-30, 33],
    [-30, 25],
    [2, 25],
  ]);
  expect(corners(821, [2, 18])).toEqual([
    [-30, 18],
    [-30, 25],
    [2, 25],
  ]);
});
