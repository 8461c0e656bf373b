import type { Spindle } from "../../kernel/time/step.ts";
import { speedAt } from "../../kernel/time/time.ts";
import { diameter, toRadius } from "../../kernel/units.ts";
import { powerAt } from "../../program/machine/machine-data.ts";
import { leastOf, reasoned, typedDown, type ReasonedNumber } from "./formulas.ts";
import type { ValuesRequest } from "./values-request.ts";

/** Speed limit of a machine that states none, rpm. */
const ASSUMED_LIMIT = 2500;
/** Grids of typed values: depth, feed, cutting speed, rpm. */
export const GRID = { depth: 0.05, feed: 0.01, speed: 1, rpm: 10 } as const;

/** Cutting speed held constant down to the speed limit of the machine. */
export function constantSurface(request: ValuesRequest, wanted: ReasonedNumber) {
  const speed = typedDown(wanted, GRID.speed);
  const most = request.machine?.most;
  const limit =
    most === undefined
      ? reasoned(ASSUMED_LIMIT, "rpmAssumed", "machine", { n: ASSUMED_LIMIT })
      : reasoned(most, "rpmOfMachine", "machine", { n: most });
  const spindle: Spindle = { kind: "surface", cuttingSpeed: speed.value, limit: limit.value };
  return { speed, limit, spindle };
}

/** A constant speed from a cutting speed at a diameter, within the machine. */
export function constantSpindle(
  { machine }: ValuesRequest,
  vc: number,
  across: number,
  other: ReasonedNumber | null = null,
) {
  const d = Math.max(across, 1);
  const most = machine?.most ?? ASSUMED_LIMIT;
  const wanted = leastOf(
    reasoned((1000 * vc) / (Math.PI * d), "rpmOfSpeed", "material", { vc, d }),
    reasoned(most, machine ? "rpmOfMachine" : "rpmAssumed", "machine", { n: most }),
    other,
  );
  const speed = typedDown(wanted, GRID.rpm);
  return { speed, limit: null, spindle: { kind: "constant", speed: speed.value } satisfies Spindle };
}

/** Power at the slowest speed of the cut, kW. */
export function powerFor({ machine, power, largest }: ValuesRequest, spindle: Spindle): number {
  const slowest = speedAt(spindle, toRadius(diameter(largest)));
  return (machine && Number.isFinite(slowest) ? powerAt(machine, slowest) : null) ?? power;
}

/** The cutting speed of the material by a share. */
export const shareOfSpeed = ({ material }: ValuesRequest, s: number): ReasonedNumber =>
  reasoned(material.roughSpeed * s, "speedOfShare", "material", { s, vc: material.roughSpeed });
