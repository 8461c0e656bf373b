import { boxAround, gapBetween } from "../../kernel/area/box.ts";
import { difference, intersection, offset, union } from "../../kernel/area/clip.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import type { PlayPosition, Simulation } from "../../sim/simulation.ts";
import { colouredBodies, type ColouredBodies } from "./bodies.ts";
import { revolved, type Solid } from "./revolve.ts";
import type { RunThreads, ThreadedStock } from "./thread-cuts.ts";
import { threadedBody, type ThreadTurning } from "./threaded.ts";

/** A body of the work, with the role that decides its colour. */
export interface MomentBody {
  readonly role: keyof ColouredBodies;
  readonly solid: Solid;
}

/** The visible state of a moment. */
export interface Moment {
  readonly stock: readonly Ring[];
  /** Null until the program is verified: all is steel until then. */
  readonly simulation: Simulation | null;
  readonly threads: RunThreads | null;
  readonly position: PlayPosition;
  /** Size of the part, mm. */
  readonly size: number;
}

/** Coloured areas farther than this from all grooves, mm, lie in none of them. */
const APART = 0.05;

/** The steel of a moment with its threads, and the residual material between them; null if they can only be rings. */
function withThreads(
  all: ColouredBodies,
  { stock, base, cuts }: ThreadedStock & Pick<Moment, "stock">,
  coloured: (rings: readonly Ring[]) => ColouredBodies,
  turning: ThreadTurning,
) {
  const grooves = boxAround(difference(base, stock)),
    near = (ring: Ring) => gapBetween(boxAround([ring]), grooves) <= APART;
  // A gouge is a skin, and a groove would cut through it.
  if (all.gouge.some(near)) return null;
  const between = all.residual.filter(near),
    whole = coloured(base).steel;
  const body = threadedBody(
    union(all.steel, between),
    { base: union(whole, intersection(offset(between, GAP), base)), cuts },
    turning,
    between,
  );
  return body && { ...body, rest: all.residual.filter((ring) => !near(ring)) };
}
/** Residual material between grooves is widened by this to join their filling, mm. */
const GAP = 0.05;

/** The bodies of a moment, and facts about their threads to announce. */
export interface MomentBodies {
  readonly bodies: readonly MomentBody[];
  /** Some thread is drawn as rings, because it could not be made a helix. */
  readonly hasRings: boolean;
  /** Some thread is left-handed. */
  readonly hasLeft: boolean;
}

/** The bodies of a moment. */
export function bodiesAt({ stock, simulation, threads, position, size }: Moment, turning: ThreadTurning): MomentBodies {
  const coloured = (rings: readonly Ring[]): ColouredBodies =>
    simulation ? colouredBodies(rings, simulation, position, size) : { steel: rings, residual: [], gouge: [] };
  const all = coloured(stock),
    apart = threads?.of(stock, position) ?? null;
  const helices = apart && withThreads(all, { stock, ...apart }, coloured, turning);
  const { finish, ...plain } = turning,
    turned = (rings: readonly Ring[]) => revolved(rings, plain);
  const bodies: MomentBody[] = [
    { role: "steel", solid: helices?.plain ?? revolved(all.steel, turning) },
    {
      role: "residual",
      solid: turned(helices?.rest ?? all.residual),
    },
    { role: "gouge", solid: turned(all.gouge) },
  ];
  if (helices?.highlighted) bodies.push({ role: "residual", solid: helices.highlighted });
  return {
    bodies,
    hasRings: apart !== null && helices === null,
    hasLeft: apart?.cuts.some(({ hand }) => hand < 0) ?? false,
  };
}
