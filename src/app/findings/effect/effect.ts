import { cycleByNumber } from "../../../cycles/index.ts";
import { readText } from "../../../program/values/field.ts";
import { SETUP_FIELDS } from "../../../program/job/setup-fields.ts";
import type { Run } from "../../../program/state/run-types.ts";
import type { Outcome, Planned } from "../../calculation/outcome.ts";
import type { JobReading } from "../../document/reading.ts";

/** The effect of a program in numbers. */
export interface Effect {
  /** Roughing passes of all operations. */
  readonly passes: number;
  /** Actual infeed of the first operation, mm. */
  readonly infeed: number;
  readonly seconds: number;
  /** Residual material in the half plane, mm²; null if an operation makes no path and was not checked. */
  readonly residual: number | null;
}

/** Smaller areas are rounding of the polygon engine, mm². */
export const NO_AREA = 0.005;
const area = (value: number) => (value < NO_AREA ? 0 : value);

const effects = new WeakMap<Outcome, Effect>();

/** The numbers that a run alone gives. */
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
 * The same for a planned run: the previous residual material stays until the new check is done; null before the first
 * check.
 */
export function effectNow(made: Outcome | Planned, proved: Outcome | null): Effect {
  if (made.simulation) return effectOf(made);
  return { ...ofRun(made.run), residual: proved && effectOf(proved).residual };
}

/** Depth of cut, mm: the infeed, for a plunge the tool width (its chip thickness is the feed, whatever its infeeds). */
export function cutAtOnce({ run }: Pick<Outcome, "run">): number {
  const call = run.operations[0];
  const plunges = call && cycleByNumber(call.cycle)?.group === "recessing";
  return plunges ? (call.tool.CUTWIDTH ?? 0) : (call?.plan.infeed ?? 0);
}

/** Depth of cut times roughing feed per revolution, mm²; null if the feed per revolution is unknown. */
export function chipArea({ job, cycle, reading }: JobReading, atOnce: number): number | null {
  const roughing = Object.entries(cycle.params).find(([, p]) => p.text === "roughingFeed")?.[0];
  const feed = roughing === undefined ? undefined : reading.perField[roughing]?.value;
  if (typeof feed !== "number") return null;
  if (job.perRevolution) return atOnce * feed;
  const speed = job.spindle.mode === "constant" ? readText(SETUP_FIELDS.speed, job.spindle.speed).value : null;
  return speed === null ? null : (atOnce * feed) / speed;
}
