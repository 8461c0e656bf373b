import { simplified } from "../../kernel/area/clip.ts";
import { boxAround, type Cuboid } from "../../kernel/area/box.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import { CHORD } from "../../kernel/tolerance.ts";
import { cuboidMesh } from "./cuboid.ts";
import { volumeOf, type Mesh } from "./mesh.ts";
import type { ThreadedStock } from "./thread-cuts.ts";
import { THREAD_FINENESS, threaded } from "./threaded.ts";
import { chordsFor, revolved, wholeMesh } from "./revolve.ts";
import { stlOf } from "./stl.ts";

/** Fewest chords of a full turn in a file: a prism with so many sides lacks less than a thousandth of its cylinder. */
const LEAST_CHORDS = 96;

/** A body to export. */
export interface WrittenBody {
  readonly rings: readonly Ring[];
  /** The same body with its threads taken out; null if it has none. */
  readonly threads: ThreadedStock | null;
}

/**
 * A body for export: its closed surface, within SOLID_CHORD of the true one. `hasRings`: threads are rings, because
 * they could not be made helices.
 */
export function bodyMesh({ rings, threads }: WrittenBody): { readonly mesh: Mesh; readonly hasRings: boolean } {
  const plain = simplified(rings, CHORD),
    chords = Math.max(LEAST_CHORDS, chordsFor(boxAround(plain).high)),
    quarterCut = false;
  const helices =
    threads &&
    threaded(
      plain,
      { ...threads, base: simplified(threads.base, CHORD) },
      {
        chords,
        quarterCut,
        hand: 1,
        ...THREAD_FINENESS.file,
      },
    );
  return {
    mesh: wholeMesh(helices ?? revolved(plain, { chords, quarterCut })),
    hasRings: threads !== null && !helices,
  };
}

/** A body, or the block of a milled one, as a binary STL file with its volume, cm³. */
export function bodyStl(body: WrittenBody | { readonly block: Cuboid }, name: string) {
  const { mesh, hasRings } = "block" in body ? { mesh: cuboidMesh(body.block), hasRings: false } : bodyMesh(body);
  return { bytes: stlOf(mesh, name), volume: volumeOf(mesh) / 1000, hasRings };
}
