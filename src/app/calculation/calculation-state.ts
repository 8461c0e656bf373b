import type { Run } from "../../program/state/run-types.ts";
import type { Order, Part, Text, Told } from "./orders.ts";
import type { Outcome, Planned, Stage } from "./outcome.ts";
import { isQuick, UNKNOWN_PACE, type Pace } from "./pace.ts";

/** What is to be calculated of the open work. */
export interface Wanted {
  /** The work that it is a text of: answers to another one do not count. */
  readonly of: string;
  /** Its task asks before its run may be seen. */
  readonly isVeiled: boolean;
  /** null: its values make no program. Absent: something that it needs is still being fetched. */
  readonly request?: Omit<Text, "version"> | null;
}

/** What can be waited for. */
export type Wait =
  /** The code that plans is here. */
  | "planner"
  /** The browser rests. */
  | "rest"
  /** The picture of a digit is painted, and the page has answered. */
  | "digit"
  /** The page has answered between two slices. */
  | "slice"
  /** The picture of a path is painted. */
  | "picture"
  /** Nobody types in the text any more. */
  | "quiet"
  /** The work that was left had its time. */
  | "leftWork";

export type CalculationEvent =
  | Told
  /** `again`: also where nothing is other than before. */
  | ({ readonly event: "edited"; readonly again?: boolean } & Wanted)
  /** Somebody types in a text: half a word is no fault yet. `pause`: how long it is quiet behind it, ms. */
  | { readonly event: "typed"; readonly pause: number }
  | { readonly event: "cancelled" }
  | { readonly event: "left" }
  | { readonly event: "rested"; readonly from: Wait };

/** Shows what was made. `as`: with what changed it, as typed just now, or as something that comes by itself. */
export type Show = { readonly do: "show" } & (
  | { readonly planned: Planned; readonly as: "now" | "typed" | "byItself" }
  | { readonly outcome: Outcome; readonly isBeginning?: true }
);

export type Effect =
  | Show
  | { readonly on: "page"; readonly order: Order & { readonly do: "plan" } }
  | { readonly on: "worker"; readonly order: Order }
  | { readonly do: "wait"; readonly for: Wait; readonly ms?: number }
  /** The lines of a path that will be wanted. */
  | { readonly do: "prepare"; readonly run: Run }
  | { readonly do: "stopWorker" | "forget" | "sayFailed" };

/** A text on its way to its proof. */
export interface Queued {
  readonly request: Text;
  readonly isVeiled: boolean;
  /** Its run, where it has been made. */
  readonly planned: Planned | null;
}

/** A text that the page plans in the task of its key, or, where it waits for something, behind that. */
export interface Planning extends Queued {
  readonly waits: "digit" | "slice" | null;
}

/** A text that the worker is at. */
export interface Ordered extends Queued {
  readonly at: "beginning" | "plan" | "proof";
  readonly stage: Stage;
  /** Its answer, while somebody types. */
  readonly outcome: Outcome | null;
  readonly isGivenUp: boolean;
}

export interface Calculation {
  /** Counts up with each text. */
  readonly version: number;
  /** Answers up to this version are of works that were left. */
  readonly left: number;
  readonly canPlan: boolean;
  readonly isTyping: boolean;
  readonly of: string | null;
  /** The newest text. */
  readonly request: Text | null;
  /** What the page plans. */
  readonly page: Planning | null;
  /** What the worker is to do next. */
  readonly next: Queued | null;
  readonly worker: Ordered | null;
  readonly isShown: boolean;
  readonly isPaused: boolean;
  readonly isStopped: boolean;
  readonly pace: Pace;
  /** An opened work that the page plans ahead at rest, and the parts that are left of it; null: it has not begun. */
  readonly warmUp: { readonly request: Text; readonly parts: readonly Part[] | null } | null;
}

/** A state in which no work is open. */
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

/** A state, and what is to be done. */
export type Step = readonly [state: Calculation, effects: readonly Effect[]];

/** Whether the page plans a text of a length, with what it can call, in the task of its key. */
export const plansOnPage = ({ canPlan, pace, warmUp }: Calculation, characters: number): boolean =>
  canPlan && isQuick(pace, characters, warmUp !== null);

/** What the operator is told of a calculation: what it is at, whether it was stopped, whether it waits for values. */
export function progressOf({ worker, left: until, page, next, isStopped, isPaused }: Calculation): {
  readonly stage: Stage | null;
  readonly stopped: boolean;
  readonly paused: boolean;
} {
  const working = worker && worker.request.version > until ? worker.stage : null;
  return { stage: working ?? (page || next ? "reading" : null), stopped: isStopped, paused: isPaused };
}
