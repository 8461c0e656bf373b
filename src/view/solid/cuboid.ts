import type { Cuboid } from "../../kernel/area/box.ts";
import { MeshBuilder, type Mesh } from "./mesh.ts";

/**
 * The faces of a block by their corners, counter-clockwise seen from outside: bits of a corner are right, high, top.
 */
const FACES = [
  [0, 2, 3, 1],
  [4, 5, 7, 6],
  [0, 1, 5, 4],
  [2, 6, 7, 3],
  [0, 4, 6, 2],
  [1, 3, 7, 5],
] as const;

/** A block as a closed surface, in X, Y and Z. */
export function cuboidMesh({ left, right, low, high, bottom, top }: Cuboid): Mesh {
  const made = new MeshBuilder(),
    long = Math.sqrt(3);
  for (let i = 0; i < 8; i += 1) {
    const [x, y, z] = [i & 1, i & 2, i & 4].map((bit) => (bit ? 1 : -1) / long) as [number, number, number];
    made.corner(x > 0 ? right : left, y > 0 ? high : low, z > 0 ? top : bottom, x, y, z);
  }
  for (const [a, b, c, d] of FACES) {
    made.triangle(a, b, c);
    made.triangle(a, c, d);
  }
  return made.mesh();
}
