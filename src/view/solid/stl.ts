import type { Mesh } from "./mesh.ts";

/** Bytes of the header of a file, and of a triangle. */
const HEAD = 80;
const EACH = 50;

/**
 * A closed surface as a binary STL file: mm, Z along the spindle, X up; its triangles in sequence, each with its
 * normal. The header has the name, other than printable ASCII replaced. Format: the facets of the original
 * StereoLithography interface.
 */
export function stlOf({ positions, index }: Mesh, name: string): Uint8Array<ArrayBuffer> {
  const count = index.length / 3;
  const bytes = new Uint8Array(HEAD + 4 + EACH * count),
    view = new DataView(bytes.buffer);
  // A header that begins with "solid" would be taken for the ASCII form.
  const head = `binary STL, mm, Z along the spindle: ${name}`.replace(/[^\x20-\x7e]/g, "_").slice(0, HEAD);
  for (let i = 0; i < head.length; i += 1) bytes[i] = head.charCodeAt(i);
  view.setUint32(HEAD, count, true);
  for (let t = 0; t < count; t += 1) {
    const corners = [0, 1, 2].map((k) => {
      const at = 3 * (index[3 * t + k] ?? 0);
      return [positions[at] ?? 0, positions[at + 1] ?? 0, positions[at + 2] ?? 0] as const;
    });
    const [a, b, c] = corners as [
      readonly [number, number, number],
      readonly [number, number, number],
      readonly [number, number, number],
    ];
    const [ux, uy, uz] = [b[0] - a[0], b[1] - a[1], b[2] - a[2]],
      [vx, vy, vz] = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
    const normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx] as const;
    const long = Math.hypot(...normal) || 1;
    const start = HEAD + 4 + EACH * t;
    [...normal.map((n) => n / long), ...a, ...b, ...c].forEach((n, k) => view.setFloat32(start + 4 * k, n, true));
  }
  return bytes;
}
