import { ncLabels } from "../../src/i18n/nc-labels.ts";
import type { Ring } from "../../src/kernel/geometry/point.ts";
import { parse } from "../../src/nc/parse.ts";
import { print, type Program } from "../../src/nc/program.ts";
import { actionSources } from "../../src/planning/actions/index.ts";
import { applyAction, withAction } from "../../src/planning/apply-action.ts";
import type { PlannedPart, PlanRequest, PlanState, TriedAction } from "../../src/planning/types.ts";
import { emptyProgram } from "../../src/program/job/empty-program.ts";
import { cylinderAround } from "../../src/program/job/requested-shape.ts";
import { run } from "../../src/program/run/run.ts";
import { verdictOf } from "../../src/report/verdict.ts";
import { simulate } from "../../src/sim/simulate.ts";
import { workshop } from "./bore-tools.ts";

/** A request with the usual rules and the tools of the workshop. */
export const requestFor = (
  part: PlannedPart,
  blank: readonly Ring[],
  more: Partial<PlanRequest> = {},
): PlanRequest => ({
  part,
  blank,
  clamping: null,
  shop: workshop,
  material: "c45",
  rules: {
    toolChange: 5,
    usualTool: 0,
    finishBeforeRough: 60,
    insideBeforeOutside: 5,
    thinBeforeLong: 20,
    tolerancedLast: 20,
    allowance: { diameter: 0.5, z: 0.1 },
  },
  partsOff: false,
  withoutCycles: [],
  withoutTools: [],
  labels: ncLabels("en"),
  ...more,
});

/** Most actions of a plan. */
const MOST = 30;

/** The first action that works, again and again, in the order of the sources; `onTried` hears every try. */
export function greedyPlan(request: PlanRequest, onTried: (tried: TriedAction) => void = () => undefined): PlanState {
  let state: PlanState = { stock: request.blank, done: [], threads: new Set() };
  while (state.done.length < MOST) {
    const next = firstWorking(state, request, onTried);
    if (!next) break;
    state = {
      stock: next.stock,
      done: [...state.done, next],
      threads: new Set([...state.threads, ...next.action.threads]),
    };
  }
  return state;
}

function firstWorking(state: PlanState, request: PlanRequest, onTried: (tried: TriedAction) => void) {
  for (const source of actionSources)
    for (const action of source.actions(state, request)) {
      const tried = applyAction(action, state, request);
      onTried(tried);
      if (tried.works) return tried;
    }
  return null;
}

/** The program of a plan. */
export const programOf = ({ done }: PlanState, request: PlanRequest): Program =>
  done.reduce(
    (program, { action }) => withAction(program, action, request, { title: action.kind }),
    request.begun ?? parse(emptyProgram(request.part.name, cylinderAround(request.blank))),
  );

/** The verdict on a program that is read again from its text. */
export function judged(program: Program, { shop, clamping }: PlanRequest) {
  const made = run(parse(print(program)), shop);
  const simulation = simulate({ ...made, clamping });
  return { ...verdictOf(made, simulation), findings: simulation.findings, stock: simulation.final };
}
