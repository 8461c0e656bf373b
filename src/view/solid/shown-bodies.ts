import type { Ring } from "../../kernel/geometry/point.ts";
import type { PlayPosition, Simulation } from "../../sim/simulation.ts";
import type { Surfaces, Texture } from "../material/surfaces.ts";
import { finishOf } from "./finish.ts";
import { bodiesAt, type MomentBody } from "./moment.ts";
import type { RunThreads } from "./thread-cuts.ts";
import type { ThreadTurning } from "./threaded.ts";
import type { TonedSide } from "./tones.ts";

/** What bodies of a run are made from. */
export interface TurnedRun {
  /** Null as long as nothing is proved: all is steel then. */
  readonly simulation: Simulation | null;
  readonly threads: RunThreads | null;
  readonly surfaces: Surfaces;
}

/** What is asked for: a moment, and how it is to be seen. */
export interface BodiesAsked {
  readonly position: PlayPosition;
  /** Size of the part, mm. */
  readonly size: number;
  readonly turning: Omit<ThreadTurning, "finish">;
  /** What is told of surfaces by tones; it is seen where they are as they will stay. */
  readonly tones?: readonly TonedSide[];
}

/** What is to be said of what is seen. */
export interface SolidTold {
  /** Threads are drawn as rings, because they cannot be drawn as helices. */
  readonly rings: boolean;
  readonly leftHanded: boolean;
  readonly textures: readonly Texture[];
  /** What is told apart from steel by its colour. */
  readonly marked: readonly ToldRole[];
}

/** What a colour of its own stands for: what stayed, and where something ran into part or stock. */
export type ToldRole = Exclude<MomentBody["role"], "steel">;
const MARKED = ["residual", "gouge"] as const satisfies readonly ToldRole[];

const isSeen = ({ solid }: MomentBody) => solid.surface.index.length > 0;

/** The bodies of a moment, ready to be drawn, with what is to be said of them. */
export interface ShownBodies {
  readonly bodies: readonly MomentBody[];
  readonly told: SolidTold;
}

/** What is to be seen of a stock. The one place that makes it, on the page as in the worker. */
export function shownBodies(
  stock: readonly Ring[],
  { simulation, threads, surfaces }: TurnedRun,
  { position, size, turning, tones }: BodiesAsked,
): ShownBodies {
  const finish = finishOf(stock, surfaces, position, tones);
  const { bodies, hasRings, hasLeft } = bodiesAt(
    { stock, simulation, threads, position, size },
    { ...turning, finish },
  );
  const marked = MARKED.filter((role) => bodies.some((body) => body.role === role && isSeen(body)));
  return { bodies, told: { rings: hasRings, leftHanded: hasLeft, textures: finish.textures, marked } };
}

/** What can be handed from one thread to the other without a copy. */
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
