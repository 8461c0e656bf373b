import { areaOf } from "../../kernel/area/area.ts";
import { difference, intersection, offset, simplified, union, unpacked } from "../../kernel/area/clip.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import { SLIVER } from "../../kernel/tolerance.ts";
import { lessPlainCuts, machiningArea } from "../../sim/finished.ts";
import { producedParts } from "../../sim/produced-parts.ts";
import type { PlayPosition, SimulatedOperation, Simulation } from "../../sim/simulation.ts";

/** The stock by colour, as areas of the half plane that do not overlap. */
export interface ColouredBodies {
  readonly steel: readonly Ring[];
  /** Material that the operations should have removed. */
  readonly residual: readonly Ring[];
  /** The skin where the part or the stock was damaged. */
  readonly gouge: readonly Ring[];
}

/** How thick the skin of a gouge is, mm and as a share of the size of the part: enough to be seen in the section. */
const SKIN = { least: 0.1, share: 0.004 } as const;
/** Residual material is cut out wider by this, mm, so that no skin of steel covers it. */
const OVER = 0.02;
/** Outlines are shown with corners no farther than this from the true ones, mm. */
const SHOWN = 0.004;

/** The stock of a moment, divided by colour. Faults count from the move that caused them. */
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
 * The stock inside and outside of areas that are widened by so many mm. Both are cut along the same line, which
 * continues beyond the stock: subtracting along the boundary of the stock would leave a skin without thickness.
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
 * The finished part as it should come off the machine: the blank less everything that the operations, and the moves
 * outside of them, remove. A later stated blank counts from its step on. Empty without a blank, or if nothing is
 * removed.
 */
export function finishedBody(simulation: Simulation, operations: readonly SimulatedOperation[]): readonly Ring[] {
  const { blank, last } = lastHeld(simulation, operations);
  if (blank.length === 0 || last.length === 0) return [];
  return lessPlainCuts(difference(blank, machiningArea(last)), simulation);
}

/**
 * The part of a program without a contour: what its moves leave of the last blank in the chuck. Empty if they remove
 * nothing.
 */
export function leftBody(simulation: Simulation): readonly Ring[] {
  const { blank } = lastHeld(simulation, []);
  const made = producedParts(simulation);
  return areaOf(blank) - areaOf(made) > SLIVER ? made : [];
}

/** The last blank in the chuck, and its machining. */
function lastHeld(simulation: Simulation, operations: readonly SimulatedOperation[]) {
  const stated = simulation.checkpoints.findLast((mark) => mark.isStated),
    first = stated?.step ?? 0;
  const last = operations.filter((o) => o.firstStep >= first && o.plan.area.length > 2);
  return { last, blank: stated ? statedBlank(simulation, first) : simulation.blank };
}

/** The blank less what all operations except threads remove: no thread of the finished part lies outside of it. */
export function withoutThreads(simulation: Simulation, operations: readonly SimulatedOperation[]): readonly Ring[] {
  const { blank, last } = lastHeld(simulation, operations);
  return difference(blank, machiningArea(last.filter(({ plan }) => !plan.thread)));
}

function statedBlank({ checkpoints }: Simulation, step: number): readonly Ring[] {
  const mark = checkpoints.find((each) => each.isStated && each.step === step);
  return mark?.stock ? unpacked(mark.stock) : [];
}

/** Whether an area is more than the rounding slivers of the polygon engine. */
export const isBody = (rings: readonly Ring[]): boolean => areaOf(rings) > SLIVER;
