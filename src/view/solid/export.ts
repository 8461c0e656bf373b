import { simplified } from "../../kernel/clip.ts";
import { boxAround } from "../../kernel/box.ts";
import type { Ring } from "../../kernel/point.ts";
import { CHORD } from "../../kernel/tolerance.ts";
import { volumeOf, type Mesh } from "./mesh.ts";
import { chordsFor, revolved, wholeMesh } from "./revolve.ts";
import { stlOf } from "./stl.ts";

/** Fewest chords of a full turn in a file: a prism with so many sides lacks less than a thousandth of its cylinder. */
const LEAST_CHORDS = 96;

/** A body as it is written: its surface within SOLID_CHORD of the true one, closed. */
export function bodyMesh(rings: readonly Ring[]): Mesh {
  const plain = simplified(rings, CHORD);
  return wholeMesh(revolved(plain, { chords: Math.max(LEAST_CHORDS, chordsFor(boxAround(plain).high)), quarterCut: false }));
}

/** A body as a binary STL file with its volume, cm³. */
export function bodyStl(rings: readonly Ring[], name: string): { readonly bytes: Uint8Array<ArrayBuffer>; readonly volume: number } {
  const mesh = bodyMesh(rings);
  return { bytes: stlOf(mesh, name), volume: volumeOf(mesh) / 1000 };
}
