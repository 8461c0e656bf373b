import { readJson } from "../../../program/files/bounded.ts";
import { useMemo } from "react";
import { markedBy, runningPart, type MoveSpan, type RunningPart } from "../../../program/run/path-index.ts";
import type { Run } from "../../../program/state/run-types.ts";
import { MOST_STRETCHES, pathStretches, wholePath, type KnownLines, type PathStretch } from "../../../view/passes.ts";
import type { Shape, TipWays } from "../../../view/scene.ts";
import { plannedAheadListeners } from "../../calculation/calculation.ts";
import { useSettings } from "../../base/settings/settings.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { usePlayback } from "./use-playback.ts";

/** The visible lines of the path, and which moves they include. */
export interface ShownPath {
  readonly stretches: readonly PathStretch[];
  readonly has: (step: number) => boolean;
}

const EVERY = () => true;
const NONE: ShownPath = { stretches: [], has: () => false };

const within = (stretches: readonly MoveSpan[]) => (step: number) =>
  stretches.some(({ first, last }) => step >= first && step <= last);

interface Passes {
  readonly stretches: readonly PathStretch[];
  readonly whole: readonly Shape[];
  readonly ways: readonly TipWays[];
}

const known = new WeakMap<Run, Passes>();
const lines: KnownLines = new WeakMap();

/** The path of a run by its passes, and whole; cached per run. */
export function stretchesOf(run: Run): Passes {
  const have = known.get(run);
  if (have) return have;
  const stretches = pathStretches(run.steps, 0, run.steps.length - 1, MOST_STRETCHES, lines),
    made = { stretches, whole: wholePath(stretches), ways: stretches.flatMap((s) => s.ways) };
  known.set(run, made);
  return made;
}

// The lines of a long work that was planned while idle are ready for its first key.
plannedAheadListeners.add(stretchesOf);

/**
 * The part of a run that the settings show, or the given one. `all`: all of its passes. The lines change only where
 * another call, phase or pass begins.
 */
export function useShownPath(
  run: Run,
  all: readonly PathStretch[],
  playback: PlaybackStore,
  part?: RunningPart,
): ShownPath {
  const set = useSettings((s) => s.paths),
    asked = part ?? set;
  const running = usePlayback(playback, (store) => {
    if (asked === "all" || asked === "none") return "";
    return JSON.stringify(runningPart(run, store.get().position.step, asked));
  });
  return useMemo(() => {
    if (asked === "none") return NONE;
    if (asked === "all") return { stretches: all, has: EVERY };
    const choice = readJson(running || "null") as ReturnType<typeof runningPart>;
    if (!choice) return NONE;
    const { stretches } = markedBy(run, choice),
      most = Math.max(1, Math.floor(MOST_STRETCHES / stretches.length));
    return {
      stretches: stretches.flatMap(({ first, last }) => pathStretches(run.steps, first, last, most)),
      has: within(stretches),
    };
  }, [asked, running, run, all]);
}
