import { areaOf } from "../../kernel/area/area.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { radius, toDiameter } from "../../kernel/units.ts";
import { outlineOfLines, targetPart } from "../target-part.ts";
import type { Task } from "../task.ts";
import { judgeUnplaced } from "./judge.ts";
import type { Answer, RuleName, Slip, TaskJudgement, TaskMark } from "./judgement.ts";
import { toolsFor, toolSlips, type SlipTrial } from "./tool-slips.ts";
import { everySlip, type Literal, type PossibleSlip } from "./possible-slips.ts";

/*
 * The commonest slips: exchanged tools; in dimensions a wrong sign, a radius for a diameter or the reverse, exchanged
 * values, a misplaced decimal point; a contour in the wrong direction, exchanged blocks, a missing call. Each is undone in the learner's program, and the run decides
 * whether it explains the fault.
 */

/** Most runs for one check, and of these most for its tools. */
const MOST_RUNS = 24;
const MOST_TOOL_RUNS = 8;
/** A slip explains a fault if undoing it leaves at most this share of the wrong area. */
const LEFT_OVER = 0.25;
/** The order in which slips are tried: first those whose values are sizes of the part. */
const LIKELY = {
  call: 0,
  exact: 1,
  exchanged: 2,
  reversed: 3,
  near: 4,
  paired: 5,
  size: 6,
  either: 7,
  start: 8,
  order: 9,
  no: 10,
} as const;
/** Slips that are named only where the part is right without them, as those that are less likely. */
const WHOLLY: ReadonlySet<Slip["kind"]> = new Set(["call", "order", "point", "side", "relative"]);
/** A value may be this far from the corner of the part that it makes, mm: roundings, chamfers, tapers lie between. */
const BESIDE = 2;
/** Rules that a dimension can break; the others concern feeds, tools and times. */
export const BY_DIMENSIONS: ReadonlySet<RuleName> = new Set([
  "errors",
  "unproved",
  "rapid",
  "holder",
  "gouge",
  "missing",
  "residue",
  "size",
]);

/** Diameters and Z of the target part, mm. */
export function wantedSizes(task: Task): { readonly x: readonly number[]; readonly z: readonly number[] } {
  const { part, sizes = [] } = task;
  const outlines = [part?.outside, part?.bore].flatMap((lines) => (lines ? outlineOfLines(lines).segments : []));
  const points = [...outlines.flatMap(({ from, to }) => [from, to]), ...(part ? targetPart(part).blank.flat() : [])];
  const threads = part?.threads ?? [];
  return {
    x: [
      ...points.map(({ r }) => toDiameter(radius(r))),
      ...sizes.map(({ kind, at, nominal }) => (kind === "face" ? at : nominal)),
      ...threads.flatMap(({ crest, root }) => [crest, root]),
    ],
    z: [
      ...points.map(({ z }) => z),
      ...sizes.map(({ kind, at, nominal }) => (kind === "face" ? nominal : at)),
      ...threads.flatMap(({ from, to }) => [from, to]),
    ],
  };
}

/** The programs without a slip that a learner may have made in one, the likeliest first. */
function slipTrials(task: Task, text: string): readonly (SlipTrial & { readonly likely: number })[] {
  const wanted = wantedSizes(task);
  /** Distance of a value from the nearest size of the part. */
  const off = ({ measure }: Literal, value: number) =>
    wanted[measure === "diameter" ? "x" : "z"].reduce(
      (least, size) => Math.min(least, Math.abs(size - value)),
      Infinity,
    );
  const isWanted = (literal: Literal, value: number) => off(literal, value) < BESIDE;
  const rank = ({ slip: { kind }, changes }: PossibleSlip): number => {
    if (kind === "reversed" || kind === "order" || kind === "call") return LIKELY[kind];
    const isExact = changes.every(({ literal, to }) => off(literal, to) < SAME);
    if (kind === "point") {
      const [change] = changes;
      if (change?.literal.measure === "size") return LIKELY.size;
      if (!change || isWanted(change.literal, change.literal.value)) return LIKELY.no;
      // A start point or an end in the air is no size of the part.
      return isExact ? LIKELY.exact : Math.abs(change.to) < Math.abs(change.literal.value) ? LIKELY.size : LIKELY.no;
    }
    // Exact sizes only: about any value is beside the other end of a contour.
    if (kind === "side" || kind === "relative") {
      const isOff = changes.every(({ literal }) => off(literal, literal.value) > SAME);
      return isExact && isOff ? LIKELY.exact : LIKELY.no;
    }
    const improves = changes.some(
      ({ literal, to }) => isWanted(literal, to) && off(literal, to) < off(literal, literal.value) - SAME,
    );
    if (kind === "exchanged") {
      if (changes.every(({ literal }) => literal.measure === "size")) return LIKELY.size;
      if (improves) return LIKELY.exchanged;
      // Two values of one axis that are both sizes of the part may still be in each other's place.
      const isOneAxis = new Set(changes.map(({ literal }) => literal.measure)).size === 1;
      const fits = changes.every(({ literal, to }) => isWanted(literal, to) || isWanted(literal, literal.value));
      return isOneAxis && fits ? LIKELY.paired : LIKELY.no;
    }
    if (improves) return isExact ? LIKELY.exact : LIKELY.near;
    if (changes.every(({ literal, to }) => isWanted(literal, to))) return LIKELY.either;
    // Positions off the part are start points and retractions: one in the steel may have a wrong sign.
    const isStart = changes.every(
      ({ literal, to }) => literal.value < 0 && !isWanted(literal, literal.value) && to > 0,
    );
    return kind === "sign" && isStart ? LIKELY.start : LIKELY.no;
  };
  return everySlip(text)
    .map((trial) => ({ ...trial, likely: rank(trial) }))
    .filter(({ likely }) => likely !== LIKELY.no)
    .toSorted((a, b) => a.likely - b.likely);
}

/** How wrong an answer is in its dimensions: its errors, and the wrong area, mm². */
function wrongness({ marks }: TaskJudgement): {
  readonly errors: number;
  readonly area: number;
  readonly any: boolean;
} {
  const failed = marks.filter(({ passed, rule }) => !passed && BY_DIMENSIONS.has(rule));
  const areaIn = ({ rule, about, value = 0, rings = [] }: TaskMark) => {
    if (rule !== "missing" && rule !== "residue") return 0;
    return about === undefined ? value : areaOf(rings);
  };
  return {
    errors: failed.filter(({ rule }) => rule !== "missing" && rule !== "residue" && rule !== "size").length,
    area: failed.reduce((sum, mark) => sum + areaIn(mark), 0),
    any: failed.length > 0,
  };
}

const failedRules = ({ marks }: TaskJudgement): ReadonlySet<RuleName> =>
  new Set(marks.flatMap(({ passed, rule }) => (passed ? [] : [rule])));

/** The tool that explains a failed check: with the other one the part is made, and fewer rules fail, none more. */
async function findToolSlip(
  task: Task,
  text: string,
  judgement: TaskJudgement,
  runOf: (text: string) => Promise<Answer | null>,
): Promise<FoundSlip | null> {
  const failed = failedRules(judgement);
  if (failed.size === 0) return null;
  for (const trial of toolSlips(task, text).slice(0, MOST_TOOL_RUNS)) {
    const answer = await runOf(trial.text);
    if (!answer) continue;
    const without = judgeUnplaced(task, answer),
      left = failedRules(without);
    if (!wrongness(without).any && left.size < failed.size && [...left].every((rule) => failed.has(rule)))
      return { slip: trial.slip, without };
  }
  return null;
}

/** A slip that explains a failed check, and the judgement of the program without it. */
export interface FoundSlip {
  readonly slip: Slip;
  readonly without: TaskJudgement;
}

/**
 * The slip that explains a failed check: without it the run makes the part, or at least most of what was wrong is gone.
 */
export async function findSlip(
  task: Task,
  { text }: Answer,
  judgement: TaskJudgement,
  runOf: (text: string) => Promise<Answer | null>,
): Promise<FoundSlip | null> {
  const byTools = await findToolSlip(task, text, judgement, runOf);
  if (byTools) return byTools;
  const before = wrongness(judgement);
  if (!before.any) return null;
  let best: (FoundSlip & { readonly area: number }) | null = null;
  for (const trial of slipTrials(task, text).slice(0, MOST_RUNS)) {
    const answer = await runOf(trial.text);
    if (!answer) continue;
    const without = judgeUnplaced(task, answer),
      after = wrongness(without);
    if (!after.any) return { slip: trial.slip, without };
    if (trial.likely >= LIKELY.near || WHOLLY.has(trial.slip.kind)) continue;
    const isBetter = after.errors <= before.errors && after.area <= before.area * LEFT_OVER && before.area > 0;
    if (isBetter && after.area < (best?.area ?? Infinity)) best = { slip: trial.slip, without, area: after.area };
  }
  return best && { slip: best.slip, without: best.without };
}

/** Whether a program contains the values of a slip: a task that asks for it is not to give it away. */
export const hasSlip = (task: Task, text: string, slip: Slip): boolean =>
  [...everySlip(text), ...toolSlips(task, text)].some((each) => keyOf(each.slip) === keyOf(slip));

const keyOf = ({ kind, values }: Slip): string => JSON.stringify([kind, values.map(({ q, value }) => [q, value])]);

/**
 * The judgement of an answer that no slip explains: where a tool is refused that the task does not need, it is to blame;
 * a tool of the solution is refused for its values.
 */
export const withoutSlip = (task: Task, { run }: Answer, judgement: TaskJudgement): TaskJudgement => {
  const right = toolsFor(task);
  const isByTool = ({ issue, operation = -1 }: TaskMark) =>
    issue?.code === "toolUnfit" && !right.has(run.operations[operation]?.tool.T ?? -1);
  return {
    ...judgement,
    marks: judgement.marks.map((mark) => (isByTool(mark) ? { ...mark, isByTool: true } : mark)),
  };
};

/**
 * The judgement with the slip as its first mark, at the place of the gravest one. Errors that the program without the
 * slip does not have are its consequences, and not reported.
 */
export function withSlip(judgement: TaskJudgement, { slip, without }: FoundSlip): TaskJudgement {
  const remaining = new Set(without.marks.flatMap(({ passed, issue }) => (passed || !issue ? [] : [issue.code])));
  const failed = judgement.marks.filter(({ passed }) => !passed);
  const isConsequence = ({ passed, rule, issue }: TaskMark) =>
    !passed && rule === "errors" && issue !== undefined && !remaining.has(issue.code);
  const shown = failed.find(({ place }) => place !== undefined);
  const [first] = slip.values;
  const mark: TaskMark = {
    rule: failed.find(({ rule }) => BY_DIMENSIONS.has(rule))?.rule ?? "errors",
    passed: false,
    slip,
    ...(first && { block: first.block }),
    ...(first?.q.startsWith("Q") && { q: first.q }),
    ...(shown?.place && { place: shown.place }),
    ...(shown?.operation !== undefined && { operation: shown.operation }),
  };
  return { ...judgement, marks: [mark, ...judgement.marks.filter((each) => !isConsequence(each))] };
}
