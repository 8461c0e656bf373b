import { areaOfRing } from "../../kernel/area/area.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import { trianglesOf } from "./fill.ts";
import { MeshBuilder, type Mesh } from "./mesh.ts";

/** A plate: an outline of the half plane extruded square to it, from `back` to `front` (mm towards the operator). */
export function extruded(outline: Ring, back: number, front: number): Mesh {
  const ring = areaOfRing(outline) < 0 ? [...outline].reverse() : outline;
  const build = new MeshBuilder(),
    triangles = trianglesOf([ring]);
  for (const [y, side] of [
    [front, 1],
    [back, -1],
  ] as const) {
    const corners = ring.map((p) => build.corner(p.r, y, p.z, 0, side, 0));
    for (let i = 0; i < triangles.length; i += 3) {
      const [a = 0, b = 0, c = 0] = [0, 1, 2].map((k) => corners[triangles[i + k] ?? 0]);
      if (side > 0) build.triangle(a, b, c);
      else build.triangle(a, c, b);
    }
  }
  ring.forEach((p, i) => {
    const q = ring[(i + 1) % ring.length] ?? p;
    const [dz, dr] = [q.z - p.z, q.r - p.r],
      long = Math.hypot(dz, dr);
    if (long === 0) return;
    const [nz, nr] = [dr / long, -dz / long];
    const [a, b, c, d] = [
      build.corner(p.r, front, p.z, nr, 0, nz),
      build.corner(p.r, back, p.z, nr, 0, nz),
      build.corner(q.r, back, q.z, nr, 0, nz),
      build.corner(q.r, front, q.z, nr, 0, nz),
    ];
    build.triangle(a, b, c);
    build.triangle(a, c, d);
  });
  return build.mesh();
}

/** Edges of a plate as lines: both outlines, and where its sides meet. */
export function plateEdges(outline: Ring, back: number, front: number): Float32Array {
  const out: number[] = [];
  outline.forEach((p, i) => {
    const q = outline[(i + 1) % outline.length] ?? p;
    for (const y of [back, front]) out.push(p.r, y, p.z, q.r, y, q.z);
  });
  return Float32Array.from(out);
}
