import type { Move } from "../../kernel/plan/move.ts";
import type { Step } from "../../kernel/time/step.ts";
import { cuttingSpeedAt, speedAt } from "../../kernel/time/time.ts";
import { toDiameter } from "../../kernel/units.ts";
import { programIssue, type ProgramIssue } from "./issue.ts";
import type { Modal } from "./modal.ts";

/**
 * Highest cutting speed of any turned material, m/min: 0.8 km/min, the highest of makers' tables for aluminium, rounded
 * up.
 */
const FASTEST_CUT = 0.8 * 1000;
/** Speed limit without machine data, rpm: few lathes with a chuck turn faster. */
const FASTEST_SPINDLE = 5000;

const cuts = ({ move }: Step): boolean => move.kind === "feed" || move.kind === "arc";

/** Smallest distance of a move's ends from the axis, mm: 0 where it crosses the axis. */
const nearestOf = ({ from, move }: Step) =>
  from.r * move.to.r <= 0 && (from.r !== 0 || move.to.r !== 0) ? 0 : Math.min(Math.abs(from.r), Math.abs(move.to.r));

const farthestOf = ({ from, move }: { readonly from: Step["from"]; readonly move: Move }) =>
  Math.max(Math.abs(from.r), Math.abs(move.to.r));

/**
 * Speed faults of motions, each for its SPIN block. `most`: highest speed of the machine, rpm; without it only speeds
 * beyond any machine are reported.
 */
export function speedFaults({ spindle }: Modal, steps: readonly Step[], most: number | undefined): ProgramIssue[] {
  const cutting = spindle ? steps.filter(cuts) : [];
  const [first] = cutting;
  if (!spindle || !first) return [];
  const unlikely = (speed: number, limit: number, of: "material" | "machine", at: string) =>
    programIssue("speedUnlikely", "warning", { speed, most: limit, of }, at);
  const found: ProgramIssue[] = [];
  if (spindle.kind === "constant") {
    const { speed } = spindle;
    if (most !== undefined && speed > most) found.push(unlikely(speed, most, "machine", "S"));
    // Plain feed moves may run outside the material.
    const surface = cutting.reduce(
      (best, s) => (s.operation === null ? best : Math.max(best, cuttingSpeedAt(speed, farthestOf(s)))),
      0,
    );
    if (surface > FASTEST_CUT) found.push(unlikely(surface, FASTEST_CUT, "material", "S"));
    return found;
  }
  const { cuttingSpeed, limit } = spindle;
  if (cuttingSpeed > FASTEST_CUT) found.push(unlikely(cuttingSpeed, FASTEST_CUT, "material", "VC"));
  if (most !== undefined && limit > most) found.push(unlikely(limit, most, "machine", "SMAX"));
  if (limit > 0) return found;
  const near = cutting.reduce((best, s) => (nearestOf(s) < nearestOf(best) ? s : best), first);
  if (speedAt(spindle, nearestOf(near)) > (most ?? FASTEST_SPINDLE)) {
    const nearest = Math.abs(near.from.r) < Math.abs(near.move.to.r) ? near.from.r : near.move.to.r;
    found.push(
      programIssue(
        "speedUnlimited",
        "warning",
        { diameter: nearestOf(near) === 0 ? 0 : Math.abs(toDiameter(nearest)), block: near.block },
        "SMAX",
      ),
    );
  }
  return found;
}
