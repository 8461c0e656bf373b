import { expect, test } from "vitest";
import type { Camera } from "../camera.ts";
import type { SurfaceEdge } from "./scan.ts";
import { flanksOf, helix, silhouette, threadZones } from "./thread-zone.ts";

const PITCH = 1.7;
const thread = { texture: "thread", step: 9, pitch: PITCH, from: 4, way: [-1, 0], hand: 1 } as const,
  turned = { texture: "finished", step: 3, pitch: 0, from: 2, way: [-1, 0], hand: 1 } as const;

/** Grooves from right to left, as an outer ring runs, with crests between them. */
function grooves(count: number, begin: number, r: number): SurfaceEdge[] {
  const points: [number, number, typeof thread | typeof turned][] = [];
  for (let i = 0; i < count; i += 1) {
    const z = begin - i * PITCH;
    points.push([z, r, turned], [z - 0.21, r, thread], [z - 0.86, r - 1.03, thread], [z - 1.51, r, turned]);
  }
  return points.slice(1).map(([z1, r1], i) => {
    const [z0, r0, made] = points[i] ?? expect.fail();
    return { z0, r0, z1, r1, made };
  });
}
const camera: Camera = { scale: 10, zero: { x: 300, y: 200 }, xUp: true };

test("grooves within a lead are one zone, those far away another one", () => {
  const near = grooves(5, -1.1, 13.2),
    far = grooves(3, -31.4, 13.2);
  const link: SurfaceEdge = { z0: near.at(-1)?.z1 ?? 0, r0: 13.2, z1: -31.4, r1: 13.2, made: turned };
  const [first, second, ...more] = threadZones({ edges: [...near, link, ...far], corners: [] });
  expect(more).toEqual([]);
  expect([first?.isInside, first?.lead, second?.lead]).toEqual([false, PITCH, PITCH]);
  expect(first?.right).toBeCloseTo(-1.31, 9);
  expect(second?.right).toBeCloseTo(-31.61, 9);
  expect(first?.profile.map((p) => p.z)).toEqual([...(first?.profile ?? [])].map((p) => p.z).sort((a, b) => a - b));
});

test("a point of the profile comes back half a lead on at the other side, to the right on its way down", () => {
  const [zone] = threadZones({ edges: grooves(4, -1.1, 13.2), corners: [] });
  if (!zone) return expect.fail();
  for (const xUp of [true, false]) {
    const curve = helix({ ...camera, xUp }, zone, { z: -3.3, r: 12.1 }, [0, 1]),
      down = [...curve].sort((a, b) => a[1] - b[1]);
    expect(down.map(([x]) => x)).toEqual([...curve].map(([x]) => x).sort((a, b) => a - b));
    expect(Math.abs((curve.at(-1)?.[0] ?? 0) - (curve[0]?.[0] ?? 0))).toBeCloseTo((PITCH / 2) * 10, 9);
    expect(Math.abs((curve.at(-1)?.[1] ?? 0) - (curve[0]?.[1] ?? 0))).toBeCloseTo(2 * 12.1 * 10, 9);
  }
  const left = helix(camera, { ...zone, hand: -1 }, { z: -3.3, r: 12.1 }, [0, 1]);
  expect((left.at(-1)?.[0] ?? 0) - (left[0]?.[0] ?? 0)).toBeCloseTo((-PITCH / 2) * 10, 9);
  const wall = helix(camera, { ...zone, isInside: true }, { z: -3.3, r: 12.1 }, [0, 0.5]);
  expect((wall.at(-1)?.[0] ?? 0) - (wall[0]?.[0] ?? 0)).toBeCloseTo((-PITCH / 4) * 10, 9);
});

test("each groove has two flanks that look opposite ways, and the edge of the body its teeth", () => {
  const [zone] = threadZones({ edges: grooves(4, -1.1, 13.2), corners: [] });
  if (!zone) return expect.fail();
  const { flanks, crests } = flanksOf(camera, zone, [0.5, 1]);
  expect(flanks.map((f) => f.looksRight)).toEqual(Array.from({ length: 4 }, () => [true, false]).flat());
  expect(crests).toHaveLength(8);
  const low = silhouette(camera, zone, 1).map(([, y]) => y);
  expect(Math.max(...low)).toBeCloseTo(200 + 132, 9);
  expect(low.filter((y) => y < 200 + 122)).toHaveLength(4);
});
