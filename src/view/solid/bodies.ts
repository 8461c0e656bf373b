import { areaOf } from "../../kernel/area/area.ts";
import { difference, intersection, offset, simplified, union, unpacked } from "../../kernel/area/clip.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import { SLIVER } from "../../kernel/tolerance.ts";
import { lessPlainCuts, machiningArea } from "../../sim/finished.ts";
import { madeOf } from "../../sim/made.ts";
import type { PlayPosition, SimulatedOperation, Simulation } from "../../sim/simulation.ts";

/** What of the stock is shown in which colour, as areas of the half plane that do not overlap. */
export interface ColouredBodies {
  readonly steel: readonly Ring[];
  /** What the operations should have taken and left. */
  readonly residual: readonly Ring[];
  /** The skin where something ran into the part or the stock. */
  readonly gouge: readonly Ring[];
}

/** How thick the skin of a gouge is, mm and as a share of the size of the part: enough to be seen in the section. */
const SKIN = { least: 0.1, share: 0.004 } as const;
/** Residual material is cut out so much wider, mm, that no skin of steel is left over it. */
const OVER = 0.02;
/** Outlines are shown with corners no farther than this from the true ones, mm. */
const SHOWN = 0.004;

/** The stock of a moment, divided by what is to be seen on it. Places of faults count from the move that made them. */
export function colouredBodies(
  stock: readonly Ring[],
  simulation: Simulation,
  position: PlayPosition,
  size: number,
): ColouredBodies {
  const { findings, proof, steps } = simulation;
  const rest = position.step >= steps.length ? proof.residual.map((each) => each.ring) : [];
  const faults = findings.filter(
    ({ step }) => step < position.step || (step === position.step && position.fraction > 0),
  );
  const plain = (rings: readonly Ring[]) => simplified(rings, SHOWN);
  if (rest.length === 0 && faults.length === 0) return { steel: plain(stock), residual: [], gouge: [] };
  const skin = Math.max(SKIN.least, SKIN.share * size);
  const [gouge, sound] = dividedBy(
    stock,
    faults.flatMap((f) => [...f.rings]),
    skin,
  );
  const [residual, steel] = dividedBy(sound, rest, OVER);
  return { steel: plain(steel), residual: plain(residual), gouge: plain(gouge) };
}

/**
 * What of the stock lies in areas made so much wider (mm), and the rest of it. Both are cut along the same line, which
 * runs on beyond the stock: were one taken off the other along the boundary of the stock, a skin without thickness
 * would be left over it.
 */
function dividedBy(
  stock: readonly Ring[],
  areas: readonly Ring[],
  wider: number,
): readonly [inside: readonly Ring[], rest: readonly Ring[]] {
  if (areas.length === 0) return [[], stock];
  const wide = offset(union(areas), wider);
  return [intersection(stock, wide), difference(stock, wide)];
}

/** Steps at which a run states another blank. */
export const statedSteps = ({ checkpoints }: Pick<Simulation, "checkpoints">): readonly number[] =>
  checkpoints.flatMap(({ isStated, step }) => (isStated ? [step] : []));

/**
 * The finished part as it should come off the machine: the blank less what the operations together take away, and less
 * what moves outside of them took. A blank that is stated later counts from its step on. Empty where there is no blank
 * or nothing takes anything away.
 */
export function finishedBody(simulation: Simulation, operations: readonly SimulatedOperation[]): readonly Ring[] {
  const { blank, last } = lastHeld(simulation, operations);
  if (blank.length === 0 || last.length === 0) return [];
  return lessPlainCuts(difference(blank, machiningArea(last)), simulation);
}

/**
 * The part of a program that states no contour: what its moves leave of the blank that is in the chuck at the end.
 * Empty where they take nothing away.
 */
export function leftBody(simulation: Simulation): readonly Ring[] {
  const { blank } = lastHeld(simulation, []);
  const made = madeOf(simulation);
  return areaOf(blank) - areaOf(made) > SLIVER ? made : [];
}

/** The blank that is in the chuck at the end, and what is done to it. */
function lastHeld(simulation: Simulation, operations: readonly SimulatedOperation[]) {
  const stated = simulation.checkpoints.findLast((mark) => mark.isStated),
    first = stated?.step ?? 0;
  const last = operations.filter((o) => o.firstStep >= first && o.plan.area.length > 2);
  return { last, blank: stated ? statedBlank(simulation, first) : simulation.blank };
}

/**
 * The blank less what all operations but threads take away: no thread of the finished part is in what lies beyond it.
 */
export function withoutThreads(simulation: Simulation, operations: readonly SimulatedOperation[]): readonly Ring[] {
  const { blank, last } = lastHeld(simulation, operations);
  return difference(blank, machiningArea(last.filter(({ plan }) => !plan.thread)));
}

function statedBlank({ checkpoints }: Simulation, step: number): readonly Ring[] {
  const mark = checkpoints.find((each) => each.isStated && each.step === step);
  return mark?.stock ? unpacked(mark.stock) : [];
}

/** Whether an area is more than dust of the polygon engine. */
export const isBody = (rings: readonly Ring[]): boolean => areaOf(rings) > SLIVER;
