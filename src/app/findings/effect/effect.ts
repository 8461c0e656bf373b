import { cycleByNumber } from "../../../cycles/index.ts";
import { readText } from "../../../program/values/field.ts";
import { SETUP_FIELDS } from "../../../program/job/setup-fields.ts";
import type { Run } from "../../../program/state/run-types.ts";
import type { Outcome, Planned } from "../../calculation/outcome.ts";
import type { JobReading } from "../../document/reading.ts";

/** What a program does, in numbers. */
export interface Effect {
  /** Roughing passes of all operations. */
  readonly passes: number;
  /** Infeed as divided, mm: of the first operation. */
  readonly infeed: number;
  readonly seconds: number;
  /** mm² of the half plane; null where an operation makes no path, because what stays of it was not looked at. */
  readonly residual: number | null;
}

/** Smaller areas are rounding of the polygon engine, mm². */
export const NO_AREA = 0.005;
const area = (value: number) => (value < NO_AREA ? 0 : value);

const effects = new WeakMap<Outcome, Effect>();

/** What is known of a program from its run alone. */
const ofRun = (run: Run): Omit<Effect, "residual"> => ({
  passes: run.operations.reduce((sum, o) => sum + o.plan.passes, 0),
  infeed: run.operations[0]?.plan.infeed ?? 0,
  seconds: run.seconds,
});

export function effectOf(outcome: Outcome): Effect {
  const known = effects.get(outcome);
  if (known) return known;
  const { run, simulation } = outcome;
  const effect: Effect = {
    ...ofRun(run),
    residual: run.operations.some((o) => o.plan.moves.length === 0)
      ? null
      : area(simulation.proof.residual.reduce((sum, r) => sum + r.area, 0)),
  };
  effects.set(outcome, effect);
  return effect;
}

/**
 * The same of what is only planned: what stayed before stands until the new proof is there; null where nothing was
 * proved yet.
 */
export function effectNow(made: Outcome | Planned, proved: Outcome | null): Effect {
  if (made.simulation) return effectOf(made);
  return { ...ofRun(made.run), residual: proved && effectOf(proved).residual };
}

/** What is cut at once, mm: a plunge is as wide as its tool and goes down by the feed, whatever its bites are. */
export function cutAtOnce({ run }: Pick<Outcome, "run">): number {
  const call = run.operations[0];
  const plunges = call && cycleByNumber(call.cycle)?.group === "recessing";
  return plunges ? (call.tool.CUTWIDTH ?? 0) : (call?.plan.infeed ?? 0);
}

/** What is cut at once times roughing feed per revolution, mm²; null where the feed per revolution is not known. */
export function chipArea({ job, cycle, reading }: JobReading, atOnce: number): number | null {
  const roughing = Object.entries(cycle.params).find(([, p]) => p.text === "roughingFeed")?.[0];
  const feed = roughing === undefined ? undefined : reading.perField[roughing]?.value;
  if (typeof feed !== "number") return null;
  if (job.perRevolution) return atOnce * feed;
  const speed = job.spindle.mode === "constant" ? readText(SETUP_FIELDS.speed, job.spindle.speed).value : null;
  return speed === null ? null : (atOnce * feed) / speed;
}
