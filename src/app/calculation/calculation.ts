import type { Run } from "../../program/state/run-types.ts";
import { notice } from "../base/notices.ts";
import { scheduleIdle } from "../base/idle.ts";
import { useSettings } from "../base/settings/settings.ts";
import { afterPaint, renderDeferred, whileTyping } from "../base/typing.ts";
import { CALCULATING } from "../base/waits.ts";
import { useEditor } from "../document/store.ts";
import { useTools } from "../document/tool-store.ts";
import {
  AT_REST,
  plansOnPage,
  progressOf,
  type CalculationEvent,
  type Effect,
  type Show,
  type Wait,
} from "./calculation-state.ts";
import { useMachineReader } from "./machine-reader.ts";
import type { Executor, Order } from "./orders.ts";
import { forgetOutcome, showBeginning, showProgress, takeOutcome, takePlanned } from "./outcome.ts";
import { pageExecutor } from "./page-executor.ts";
import { reduce } from "./reducer.ts";
import { currentCalculationInput } from "./calculation-input.ts";
import { workerExecutor } from "./worker-executor.ts";
import { askAgain, stopWorker } from "./worker-life.ts";

/** Called with the run of a long work that was planned while idle, to prepare its drawing. */
export const plannedAheadListeners = new Set<(run: Run) => void>();

function show(effect: Show): void {
  if ("outcome" in effect) {
    const { outcome } = effect;
    return effect.isBeginning ? showBeginning(outcome) : renderDeferred(() => takeOutcome(outcome));
  }
  const take = () => takePlanned(effect.planned);
  if (effect.as === "now") take();
  else if (effect.as === "typed") whileTyping(take);
  else renderDeferred(take);
}

/** The executors and waits of a calculation. */
export interface Means {
  readonly page: Executor<Order & { do: "plan" }>;
  readonly worker: Executor;
  readonly stopWorker: () => void;
  /** Calls back after an event, or after `ms`. Returns a function that cancels the wait. */
  readonly wait: (wait: Wait, ms: number | undefined, then: () => void) => () => void;
}

/** The calculation of the open work: holds its state, takes events, and carries out their effects. */
export function createCalculation({ page, worker, stopWorker, wait }: Means) {
  let state = AT_REST;
  let isBusy = false;
  const events: CalculationEvent[] = [];
  /** Pending waits; waiting for the same event again restarts the wait. */
  const waits = new Map<Wait, () => void>();

  function carryOut(effect: Effect): void {
    if ("on" in effect) {
      if (effect.on === "page") page(effect.order, dispatch);
      else worker(effect.order, dispatch);
      return;
    }
    switch (effect.do) {
      case "show":
        return show(effect);
      case "wait":
        waits.get(effect.for)?.();
        waits.set(
          effect.for,
          wait(effect.for, effect.ms, () => dispatch({ event: "rested", from: effect.for })),
        );
        return;
      case "prepare":
        scheduleIdle(() => plannedAheadListeners.forEach((hear) => hear(effect.run)), CALCULATING.rest);
        return;
      case "stopWorker":
        return stopWorker();
      case "forget":
        return forgetOutcome();
      case "sayFailed":
        return notice("engineFailed");
    }
  }

  function dispatch(event: CalculationEvent): void {
    events.push(event);
    if (isBusy) return;
    isBusy = true;
    try {
      for (let next = events.shift(); next; next = events.shift()) {
        const [after, effects] = reduce(state, next);
        state = after;
        effects.forEach(carryOut);
        showProgress(progressOf(state));
      }
    } finally {
      isBusy = false;
    }
  }

  const follow = (again = false) => {
    const wanted = currentCalculationInput();
    dispatch(wanted ? { event: "edited", again, ...wanted } : { event: "left" });
  };

  return {
    /** Calculates each change of the work, the tool table, the settings or the machine. */
    start(): () => void {
      const now = () => follow();
      carryOut({ do: "wait", for: "planner" });
      now();
      const stops = [useEditor, useTools, useSettings, useMachineReader].map((store) => store.subscribe(now));
      return () => {
        for (const stop of [...stops, ...waits.values()]) stop();
      };
    },
    /** Calculates the open work again. */
    again: () => follow(true),
    /** The same as for a new work: its earlier results are dropped. */
    recalculate() {
      dispatch({ event: "left" });
      follow(true);
    },
    /** Stops a calculation that takes too long; text and last picture stay. */
    cancel: () => dispatch({ event: "cancelled" }),
    /** Somebody types in a text: results wait until `pause` ms without a key. */
    typed: (pause: number) => dispatch({ event: "typed", pause }),
    /** Whether a text of this length, its called files included, is planned in the task of its key. */
    plansOnPage: (characters: number) => plansOnPage(state, characters),
  };
}

const page = pageExecutor();

const soon = (then: () => void, ms?: number) => {
  const timer = setTimeout(then, ms);
  return () => clearTimeout(timer);
};

/** The waits of the page. */
function waitOnPage(wait: Wait, ms: number | undefined, then: () => void): () => void {
  switch (wait) {
    case "planner":
      return scheduleIdle(() => void page.fetch().then(then));
    case "rest":
      return scheduleIdle(then, CALCULATING.rest);
    case "picture":
      return afterPaint(then);
    case "digit": {
      let callOff = afterPaint(() => (callOff = soon(then)));
      return () => callOff();
    }
    case "slice":
    case "quiet":
    case "leftWork":
      return soon(then, ms);
  }
}

/** The calculation of this page. */
export const calculation = createCalculation({
  page: page.execute,
  worker: workerExecutor(askAgain),
  stopWorker,
  wait: waitOnPage,
});
