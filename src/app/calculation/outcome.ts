import { chooseFinding } from "../document/chosen.ts";
import { clearSelection } from "../document/selected.ts";
import { heldWhileTyping } from "../base/typing.ts";
import { filesOf, type ProgramWork, type WorkFile } from "../document/work.ts";
import type { Run } from "../../program/state/run-types.ts";
import type { Simulation } from "../../sim/simulation.ts";

/** What comes of a program text without a stock. Plain data. */
interface Made {
  /** Counts up with each text that is calculated. */
  readonly version: number;
  readonly text: string;
  /** The files beside it and the switch of the skip mark, as they were sent; absent for a job. */
  readonly files?: readonly WorkFile[];
  readonly skipMarked?: boolean;
  /** The program, or one that it has called, has blocks behind a skip mark. */
  readonly marked?: boolean;
  readonly run: Run;
  /** Made of the first blocks of a long text, to be looked at until the whole is there. */
  readonly isBeginning?: boolean;
  /** What reading and running took in the worker, ms; absent where it was made elsewhere. */
  readonly pace?: number;
}

/** What the worker makes of a program text. */
export interface Outcome extends Made {
  readonly simulation: Simulation;
}

/** What is made of a text first, by the page itself or by the worker: its path, of which nothing is proved yet. */
export interface Planned extends Made {
  readonly simulation: null;
}

/** True when a result was made from a program as it stands. */
export const isMadeFrom = ({ text, files, skipMarked = false }: Made, program: ProgramWork): boolean =>
  text === program.text && files === filesOf(program) && skipMarked === (program.skipMarked ?? false);

/** From text to proof. */
export const STAGES = ["reading", "running", "proving"] as const;
export type Stage = (typeof STAGES)[number];

export interface OutcomeState {
  /** The newest whole result, possible or not: its issues are the ones to show. */
  readonly newest: Outcome | null;
  /** The newest whole result with a path, or before there is one the newest of all, with its blank. */
  readonly shown: Outcome | null;
  /** What is planned, as long as it is not proved; steps and operations of the proof before are not those of it. */
  readonly planned: Planned | null;
  /**
   * What the picture shows, and whose steps are the ones that are played: what is planned where that has a path, else
   * what is shown.
   */
  readonly pictured: Outcome | Planned | null;
  /** The picture is older than the values, because they make no path. */
  readonly dimmed: boolean;
  /** What the worker is at; null while it rests. */
  readonly stage: Stage | null;
  /** The operator stopped the calculation of what is open. */
  readonly stopped: boolean;
  /** Prompts are incomplete; nothing is calculated until they can be read again. */
  readonly paused: boolean;
  /** A block of the text is half typed: it is calculated as it stands, and the picture stays as it was. */
  readonly keeps: boolean;
}

const none: OutcomeState = {
  newest: null,
  shown: null,
  planned: null,
  pictured: null,
  dimmed: false,
  stage: null,
  stopped: false,
  paused: false,
  keeps: false,
};
export const useOutcome = heldWhileTyping<OutcomeState>(() => none, "result");

/** A cycle with its moves, or in a program without cycles any move, turned or milled. */
const makesPath = (made: Made | null) => {
  if (!made) return false;
  const { operations, steps, plane } = made.run;
  return operations.length === 0
    ? steps.length > 0 || plane.length > 0
    : operations.some((o) => o.plan.moves.length > 0);
};

/** Whether a result takes the place of the one that is shown. */
const replaces = (made: Made, { shown, keeps }: Pick<OutcomeState, "shown" | "keeps">): boolean =>
  !makesPath(shown) || (!keeps && makesPath(made));

function settled(s: OutcomeState): OutcomeState {
  const { newest, shown, planned } = s;
  const pictured = planned && replaces(planned, s) ? planned : shown;
  return { ...s, pictured, dimmed: pictured !== null && (s.paused || s.keeps || pictured !== (planned ?? newest)) };
}

/** Takes a result in, unless a newer one is already there. */
export function takeOutcome(outcome: Outcome): void {
  useOutcome.setState((s) => {
    if (s.newest && s.newest.version >= outcome.version) return s;
    const planned = s.planned && s.planned.version > outcome.version ? s.planned : null;
    return settled({ ...s, newest: outcome, planned, shown: replaces(outcome, s) ? outcome : s.shown });
  });
}

/** Takes in what is planned, unless something newer is already there. */
export const takePlanned = (planned: Planned): void =>
  useOutcome.setState((s) =>
    Math.max(s.planned?.version ?? 0, s.newest?.version ?? 0) < planned.version ? settled({ ...s, planned }) : s,
  );

/** Shows the beginning of a program as long as there is nothing else to look at. */
export function showBeginning(outcome: Outcome): void {
  useOutcome.setState((s) =>
    s.shown || !makesPath(outcome) ? s : settled({ ...s, shown: { ...outcome, isBeginning: true } }),
  );
}

/** What is said of the calculation: what it is at, whether it was stopped, and whether it waits for values. */
export const showProgress = ({ stage, stopped, paused }: Pick<OutcomeState, "stage" | "stopped" | "paused">): void =>
  useOutcome.setState((s) =>
    s.stage === stage && s.stopped === stopped && s.paused === paused ? s : settled({ ...s, stage, stopped, paused }),
  );

/** A block of the text is half typed, or no longer: then what was calculated meanwhile is shown. */
export const holdPicture = (keeps: boolean): void =>
  useOutcome.setState((s) => {
    if (s.keeps === keeps) return s;
    const { newest } = s,
      now = { ...s, keeps };
    return settled({ ...now, shown: newest && replaces(newest, now) ? newest : s.shown });
  });

/** Another cycle or program: its first picture must not be that of the one before. */
export function forgetOutcome(): void {
  chooseFinding(null);
  clearSelection();
  useOutcome.setState(none);
}
