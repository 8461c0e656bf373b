import {
  BufferAttribute,
  BufferGeometry,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  Mesh,
  Sphere,
  Vector4,
} from "three";
import type { LineMaterial } from "three/addons/lines/LineMaterial.js";

/** Corners of a piece, from cap to cap, as the material expects them: across, along, and both again to round the caps. */
const CORNERS = [
  [2, 2],
  [1, 1],
  [0, -1],
  [-1, -2],
].flatMap(([along = 0, round = 0]) => [-1, 1].map((across) => [across, along, across, round]));
const TRIANGLES = [0, 2, 1, 2, 3, 1, 2, 4, 3, 4, 5, 3, 4, 6, 5, 6, 7, 5];
/** Numbers of a corner, by attributes: those above, the ends of its piece, and the distance along the line at both. */
const ATTRIBUTES = {
  position: 2,
  uv: 2,
  instanceStart: 3,
  instanceEnd: 3,
  instanceDistanceStart: 1,
  instanceDistanceEnd: 1,
} as const;
const [OWN, ENDS, ALL] = [4, 6, 12];

/** Indices of a piece. */
export const PIECE = TRIANGLES.length;

/**
 * Pieces of lines as triangles. `places`: x, y, z of both ends of each, mm. The library draws them as instances of one
 * shape, but without a graphics card each instance takes as long as a drawing of its own.
 */
export function piecesGeometry(places: Float32Array): BufferGeometry {
  const count = places.length / ENDS,
    numbers = new Float32Array(ALL * CORNERS.length * count),
    index = new Uint32Array(PIECE * count);
  for (let i = 0, to = 0, along = 0; i < count; i += 1) {
    const ends = places.subarray(ENDS * i, ENDS * (i + 1)),
      [x0 = 0, y0 = 0, z0 = 0, x1 = 0, y1 = 0, z1 = 0] = ends,
      far = along + Math.hypot(x1 - x0, y1 - y0, z1 - z0);
    for (const corner of CORNERS) {
      numbers.set(corner, to);
      numbers.set(ends, to + OWN);
      numbers[to + OWN + ENDS] = along;
      numbers[to + OWN + ENDS + 1] = far;
      to += ALL;
    }
    for (let k = 0; k < PIECE; k += 1) index[PIECE * i + k] = CORNERS.length * i + (TRIANGLES[k] ?? 0);
    along = far;
  }
  const buffer = new InterleavedBuffer(numbers, ALL),
    geometry = new BufferGeometry();
  let from = 0;
  for (const [name, size] of Object.entries(ATTRIBUTES)) {
    geometry.setAttribute(name, new InterleavedBufferAttribute(buffer, size, from));
    from += size;
  }
  geometry.setIndex(new BufferAttribute(index, 1));
  return geometry;
}

const SEEN = new Vector4(),
  EVERYWHERE = new Sphere();

/** Lines of a width in pixels. */
export function wideLines(geometry: BufferGeometry, material: LineMaterial): Mesh<BufferGeometry, LineMaterial> {
  const lines = new Mesh(geometry, material);
  lines.frustumCulled = false;
  geometry.boundingSphere = EVERYWHERE;
  lines.onBeforeRender = (renderer) => {
    renderer.getViewport(SEEN);
    material.resolution.set(SEEN.z, SEEN.w);
  };
  return lines;
}
