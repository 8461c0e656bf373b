import type { Run } from "../../program/state/run-types.ts";
import type { Order, Part, Text, OrderEvent } from "./orders.ts";
import type { Outcome, Planned, Stage } from "./outcome.ts";
import { isQuick, UNKNOWN_PACE, type Pace } from "./pace.ts";

/** Input of the calculation, from the open work. */
export interface CalculationInput {
  /** Id of the work and file: answers for another one are ignored. */
  readonly of: string;
  /** Its task asks for a prediction before its run may be seen. */
  readonly isVeiled: boolean;
  /** null: the values make no program. Absent: something that is needed is still being fetched. */
  readonly request?: Omit<Text, "version"> | null;
}

/** Events that the calculation can wait for. */
export type Wait =
  /** The planning code is loaded. */
  | "planner"
  /** The browser is idle. */
  | "rest"
  /** The frame of a digit is painted, and the page has handled its events. */
  | "digit"
  /** The page has handled its events between two slices. */
  | "slice"
  /** The frame of a path is painted. */
  | "picture"
  /** Nobody has typed in the text for a while. */
  | "quiet"
  /** The time limit of a closed work is over. */
  | "leftWork";

export type CalculationEvent =
  | OrderEvent
  /** `again`: also if nothing has changed. */
  | ({ readonly event: "edited"; readonly again?: boolean } & CalculationInput)
  /** Somebody types in a text: half a word is no error yet. `pause`: time without a key that ends the typing, ms. */
  | { readonly event: "typed"; readonly pause: number }
  | { readonly event: "cancelled" }
  | { readonly event: "left" }
  | { readonly event: "rested"; readonly from: Wait };

/** Shows a result. `as`: in the task of the key, as a typed change, or as a deferred update. */
export type Show = { readonly do: "show" } & (
  | { readonly planned: Planned; readonly as: "now" | "typed" | "byItself" }
  | { readonly outcome: Outcome; readonly isBeginning?: true }
);

export type Effect =
  | Show
  | { readonly on: "page"; readonly order: Order & { readonly do: "plan" } }
  | { readonly on: "worker"; readonly order: Order }
  | { readonly do: "wait"; readonly for: Wait; readonly ms?: number }
  /** Prepares the lines of a path before they are needed. */
  | { readonly do: "prepare"; readonly run: Run }
  | { readonly do: "stopWorker" | "forget" | "sayFailed" };

/** A text that is queued for its check. */
export interface Queued {
  readonly request: Text;
  readonly isVeiled: boolean;
  /** Its run, if it has been planned. */
  readonly planned: Planned | null;
}

/** A text that the page plans, in the task of its key or after the named wait. */
export interface Planning extends Queued {
  readonly waits: "digit" | "slice" | null;
}

/** The text that the worker calculates. */
export interface WorkerTask extends Queued {
  readonly at: "beginning" | "plan" | "proof";
  readonly stage: Stage;
  /** The part of it that is done, 0 to 1. */
  readonly share: number;
  /** Its result, held back while somebody types. */
  readonly outcome: Outcome | null;
  readonly isGivenUp: boolean;
}

export interface Calculation {
  /** Number of the newest text. */
  readonly version: number;
  /** Results up to this version belong to closed works. */
  readonly left: number;
  readonly canPlan: boolean;
  readonly isTyping: boolean;
  readonly of: string | null;
  /** The newest text. */
  readonly request: Text | null;
  /** The text that the page plans. */
  readonly page: Planning | null;
  /** The next text for the worker. */
  readonly next: Queued | null;
  readonly worker: WorkerTask | null;
  readonly isShown: boolean;
  readonly isPaused: boolean;
  readonly isStopped: boolean;
  readonly pace: Pace;
  /** An opened work that the page plans ahead while idle, and the remaining parts; parts null: not begun. */
  readonly warmUp: { readonly request: Text; readonly parts: readonly Part[] | null } | null;
}

/** State without an open work. */
export const NO_WORK = {
  of: null,
  request: null,
  page: null,
  next: null,
  isShown: false,
  isPaused: false,
  isStopped: false,
  pace: UNKNOWN_PACE,
  warmUp: null,
} as const;

export const AT_REST: Calculation = {
  ...NO_WORK,
  version: 0,
  left: 0,
  canPlan: false,
  isTyping: false,
  worker: null,
};

/** The next state, and the effects to carry out. */
export type Step = readonly [state: Calculation, effects: readonly Effect[]];

/** Whether the page plans a text of this length, its called files included, in the task of its key. */
export const plansOnPage = ({ canPlan, pace, warmUp }: Calculation, characters: number): boolean =>
  canPlan && isQuick(pace, characters, warmUp !== null);

/** What is shown of a calculation: its stage and how much of it is done, whether it was stopped, and whether values are missing. */
export function progressOf({ worker, left: until, page, next, isStopped, isPaused }: Calculation): {
  readonly stage: Stage | null;
  readonly share: number;
  readonly stopped: boolean;
  readonly paused: boolean;
} {
  const working = worker && worker.request.version > until ? worker : null;
  const stage = working?.stage ?? (page || next ? "reading" : null);
  return { stage, share: working?.share ?? 0, stopped: isStopped, paused: isPaused };
}
