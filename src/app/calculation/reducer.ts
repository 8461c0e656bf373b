import { CALCULATING, PLANNING } from "../base/waits.ts";
import {
  NO_WORK,
  plansOnPage,
  type Calculation,
  type CalculationEvent,
  type WorkerTask,
  type Planning,
  type Queued,
  type Step,
  type Wait,
  type CalculationInput,
} from "./calculation-state.ts";
import type { Order, Part, Text, OrderEvent } from "./orders.ts";
import type { Outcome, Planned } from "./outcome.ts";
import { isQuick, isSlow, lengthOf, mayWarmUp, withRun, withRunInWorker } from "./pace.ts";

/*
 * Decides what is calculated of the open work, when and where: a state, events, and their effects. The page plans what
 * it can plan quickly, in the task of the key; the worker checks it, and plans the rest. Each text is first ordered
 * from one of them, and the worker has one text at a time: of those queued only the newest counts.
 */

const chain = ([state, effects]: Step, next: (state: Calculation) => Step): Step => {
  const [after, more] = next(state);
  return [after, [...effects, ...more]];
};

/** A text longer than this shows its beginning first; length of that beginning. Both in characters. */
const [LONG_TEXT, BEGINNING] = [1_000_000, 300_000];
const beginningOf = (text: string): string => text.slice(0, text.lastIndexOf("\n", BEGINNING) + 1);

/**
 * Code runs slowly the first time, and the path of the first key must be as quick as any other: shares of an opened
 * text are planned while idle, then all of it, which is cached. A long one is planned in slices.
 */
const PARTS: readonly Part[] = [{ share: 0.25 }, { share: 0.5 }, { share: 0.75 }, { share: 1 }, "whole"];
const SLICES: readonly Part[] = [{ slice: PLANNING.slice }];

/** Gives the worker its next text, if it is free. */
function begin(state: Calculation): Step {
  const { next, worker, isShown } = state;
  if (!next || worker) return [state, []];
  const isLong = next.request.text.length >= LONG_TEXT && !isShown;
  return orderFrom({ ...state, next: null, isStopped: false }, next, isLong ? "beginning" : "plan");
}

/** Orders the next step for a text: its beginning, its run if that is missing and not quick, or its check. */
function orderFrom(state: Calculation, queued: Queued, from: WorkerTask["at"]): Step {
  const { request, isVeiled, planned } = queued;
  const isPlannedFirst = !planned && !isVeiled && !isQuick(state.pace, lengthOf(request), state.warmUp !== null);
  const at = from === "plan" && !isPlannedFirst ? "proof" : from;
  const text = at === "beginning" ? beginningOf(request.text) : request.text;
  const order: Order =
    at === "plan"
      ? { do: "plan", request, part: "whole" }
      : { do: "prove", request: { ...request, text }, planned, isVeiled };
  const worker = { ...queued, at, stage: "reading" as const, share: 0, outcome: null, isGivenUp: false };
  return [{ ...state, worker }, [{ on: "worker", order }]];
}

const queue = (state: Calculation, queued: Queued): Step => begin({ ...state, page: null, next: queued });

const orderOnPage = (state: Calculation, queued: Queued, waits: Planning["waits"]): Step =>
  queued.isVeiled || !plansOnPage(state, lengthOf(queued.request))
    ? queue(state, queued)
    : [
        { ...state, page: { ...queued, waits } },
        [{ on: "page", order: { do: "plan", request: queued.request, part: "whole" } }],
      ];

const orderWhen = (state: Calculation, queued: Queued, waits: "digit" | "slice"): Step => [
  { ...state, page: { ...queued, waits } },
  [{ do: "wait", for: waits }],
];

/**
 * Whether the page plans a long text in slices, since it has not planned it yet: in one piece it would block the page,
 * and so would a result of the worker as large as its path.
 */
const isSliced = ({ canPlan, pace, warmUp }: Calculation, characters: number): boolean =>
  canPlan && warmUp !== null && !pace.isKnown && pace.first <= PLANNING.waitedFor && characters > PLANNING.short;

const isSame = (a: Omit<Text, "version">, b: Text): boolean =>
  Object.entries(a).every(([name, value]) => Object.is(b[name as keyof Text], value));

function edited(state: Calculation, wanted: CalculationInput & { readonly again?: boolean }): Step {
  const { of, isVeiled, request, again = false } = wanted;
  if (state.of !== null && state.of !== of) return chain(leaveWork(state), (now) => edited(now, wanted));
  if (request === undefined) return [{ ...state, of }, []];
  // A queued text is dropped: it is calculated if the same values come again.
  const isUndone = request === null && (state.next !== null || state.page !== null);
  if (request === null)
    return [{ ...state, of, page: null, next: null, isPaused: true, request: isUndone ? null : state.request }, []];
  if (!again && state.request && isSame(request, state.request)) return [{ ...state, isPaused: false }, []];
  const text = { ...request, version: state.version + 1 };
  const queued = { request: text, isVeiled, planned: null };
  const now = { ...state, of, request: text, version: text.version, page: null, isPaused: false, isStopped: false };
  if (!isVeiled && isSliced(now, lengthOf(text)))
    return orderWhen({ ...now, warmUp: now.warmUp && { ...now.warmUp, parts: null } }, queued, "slice");
  return isSlow(now.pace) ? orderWhen(now, queued, "digit") : orderOnPage(now, queued, null);
}

/** Another work, or none: drops all results, and those of the running calculation. */
function leaveWork(state: Calculation): Step {
  const worker = state.worker?.outcome ? null : state.worker;
  return [
    { ...state, ...NO_WORK, left: state.version, worker: worker && { ...worker, isGivenUp: true } },
    [
      { do: "forget" },
      ...(worker && !worker.isGivenUp ? [{ do: "wait", for: "leftWork", ms: CALCULATING.leftWork } as const] : []),
    ],
  ];
}

type PlannedEvent = OrderEvent & { readonly event: "planned" };

function planned(state: Calculation, told: PlannedEvent): Step {
  const { page, worker, warmUp } = state;
  if (page?.request.version === told.version) return plannedOnPage(state, page, told);
  if (worker?.request.version === told.version && worker.at === "plan") return plannedInWorker(state, worker, told);
  return warmUp?.request.version === told.version ? warmedUp(state, warmUp, told) : [state, []];
}

function plannedOnPage(state: Calculation, page: Planning, told: PlannedEvent): Step {
  const { made, took } = told;
  if (made === "part") return orderWhen(state, page, "slice");
  const isInSlices = page.waits === "slice";
  const now = isInSlices ? state : { ...state, pace: withRun(state.pace, took) };
  // The worker fails the same way and reports it.
  if (!made) return queue(now, { ...page, planned: null });
  const step: Step = [
    { ...now, page: null, next: { ...page, planned: made } },
    // The planned path is drawn before it is sent to the worker, which costs a copy.
    [
      { do: "show", planned: made, as: page.waits ? "typed" : "now" },
      { do: "wait", for: "picture" },
    ],
  ];
  return isInSlices ? chain(step, (after) => inAllSlices(after, made)) : step;
}

/** A long text has been planned on the page: from now on planning is quick. */
const inAllSlices = (state: Calculation, { run }: Planned): Step => [
  {
    ...state,
    pace: { ...state.pace, runs: [], isKnown: true },
    warmUp: state.warmUp && { ...state.warmUp, parts: [] },
  },
  [{ do: "prepare", run }],
];

function plannedInWorker(state: Calculation, worker: WorkerTask, { made, version }: PlannedEvent): Step {
  if (!made || made === "part" || version <= state.left) return begin({ ...state, worker: null });
  const step: Step = [state, [{ do: "show", planned: made, as: "byItself" }]];
  // A text typed meanwhile is planned before anything is checked.
  return chain(step, (now) =>
    now.next ? begin({ ...now, worker: null }) : orderFrom(now, { ...worker, planned: made }, "proof"),
  );
}

/** Continues planning an opened work while idle, as long as each part is quick. */
function warmedUp(state: Calculation, warmUp: NonNullable<Calculation["warmUp"]>, { made, took }: PlannedEvent): Step {
  const [part, ...more] = warmUp.parts ?? [];
  if (made === "part") return [state, [{ do: "wait", for: "rest" }]];
  if (made && typeof part === "object" && "slice" in part) return inAllSlices(state, made);
  const parts = made && took < PLANNING.warmUp ? more : [];
  const pace = made && part === "whole" ? { ...state.pace, runs: [] } : state.pace;
  return [{ ...state, pace, warmUp: { ...warmUp, parts } }, parts.length > 0 ? [{ do: "wait", for: "rest" }] : []];
}

/** Starts planning an opened work while idle, once. */
function warmUpOf(state: Calculation, request: Text): Step {
  if (state.warmUp?.parts) return [state, []];
  if (!state.canPlan) return [{ ...state, warmUp: { request, parts: null } }, []];
  const parts = !state.pace.isKnown && lengthOf(request) > PLANNING.short ? SLICES : PARTS;
  return [{ ...state, warmUp: { request, parts } }, [{ do: "wait", for: "rest" }]];
}

function proved(state: Calculation, { version, outcome }: OrderEvent & { readonly event: "proved" }): Step {
  const { worker } = state;
  if (worker?.request.version !== version) return [state, []];
  if (version <= state.left) return begin({ ...state, worker: null });
  if (worker.at === "beginning")
    return chain([state, [{ do: "show", outcome, isBeginning: true }]], (now) => orderFrom(now, worker, "plan"));
  return state.isTyping ? [{ ...state, worker: { ...worker, outcome } }, []] : settled(state, worker.request, outcome);
}

/** Takes in a whole result, and measures the pace of the text. */
function settled(state: Calculation, request: Text, outcome: Outcome): Step {
  const now = { ...state, worker: null, isShown: true };
  const { pace: took } = outcome;
  const paced = took === undefined ? now : { ...now, pace: withRunInWorker(now.pace, took) };
  const isOpened = took !== undefined && mayWarmUp(lengthOf(request), took);
  const step: Step = [paced, [{ do: "show", outcome }]];
  return chain(isOpened ? chain(step, (after) => warmUpOf(after, request)) : step, begin);
}

/** Stops the worker's current task. */
const stopped = (state: Calculation): Step => chain([{ ...state, worker: null }, [{ do: "stopWorker" }]], begin);

function waitOver(state: Calculation, from: Wait): Step {
  const { page, worker, warmUp } = state;
  switch (from) {
    case "planner": {
      const now = { ...state, canPlan: true };
      return warmUp ? warmUpOf(now, warmUp.request) : [now, []];
    }
    case "rest": {
      const part = warmUp?.parts?.[0];
      return [state, part ? [{ on: "page", order: { do: "plan", request: warmUp.request, part } }] : []];
    }
    case "digit":
      return page?.waits === "digit" ? orderOnPage(state, page, "digit") : [state, []];
    case "slice":
      if (page?.waits !== "slice") return [state, []];
      return [
        state,
        [{ on: "page", order: { do: "plan", request: page.request, part: { slice: PLANNING.sliceWaitedFor } } }],
      ];
    case "picture":
      return begin(state);
    case "quiet": {
      const now = { ...state, isTyping: false };
      return worker?.outcome ? settled(now, worker.request, worker.outcome) : [now, []];
    }
    case "leftWork":
      return worker?.isGivenUp ? stopped(state) : [state, []];
  }
}

/** The next state of a calculation, and its effects. */
export function reduce(state: Calculation, event: CalculationEvent): Step {
  switch (event.event) {
    case "edited":
      return edited(state, event);
    case "typed":
      return [{ ...state, isTyping: true }, [{ do: "wait", for: "quiet", ms: event.pause }]];
    case "began": {
      const { worker } = state;
      // For a planned text only the stage of its check is news.
      const isNews = worker?.request.version === event.version && (!worker.planned || event.stage === "proving");
      return [isNews ? { ...state, worker: { ...worker, stage: event.stage, share: event.share ?? 0 } } : state, []];
    }
    case "planned":
      return planned(state, event);
    case "proved":
      return proved(state, event);
    case "failed": {
      if (state.worker?.request.version !== event.version) return [state, []];
      const [now, effects] = stopped({ ...state, isStopped: event.version > state.left });
      return [now, [{ do: "sayFailed" }, ...effects]];
    }
    case "cancelled": {
      const now = { ...state, page: null, next: null, isStopped: true };
      return state.worker ? stopped(now) : [now, []];
    }
    case "left":
      return leaveWork(state);
    case "rested":
      return waitOver(state, event.from);
  }
}
