import { intersection } from "../kernel/area/clip.ts";
import type { Clamping } from "../kernel/area/clamping.ts";
import { rounded } from "../kernel/units.ts";
import { parse } from "../nc/parse.ts";
import { print, type Program } from "../nc/program.ts";
import { withClamping } from "../program/clamping/draft.ts";
import type { ClampingDraft, ClampingWord } from "../program/clamping/words.ts";
import { withShapedBlank } from "../program/edits/second-side.ts";
import { emptyProgram } from "../program/job/empty-program.ts";
import { cylinderAround } from "../program/job/requested-shape.ts";
import { run } from "../program/run/run.ts";
import { verdictOf } from "../report/verdict.ts";
import { simulate } from "../sim/simulate.ts";
import { isShaped } from "./actions/near-net.ts";
import { areaBeyond, leftBy, withAction } from "./apply-action.ts";
import type { Action, PlanRequest } from "./types.ts";
import type { WorkingPlan } from "./working-plan.ts";

/** A clamping as typed. */
function draftOf({ kind, diameter, length, face, size, tailstock, limit }: Clamping): ClampingDraft {
  const values: Readonly<Partial<Record<ClampingWord, number | undefined>>> = {
    D: diameter,
    LENGTH: length,
    FACE: face,
    SIZE: size,
    QUILL: tailstock?.quill,
    TIP: tailstock?.tip,
    ANGLE: tailstock?.angle,
    LIMITZ: limit?.z,
    LIMITX: limit?.x,
  };
  const words = Object.entries(values).flatMap(([word, n]) => (n === undefined ? [] : [[word, String(rounded(n))]]));
  return { kind, words: Object.fromEntries(words) as Record<string, string> };
}

/** A program with blank and clamping, and no operation. */
function emptyOf({ part, blank, clamping, begun }: PlanRequest): Program {
  if (begun) return begun;
  const program = isShaped(blank)
    ? withShapedBlank(parse(emptyProgram(part.name, null)), blank)
    : parse(emptyProgram(part.name, cylinderAround(blank)));
  return clamping ? withClamping(program, draftOf(clamping.clamping)) : program;
}

/** The check of a whole program. */
export type WholeProgram = Pick<
  WorkingPlan,
  "text" | "seconds" | "programSeconds" | "changeSeconds" | "tools" | "toolChanges" | "stock" | "judged" | "gouge"
>;

/** The program of a plan, each action under its title, run and cut as one. */
export function wholeProgram(actions: readonly Action[], request: PlanRequest): WholeProgram {
  const { shop, rules, titles, part } = request;
  // Operations on the same contour share its label; the blank may have one.
  const begin = emptyOf(request);
  const taken = begin.blocks.filter(({ statement: s }) => s.kind === "label" && s.label !== 0).length;
  const contours = new Map<string, number>();
  const program = actions.reduce((all, action) => {
    const rows = JSON.stringify(action.job.contour);
    const isOwn = action.cut !== undefined || action.job.contour.length === 0;
    const contour = contours.get(rows);
    if (!isOwn && contour === undefined) contours.set(rows, taken + contours.size + 1);
    const title = titles?.[action.kind];
    return withAction(all, action, request, {
      ...(title !== undefined && { title }),
      ...(!isOwn && contour !== undefined && { contour }),
    });
  }, begin);
  const text = print(program);
  const made = run(parse(text), shop);
  const simulation = simulate(made);
  const stock = leftBy(simulation, actions, part.rings);
  const changes = actions.filter(({ tool }, i) => tool.T !== actions[i - 1]?.tool.T).length;
  const changeSeconds = shop.machine?.toolChange === undefined ? changes * rules.toolChange : 0;
  return {
    text,
    seconds: made.seconds + changeSeconds,
    programSeconds: made.seconds,
    changeSeconds,
    tools: [...new Set(actions.map(({ tool }) => tool.T))],
    toolChanges: changes,
    stock,
    judged: verdictOf(made, simulation),
    gouge: areaBeyond(intersection(request.blank, part.rings), stock),
  };
}
