import { chooseFinding } from "../document/chosen-finding.ts";
import { clearSelection } from "../document/selected.ts";
import { createDeferredStore } from "../base/typing.ts";
import { filesOf, type ProgramWork, type WorkFile } from "../document/work.ts";
import type { Run } from "../../program/state/run-types.ts";
import type { Simulation } from "../../sim/simulation.ts";

/** The result of a program text without its stock. Plain data. */
interface Made {
  /** Number of the calculated text. */
  readonly version: number;
  readonly text: string;
  /** The other files and the skip switch, as they were sent; absent for a job. */
  readonly files?: readonly WorkFile[];
  readonly skipMarked?: boolean;
  /** The program or a called file has blocks with a skip mark. */
  readonly marked?: boolean;
  readonly run: Run;
  /** The result of the first blocks of a long text, shown until the whole is there. */
  readonly isBeginning?: boolean;
  /** Time of reading and running in the worker, ms; absent if it was made elsewhere. */
  readonly pace?: number;
}

/** The whole result of a program text. */
export interface Outcome extends Made {
  readonly simulation: Simulation;
}

/** The first result of a text, made by the page or the worker: its path, not yet checked. */
export interface Planned extends Made {
  readonly simulation: null;
}

/** Whether a result belongs to the program in its present state. */
export const isMadeFrom = ({ text, files, skipMarked = false }: Made, program: ProgramWork): boolean =>
  text === program.text && files === filesOf(program) && skipMarked === (program.skipMarked ?? false);

/** From text to check. */
export const STAGES = ["reading", "running", "proving"] as const;
export type Stage = (typeof STAGES)[number];
/** Called as a stage begins, and in a long check with the share of it that is done, 0 to 1. */
export type AtStage = (stage: Stage, share?: number) => void;

export interface OutcomeState {
  /** The newest whole result, valid or not: its issues are the ones to show. */
  readonly newest: Outcome | null;
  /** The newest whole result with a path; before there is one, the newest of all, with its blank. */
  readonly shown: Outcome | null;
  /** The planned run until it is checked; steps and operations of the previous check are not those of this run. */
  readonly planned: Planned | null;
  /** The result that is shown and played: the planned run if it has a path, else `shown`. */
  readonly pictured: Outcome | Planned | null;
  /** The picture is older than the values, because they make no path yet. */
  readonly dimmed: boolean;
  /** Stage of the worker; null while it is idle. */
  readonly stage: Stage | null;
  /** The part of that stage that is done, 0 to 1; 0 where it is not known. */
  readonly share: number;
  /** The operator stopped the calculation of the open work. */
  readonly stopped: boolean;
  /** Prompts are incomplete; nothing is calculated until they are complete again. */
  readonly paused: boolean;
  /** A block of the text is half typed: it is calculated, but the picture stays. */
  readonly isPictureHeld: boolean;
}

const none: OutcomeState = {
  newest: null,
  shown: null,
  planned: null,
  pictured: null,
  dimmed: false,
  stage: null,
  share: 0,
  stopped: false,
  paused: false,
  isPictureHeld: false,
};
export const useOutcome = createDeferredStore<OutcomeState>(() => none, "result");

/** True for a cycle with moves, or in a program without cycles for any move, turned or milled. */
const makesPath = (made: Made | null) => {
  if (!made) return false;
  const { operations, steps, plane } = made.run;
  return operations.length === 0
    ? steps.length > 0 || plane.length > 0
    : operations.some((o) => o.plan.moves.length > 0);
};

/** Whether a result replaces the shown one. */
const replaces = (made: Made, { shown, isPictureHeld }: Pick<OutcomeState, "shown" | "isPictureHeld">): boolean =>
  !makesPath(shown) || (!isPictureHeld && makesPath(made));

function settled(s: OutcomeState): OutcomeState {
  const { newest, shown, planned } = s;
  const pictured = planned && replaces(planned, s) ? planned : shown;
  return {
    ...s,
    pictured,
    dimmed: pictured !== null && (s.paused || s.isPictureHeld || pictured !== (planned ?? newest)),
  };
}

/** Stores a result, unless there is a newer one. */
export function takeOutcome(outcome: Outcome): void {
  useOutcome.setState((s) => {
    if (s.newest && s.newest.version >= outcome.version) return s;
    const planned = s.planned && s.planned.version > outcome.version ? s.planned : null;
    return settled({ ...s, newest: outcome, planned, shown: replaces(outcome, s) ? outcome : s.shown });
  });
}

/** Stores a planned run, unless there is a newer result. */
export const takePlanned = (planned: Planned): void =>
  useOutcome.setState((s) =>
    Math.max(s.planned?.version ?? 0, s.newest?.version ?? 0) < planned.version ? settled({ ...s, planned }) : s,
  );

/** Shows the beginning of a program while there is no other result. */
export function showBeginning(outcome: Outcome): void {
  useOutcome.setState((s) =>
    s.shown || !makesPath(outcome) ? s : settled({ ...s, shown: { ...outcome, isBeginning: true } }),
  );
}

/** Sets the shown progress: the stage and its share, whether it was stopped, and whether values are missing. */
export const showProgress = (now: Pick<OutcomeState, "stage" | "share" | "stopped" | "paused">): void =>
  useOutcome.setState((s) =>
    s.stage === now.stage && s.share === now.share && s.stopped === now.stopped && s.paused === now.paused
      ? s
      : settled({ ...s, ...now }),
  );

/** Holds the picture while a block of the text is half typed; afterwards the newest result is shown. */
export const holdPicture = (isPictureHeld: boolean): void =>
  useOutcome.setState((s) => {
    if (s.isPictureHeld === isPictureHeld) return s;
    const { newest } = s,
      now = { ...s, isPictureHeld };
    return settled({ ...now, shown: newest && replaces(newest, now) ? newest : s.shown });
  });

/** Clears the result for another cycle or program, which must not show the previous picture. */
export function forgetOutcome(): void {
  chooseFinding(null);
  clearSelection();
  useOutcome.setState(none);
}
