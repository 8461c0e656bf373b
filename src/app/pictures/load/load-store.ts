import { create } from "zustand";
import type { Run } from "../../../program/state/run-types.ts";
import type { PathLoad } from "../../../sim/load/along.ts";
import type { RoughStretch } from "../../../sim/load/roughness.ts";
import { loadRequestOf, type KnownOutcome, type LoadRequest } from "../../calculation/load-request.ts";
import { useOutcome } from "../../calculation/outcome.ts";
import { askAgain } from "../../calculation/worker-life.ts";

/** Measured data of a run, as far as requested. */
export interface MeasuredLoad {
  readonly run: Run | null;
  readonly path: PathLoad | null;
  readonly surface: readonly RoughStretch[] | null;
  /** The last request failed. */
  readonly failed: boolean;
}

const NONE: MeasuredLoad = { run: null, path: null, surface: null, failed: false };
export const useMeasuredLoad = create<MeasuredLoad>(() => NONE);

const put = (run: Run, found: Partial<MeasuredLoad>): void =>
  useMeasuredLoad.setState((known) => ({ ...(known.run === run ? known : { ...NONE, run }), failed: false, ...found }));

/** Asks by the number of the outcome; sends the whole run if the worker no longer has it. */
async function answerTo<T>(
  run: Run,
  question: (of: KnownOutcome | LoadRequest) => Promise<T | null>,
): Promise<T | null> {
  const { shown } = useOutcome.getState();
  if (shown?.run !== run) return null;
  const known = { version: shown.version, moves: run.steps.length };
  const has = await askAgain((engine) => engine.knows(known));
  return question(has ? known : loadRequestOf(shown));
}

/** Measures a run if not known yet: its surface, or the load along the path. */
export async function measureLoad(run: Run, what: "surface" | "path"): Promise<void> {
  const known = useMeasuredLoad.getState();
  if (known.run === run && known[what]) return;
  try {
    if (what === "surface") {
      const surface = await answerTo(run, (of) => askAgain((engine) => engine.roughness(of)));
      if (surface) put(run, { surface });
    } else {
      const path = await answerTo(run, (of) => askAgain((engine) => engine.pathLoad(of)));
      if (path) put(run, { path });
    }
  } catch {
    put(run, { failed: true });
  }
}
