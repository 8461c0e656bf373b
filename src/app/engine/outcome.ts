import { create } from "zustand";
import { chooseFinding } from "../findings/chosen.ts";
import { clearSelection } from "../selected.ts";
import { filesOf, type ProgramWork, type WorkFile } from "../work.ts";
import type { Run } from "../../program/run-types.ts";
import type { Simulation } from "../../sim/simulation.ts";

/** What the worker makes of a program text. Plain data. */
export interface Outcome {
  /** Counts up with each text that was sent. */
  readonly version: number;
  readonly text: string;
  /** The files beside it and the switch of the skip mark, as they were sent; absent for a job. */
  readonly files?: readonly WorkFile[];
  readonly skipMarked?: boolean;
  /** The program, or one that it has called, has blocks behind a skip mark. */
  readonly marked?: boolean;
  readonly run: Run;
  readonly simulation: Simulation;
  /** Made of the first blocks of a long text, to be looked at until the whole is there. */
  readonly isBeginning?: boolean;
}

/** True when a result was made from a program as it stands. */
export const isMadeFrom = ({ text, files, skipMarked = false }: Outcome, program: ProgramWork): boolean =>
  text === program.text && files === filesOf(program) && skipMarked === (program.skipMarked ?? false);

/** From text to proof. */
export const STAGES = ["reading", "running", "proving"] as const;
export type Stage = (typeof STAGES)[number];

export interface OutcomeState {
  /** The newest result, possible or not: its issues are the ones to show. */
  readonly newest: Outcome | null;
  /** The newest result with a path, or before there is one the newest of all, with its blank: the picture to show. */
  readonly shown: Outcome | null;
  /** The picture is older than the values, because they make no path. */
  readonly dimmed: boolean;
  /** What the worker is at; null while it rests. */
  readonly stage: Stage | null;
  /** The operator stopped the calculation of what is open. */
  readonly stopped: boolean;
  /** Prompts are incomplete; nothing is calculated until they can be read again. */
  readonly paused: boolean;
}

const none: OutcomeState = { newest: null, shown: null, dimmed: false, stage: null, stopped: false, paused: false };
export const useOutcome = create<OutcomeState>(() => none);

/** A cycle with its moves, or in a program without cycles any move, turned or milled. */
const makesPath = (outcome: Outcome | null) => {
  if (!outcome) return false;
  const { operations, steps, plane } = outcome.run;
  return operations.length === 0 ? steps.length > 0 || plane.length > 0 : operations.some((o) => o.plan.moves.length > 0);
};

const settled = (s: OutcomeState): OutcomeState => ({ ...s, dimmed: s.shown !== null && (s.paused || s.shown !== s.newest) });

/** Takes a result in, unless a newer one is already there. */
export function takeOutcome(outcome: Outcome): void {
  useOutcome.setState((s) => {
    if (s.newest && s.newest.version >= outcome.version) return s;
    return settled({ ...s, newest: outcome, shown: makesPath(outcome) || !makesPath(s.shown) ? outcome : s.shown });
  });
}

/** Shows the beginning of a program as long as there is nothing else to look at. */
export function showBeginning(outcome: Outcome): void {
  useOutcome.setState((s) => (s.shown || !makesPath(outcome) ? s : settled({ ...s, shown: { ...outcome, isBeginning: true } })));
}

/** The worker begins something, or rests. */
export const atStage = (stage: Stage | null): void => useOutcome.setState({ stage, ...(stage && { stopped: false }) });
/** Nothing is calculated any more until something changes or the operator wants it again. */
export const calculationStopped = (): void => useOutcome.setState({ stage: null, stopped: true });

/** Values are incomplete: the last picture stays, dimmed; or they are complete again. */
export const pause = (paused: boolean): void => useOutcome.setState((s) => (s.paused === paused ? s : settled({ ...s, paused })));

/** Another cycle or program: its first picture must not be that of the one before. */
export function forgetOutcome(): void {
  chooseFinding(null);
  clearSelection();
  useOutcome.setState(none);
}
