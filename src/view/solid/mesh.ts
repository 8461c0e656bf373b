/**
 * Triangles of a closed surface in space, mm. The axes are those of the machine: x along X as a radius, y towards the
 * operator, z along the spindle. Triangles run counter-clockwise seen from outside.
 */
export interface Mesh {
  /** x, y, z of each corner. */
  readonly positions: Float32Array;
  /** Direction out of the body at each corner, length 1. */
  readonly normals: Float32Array;
  /** Three corners for each triangle. */
  readonly index: Uint32Array;
  /** The look at each corner, if known: the two numbers of `encodedLook`, or 0. */
  readonly looks?: Float32Array;
}

export const NO_MESH: Mesh = { positions: new Float32Array(), normals: new Float32Array(), index: new Uint32Array() };

/** Several surfaces as one. */
export function joinedMeshes(meshes: readonly Mesh[]): Mesh {
  const total = (pick: (m: Mesh) => number) => meshes.reduce((sum, m) => sum + pick(m), 0);
  const positions = new Float32Array(total((m) => m.positions.length)),
    normals = new Float32Array(positions.length);
  const index = new Uint32Array(total((m) => m.index.length));
  const looks = meshes.some((m) => m.looks) ? new Float32Array((2 * positions.length) / 3) : null;
  let [corner, place] = [0, 0];
  for (const m of meshes) {
    positions.set(m.positions, corner);
    normals.set(m.normals, corner);
    if (m.looks) looks?.set(m.looks, (2 * corner) / 3);
    const first = corner / 3;
    for (let i = 0; i < m.index.length; i += 1) index[place + i] = (m.index[i] ?? 0) + first;
    corner += m.positions.length;
    place += m.index.length;
  }
  return looks ? { positions, normals, index, looks } : { positions, normals, index };
}

/** The volume of a closed surface, mm³: positive if its triangles face outwards. */
export function volumeOf({ positions: p, index }: Mesh): number {
  let sum = 0;
  for (let i = 0; i < index.length; i += 3) {
    const [a, b, c] = [3 * (index[i] ?? 0), 3 * (index[i + 1] ?? 0), 3 * (index[i + 2] ?? 0)];
    const [ax = 0, ay = 0, az = 0] = [p[a], p[a + 1], p[a + 2]];
    const [bx = 0, by = 0, bz = 0] = [p[b], p[b + 1], p[b + 2]];
    const [cx = 0, cy = 0, cz = 0] = [p[c], p[c + 1], p[c + 2]];
    sum += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
  }
  return sum / 6;
}

/** A surface that grows corner by corner. */
export class MeshBuilder {
  private readonly positions: number[] = [];
  private readonly normals: number[] = [];
  private readonly index: number[] = [];

  /**
   * A corner with its direction outwards; returns its number. Zero is never negative, so that equal corners are equal
   * to the bit.
   */
  corner(x: number, y: number, z: number, nx: number, ny: number, nz: number): number {
    this.positions.push(x + 0, y + 0, z + 0);
    this.normals.push(nx, ny, nz);
    return this.positions.length / 3 - 1;
  }

  triangle(a: number, b: number, c: number): void {
    this.index.push(a, b, c);
  }

  mesh(): Mesh {
    return {
      positions: Float32Array.from(this.positions),
      normals: Float32Array.from(this.normals),
      index: Uint32Array.from(this.index),
    };
  }
}
