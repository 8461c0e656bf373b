import { SAME } from "../../kernel/tolerance.ts";
import type { encodedLook } from "./finish.ts";
import type { Mesh } from "./mesh.ts";
import { spanOf, type directionsOf, type Turning } from "./revolve.ts";

/** A strip between two rows, each with its own direction: place and radius of both at each column. */
export interface Strip {
  readonly z: readonly [Float64Array, Float64Array];
  readonly r: readonly [Float64Array, Float64Array];
  /** Directions out of the material at both rows (z, r), for where the strip has no width; null: always its own. */
  readonly smooth: readonly [readonly [number, number], readonly [number, number]] | null;
  /** The encoded look at both rows. */
  readonly looks: readonly [ReturnType<typeof encodedLook>, ReturnType<typeof encodedLook>];
}

/** Strips as a surface; the same places have the same coordinates to the bit. */
export function stripMesh(
  strips: readonly Strip[],
  turning: Turning,
  directions: ReturnType<typeof directionsOf>,
): Mesh {
  const { first, count } = spanOf(turning),
    rows = count + 1,
    { chords } = turning;
  const positions = new Float32Array(6 * strips.length * rows),
    normals = new Float32Array(positions.length);
  const index = new Uint32Array(6 * strips.length * count),
    looks = turning.finish && new Float32Array(4 * strips.length * rows);
  let [place, n] = [0, 0];
  const equal = (a: number, b: number) => [0, 1, 2].every((k) => positions[3 * a + k] === positions[3 * b + k]);
  for (const {
    z,
    r,
    smooth,
    looks: [look, end],
  } of strips) {
    const begin = place / 3;
    let [nz, nr] = [0, 1];
    const own = (column: number) => {
      const [dz, dr] = [(z[1][column] ?? 0) - (z[0][column] ?? 0), (r[1][column] ?? 0) - (r[0][column] ?? 0)],
        long = Math.hypot(dz, dr);
      if (long > SAME) [nz, nr] = [dr / long, -dz / long];
    };
    // A strip that begins without width takes the direction of its first width.
    if (!smooth) {
      for (let column = first + count; column >= first; column -= 1) own(column);
    }
    for (const k of [0, 1] as const) {
      for (let row = 0; row < rows; row += 1) {
        const column = first + row,
          [x, y] = directions[column % chords] ?? [1, 0],
          radius = Math.fround(r[k][column] ?? 0);
        if (smooth) [nz, nr] = smooth[k];
        else own(column);
        looks?.set(k === 0 ? look : end, (2 * place) / 3);
        positions[place] = radius * x + 0;
        normals[place++] = nr * x;
        positions[place] = radius * y + 0;
        normals[place++] = nr * y;
        positions[place] = (z[k][column] ?? 0) + 0;
        normals[place++] = nz;
      }
    }
    for (let row = 0; row < count; row += 1) {
      const p = begin + row,
        q = p + rows,
        far = q + 1,
        over = p + 1;
      // Where rows end at one place, and on the axis, a triangle may be empty.
      if (!equal(p, q) && !equal(q, far) && !equal(p, far)) {
        index[n++] = p;
        index[n++] = q;
        index[n++] = far;
      }
      if (!equal(p, far) && !equal(far, over) && !equal(p, over)) {
        index[n++] = p;
        index[n++] = far;
        index[n++] = over;
      }
    }
  }
  const mesh = { positions, normals, index: index.slice(0, n) };
  return looks ? { ...mesh, looks } : mesh;
}
