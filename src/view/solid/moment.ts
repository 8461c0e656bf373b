import { boxAround, gapBetween } from "../../kernel/box.ts";
import { difference } from "../../kernel/clip.ts";
import type { Ring } from "../../kernel/point.ts";
import type { PlayPosition, Simulation } from "../../sim/simulation.ts";
import { colouredBodies, type ColouredBodies } from "./bodies.ts";
import { revolved, type Solid } from "./revolve.ts";
import type { RunThreads, ThreadedStock } from "./thread-cuts.ts";
import { threaded, type ThreadTurning } from "./threaded.ts";

/** A body of the work by what it is made of, which decides its colour. */
export interface MomentBody {
  readonly role: keyof ColouredBodies;
  readonly solid: Solid;
}

/** What is to be seen of a moment. */
export interface Moment {
  readonly stock: readonly Ring[];
  /** Null as long as nothing is proved: all is steel then. */
  readonly simulation: Simulation | null;
  readonly threads: RunThreads | null;
  readonly position: PlayPosition;
  /** Size of the part, mm. */
  readonly size: number;
}

/** What is told by colour lies in no groove when it is farther from all of them, mm. */
const APART = 0.05;

/** Whether grooves lie where nothing is told by colour: what is left or hurt in a thread is told on rings. */
function isPlain({ residual, gouge }: ColouredBodies, stock: readonly Ring[], { base }: ThreadedStock): boolean {
  const told = [...residual, ...gouge];
  if (told.length === 0) return true;
  const grooves = boxAround(difference(base, stock));
  return told.every((ring) => gapBetween(boxAround([ring]), grooves) > APART);
}

/** The bodies of a moment; `hasRings`: a thread in them is rings, because it could not be made a helix. */
export function bodiesAt(
  { stock, simulation, threads, position, size }: Moment,
  threading: ThreadTurning,
): { readonly bodies: readonly MomentBody[]; readonly hasRings: boolean } {
  const coloured = (rings: readonly Ring[]): ColouredBodies =>
    simulation ? colouredBodies(rings, simulation, position, size) : { steel: rings, residual: [], gouge: [] };
  const all = coloured(stock), apart = threads?.of(stock, position) ?? null;
  const helices = apart && isPlain(all, stock, apart)
    ? threaded(all.steel, { ...apart, base: coloured(apart.base).steel }, threading)
    : null;
  const turned = (rings: readonly Ring[]) => revolved(rings, threading);
  return {
    bodies: [{ role: "steel", solid: helices ?? turned(all.steel) }, { role: "residual", solid: turned(all.residual) }, {
      role: "gouge",
      solid: turned(all.gouge),
    }],
    hasRings: apart !== null && helices === null,
  };
}
