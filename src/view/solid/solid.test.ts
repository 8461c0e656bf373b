import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { areaOf, areaOfRing } from "../../kernel/area/area.ts";
import { difference, intersection, union } from "../../kernel/area/clip.ts";
import { at, type Ring } from "../../kernel/geometry/point.ts";
import { extruded } from "./extrude.ts";
import { trianglesOf } from "./fill.ts";
import { joinedMeshes, volumeOf, type Mesh } from "./mesh.ts";
import { chordsFor, revolved, wholeMesh } from "./revolve.ts";
import { stlOf } from "./stl.ts";

const ring = (...points: readonly (readonly [z: number, r: number])[]): Ring => points.map(([z, r]) => at(z, r));
const bar = ring([-61.3, 0], [1.7, 0], [1.7, 24.85], [-61.3, 24.85]);
const tube = ring([-40.2, 11.15], [0.6, 11.15], [0.6, 19.9], [-40.2, 19.9]);
const cavity = [...ring([-30.1, 13.3], [-9.7, 13.9], [-11.2, 17.45], [-28.8, 16.2])].reverse();
const round = Array.from({ length: 80 }, (_, i) =>
  at(-20 + 7.3 * Math.cos((i * Math.PI) / 40), 9.1 + 7.3 * Math.sin((i * Math.PI) / 40)),
);

/** For every edge, how often it is run through in one direction less the other, and how many triangles have it. */
function edgeBook(mesh: Mesh) {
  const p = mesh.positions,
    book = new Map<string, { sum: number; count: number }>();
  const name = (i: number) => `${p[3 * i]} ${p[3 * i + 1]} ${p[3 * i + 2]}`;
  for (let t = 0; t < mesh.index.length; t += 3)
    for (let k = 0; k < 3; k += 1) {
      const [a, b] = [name(mesh.index[t + k] ?? -1), name(mesh.index[t + ((k + 1) % 3)] ?? -1)];
      const key = a < b ? `${a}|${b}` : `${b}|${a}`,
        entry = book.get(key) ?? { sum: 0, count: 0 };
      book.set(key, { sum: entry.sum + (a < b ? 1 : -1), count: entry.count + 1 });
    }
  return [...book.values()];
}
const isWatertight = (mesh: Mesh) => edgeBook(mesh).every(({ sum, count }) => sum === 0 && count === 2);

/** 2π · area · distance of the centroid, exact for polygons: the first moment about the axis. */
const volumeTurned = (rings: readonly Ring[]) =>
  rings.reduce(
    (sum, points) =>
      sum +
      points.reduce((s, p, i) => {
        const q = points[(i + 1) % points.length] ?? p;
        return s + (p.z * q.r - q.z * p.r) * (p.r + q.r);
      }, 0) /
        6,
    0,
  ) *
  2 *
  Math.PI;
/** 2π · length · distance of the middle from the axis, mm². */
const surfaceTurned = (rings: readonly Ring[]) =>
  rings.reduce(
    (sum, points) =>
      sum +
      points.reduce((s, p, i) => {
        const q = points[(i + 1) % points.length] ?? p;
        return s + Math.PI * (p.r + q.r) * Math.hypot(q.z - p.z, q.r - p.r);
      }, 0),
    0,
  );
/** Farther than any corner of the bodies here, a power of two, mm. */
const SIZE = 128;
/** The area of a polygon with so many corners, as a share of its circle. */
const polygonShare = (chords: number) => (chords / (2 * Math.PI)) * Math.sin((2 * Math.PI) / chords);

const bodies: readonly (readonly [string, readonly Ring[]])[] = [
  ["a bar on the axis", [bar]],
  ["a tube", [tube]],
  ["a body with a cavity", [tube, cavity]],
  ["a ring of round section", [round]],
  ["a cone that ends in a point", [ring([-17.3, 0], [4.1, 0], [-17.3, 8.65])]],
  ["two bodies after parting off", [bar, ring([9.35, 3.2], [14.05, 3.2], [14.05, 12.9])]],
];

describe("a revolved body", () => {
  test.each(bodies)("%s is closed, faces outwards and has its volume, whole and cut", (_, rings) => {
    const chords = 116;
    const whole = wholeMesh(revolved(rings, { chords, quarterCut: false })),
      cut = wholeMesh(revolved(rings, { chords, quarterCut: true }));
    expect(isWatertight(whole)).toBe(true);
    expect(isWatertight(cut)).toBe(true);
    const expected = volumeTurned(rings) * polygonShare(chords);
    expect(volumeOf(whole) / expected).toBeCloseTo(1, 5);
    expect(volumeOf(cut) / (0.75 * expected)).toBeCloseTo(1, 5);
  });

  test("any stock of overlapping bars and grooves is closed and has its volume", () => {
    const size = fc.integer({ min: 1, max: 3999 }).map((n) => n / 100);
    const box = fc
      .tuple(size, size, size, size)
      .map(([z, dz, r, dr]) => ring([z, r], [z + dz, r], [z + dz, r + dr], [z, r + dr]));
    fc.assert(
      fc.property(fc.array(box, { minLength: 1, maxLength: 4 }), fc.array(box, { maxLength: 4 }), (solid, gone) => {
        const rings = difference(union(solid), gone),
          chords = 44;
        for (const quarterCut of [false, true]) {
          const mesh = wholeMesh(revolved(rings, { chords, quarterCut }));
          expect(edgeBook(mesh).every(({ sum }) => sum === 0)).toBe(true);
          const expected = volumeTurned(rings) * polygonShare(chords) * (quarterCut ? 0.75 : 1);
          // Corners are kept as numbers of 24 bits: a thin disc of a large area may be off by that much on both faces.
          const rounded = 2 * SIZE * 2 ** -24 * surfaceTurned(rings);
          expect(Math.abs(volumeOf(mesh) - expected)).toBeLessThan(1e-4 * Math.max(1, expected) + rounded);
        }
      }),
    );
  });

  test("corners are sharp and roundings smooth, and every normal shows out of the material", () => {
    // Four corners with two directions each: eight rows.
    expect(revolved([bar], { chords: 32, quarterCut: false }).surface.positions.length / 3).toBe(8 * 32);
    const torus = revolved([round], { chords: 32, quarterCut: false });
    expect(torus.surface.positions.length / 3).toBe(80 * 32);
    expect(torus.edges.length).toBe(0);
    for (let i = 0; i < torus.surface.normals.length; i += 3) {
      const [x = 0, y = 0, z = 0] = torus.surface.positions.subarray(i, i + 3),
        [nx = 0, ny = 0, nz = 0] = torus.surface.normals.subarray(i, i + 3);
      const r = Math.hypot(x, y),
        out = ((r - 9.1) * (x * nx + y * ny)) / r + (z + 20) * nz;
      expect(out / 7.3).toBeGreaterThan(0.999);
    }
  });

  test("chords stay within their length of the circle, in multiples of four", () => {
    for (const size of [0.3, 4.77, 24.85, 163.2]) {
      const chords = chordsFor(size);
      expect(chords % 4).toBe(0);
      expect(size * (1 - Math.cos(Math.PI / chords))).toBeLessThanOrEqual(0.02 + 1e-9);
    }
    expect(chordsFor(24.85)).toBe(80);
  });

  test("points slightly beyond the axis are closed on it; outlines without area make nothing", () => {
    const over = ring([-5, -0.00005], [3, 0.00002], [3, 6.6], [-5, 6.6]);
    expect(isWatertight(wholeMesh(revolved([over], { chords: 32, quarterCut: true })))).toBe(true);
    expect(revolved([ring([0, 1], [2, 1])], { chords: 32, quarterCut: true }).surface.index.length).toBe(0);
  });
});

describe("the section", () => {
  const areaFilled = (rings: readonly Ring[]) => {
    const points = rings.flat(),
      triangles = trianglesOf(rings);
    let sum = 0;
    for (let i = 0; i < triangles.length; i += 3) {
      const area = areaOfRing([0, 1, 2].flatMap((k) => points[triangles[i + k] ?? -1] ?? []));
      expect(area).toBeGreaterThan(-1e-6);
      sum += area;
    }
    return sum;
  };

  test("holes stay open, also two in one body, and a body may lie in a hole", () => {
    const small = [...ring([-36.4, 12.9], [-32.2, 12.9], [-33.1, 14.4])].reverse(),
      island = ring([-21.3, 14.4], [-17.9, 14.4], [-18.8, 15.3]);
    const rings = [tube, cavity, small, island];
    expect(areaFilled(rings)).toBeCloseTo(areaOf(rings), 6);
  });

  test("corners on straight sides have triangles, so that sections and sides meet without gaps", () => {
    const divided = ring(
      ...tube.flatMap((p, i) => {
        const q = tube[(i + 1) % tube.length] ?? p;
        return [0, 0.25, 0.5, 0.75].map((k): [number, number] => [p.z + k * (q.z - p.z), p.r + k * (q.r - p.r)]);
      }),
    );
    expect(new Set(trianglesOf([divided])).size).toBe(divided.length);
    expect(areaFilled([divided])).toBeCloseTo(areaOfRing(divided), 6);
  });

  test("a comb of grooves is filled exactly", () => {
    const teeth = Array.from({ length: 25 }, (_, i) =>
      ring([-2.4 * i - 1.3, 14.2], [-2.4 * i, 14.2], [-2.4 * i - 0.6, 30]),
    );
    const rings = difference([bar], teeth);
    expect(areaFilled(rings)).toBeCloseTo(areaOf(rings), 6);
    expect(areaOf(intersection([bar], teeth))).toBeGreaterThan(100);
  });
});

test("a plate is closed and has its volume, whichever way its outline runs", () => {
  const outline = ring([0.4, 0.1], [9.3, 3.3], [4.2, 11.9]),
    volume = areaOfRing(outline) * 4.76;
  for (const each of [outline, [...outline].reverse()]) {
    const mesh = extruded(each, -4.76, 0);
    expect(isWatertight(mesh)).toBe(true);
    expect(volumeOf(mesh)).toBeCloseTo(volume, 3);
  }
});

test("an STL file gives the same closed body back", () => {
  const mesh = joinedMeshes([wholeMesh(revolved([tube, cavity], { chords: 48, quarterCut: false }))]);
  const bytes = stlOf(mesh, "BÜCHSE"),
    view = new DataView(bytes.buffer),
    count = view.getUint32(80, true);
  expect(bytes.length).toBe(84 + 50 * count);
  expect(new TextDecoder().decode(bytes.subarray(0, 5))).not.toBe("solid");
  expect(new TextDecoder().decode(bytes.subarray(0, 80))).toContain("B_CHSE");
  const positions = new Float32Array(9 * count);
  for (let t = 0; t < count; t += 1) {
    const number = (k: number) => view.getFloat32(84 + 50 * t + 4 * k, true);
    for (let k = 0; k < 9; k += 1) positions[9 * t + k] = number(3 + k);
    const corner = (k: number) => [number(3 + 3 * k), number(4 + 3 * k), number(5 + 3 * k)] as const;
    const [a, b, c] = [corner(0), corner(1), corner(2)],
      [u, v] = [b, c].map((q) => q.map((n, i) => n - (a[i] ?? 0)));
    const cross = [0, 1, 2].map(
      (i) => (u?.[(i + 1) % 3] ?? 0) * (v?.[(i + 2) % 3] ?? 0) - (u?.[(i + 2) % 3] ?? 0) * (v?.[(i + 1) % 3] ?? 0),
    );
    const along = cross.reduce((sum, n, i) => sum + n * number(i), 0);
    expect(along / Math.hypot(...cross)).toBeCloseTo(1, 3);
  }
  const read = { positions, normals: positions, index: Uint32Array.from({ length: 3 * count }, (_, i) => i) };
  expect(isWatertight(read)).toBe(true);
  expect(volumeOf(read)).toBeCloseTo(volumeTurned([tube, cavity]) * polygonShare(48), 0);
});
