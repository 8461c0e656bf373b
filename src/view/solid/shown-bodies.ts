import type { Ring } from "../../kernel/geometry/point.ts";
import type { PlayPosition, Simulation } from "../../sim/simulation.ts";
import type { Surfaces, Texture } from "../material/surfaces.ts";
import { stockLooksOf } from "./finish.ts";
import { bodiesAt, type MomentBody } from "./moment.ts";
import type { RunThreads } from "./thread-cuts.ts";
import type { ThreadTurning } from "./threaded.ts";
import type { TonedSide } from "./tones.ts";

/** The data from which the bodies of a run are built. */
export interface TurnedRun {
  /** Null until the program is verified: all is steel until then. */
  readonly simulation: Simulation | null;
  readonly threads: RunThreads | null;
  readonly surfaces: Surfaces;
}

/** A request for bodies: the moment, and the view settings. */
export interface BodiesRequest {
  readonly position: PlayPosition;
  /** Size of the part, mm. */
  readonly size: number;
  readonly turning: Omit<ThreadTurning, "finish">;
  /** Tones of surfaces, visible where the surfaces are final. */
  readonly tones?: readonly TonedSide[];
}

/** Facts to announce about the shown bodies. */
export interface SolidNotes {
  /** Threads are drawn as rings, because they cannot be drawn as helices. */
  readonly hasRings: boolean;
  readonly leftHanded: boolean;
  readonly textures: readonly Texture[];
  /** The roles visible in a colour of their own. */
  readonly highlighted: readonly HighlightRole[];
}

/** A role with a colour of its own: residual material, or damage to the part or the stock. */
export type HighlightRole = Exclude<MomentBody["role"], "steel">;
const MARKED = ["residual", "gouge"] as const satisfies readonly HighlightRole[];

const isSeen = ({ solid }: MomentBody) => solid.surface.index.length > 0;

/** The bodies of a moment, ready to be drawn, with the facts to announce. */
export interface ShownBodies {
  readonly bodies: readonly MomentBody[];
  readonly notes: SolidNotes;
}

/** Builds the visible bodies of a stock, both on the page and in the worker. */
export function shownBodies(
  stock: readonly Ring[],
  { simulation, threads, surfaces }: TurnedRun,
  { position, size, turning, tones }: BodiesRequest,
): ShownBodies {
  const finish = stockLooksOf(stock, surfaces, position, tones);
  const { bodies, hasRings, hasLeft } = bodiesAt(
    { stock, simulation, threads, position, size },
    { ...turning, finish },
  );
  const highlighted = MARKED.filter((role) => bodies.some((body) => body.role === role && isSeen(body)));
  return { bodies, notes: { hasRings: hasRings, leftHanded: hasLeft, textures: finish.textures, highlighted } };
}

/** Buffers that can be transferred from one thread to the other without a copy. */
export const buffersOf = ({ bodies }: ShownBodies): ArrayBuffer[] => [
  ...new Set(
    bodies.flatMap(({ solid: { surface, section, edges } }) =>
      [
        edges,
        ...[surface, section].flatMap(({ positions, normals, index, looks }) => [
          positions,
          normals,
          index,
          ...(looks ? [looks] : []),
        ]),
      ].flatMap(({ buffer, byteLength }) => (byteLength > 0 && buffer instanceof ArrayBuffer ? [buffer] : [])),
    ),
  ),
];
