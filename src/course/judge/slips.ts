import { areaOf } from "../../kernel/area/area.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { radius, toDiameter } from "../../kernel/units.ts";
import { cycleByNumber } from "../../cycles/index.ts";
import type { Param } from "../../cycles/params.ts";
import { parse } from "../../nc/parse.ts";
import { blockNumbers, type Block } from "../../nc/program.ts";
import { outlineOfLines, targetPart } from "../target-part.ts";
import type { Task } from "../task.ts";
import { judge } from "./judge.ts";
import type { Answer, RuleName, Slip, SlipValue, TaskJudgement, TaskMark } from "./judgement.ts";
import { toolSlips, type SlipTrial } from "./tool-slips.ts";
import { reversedContours } from "./reversed-contour.ts";

/*
 * The commonest slips: exchanged tools, and in dimensions a wrong sign, a radius for a diameter or the reverse,
 * exchanged values, a contour in the wrong direction. Each is undone in the learner's program, and the run decides
 * whether it explains the fault.
 */

/** Most runs for one check, and of these most for its tools. */
const MOST_RUNS = 24;
const MOST_TOOL_RUNS = 8;
/** A slip explains a fault if undoing it leaves at most this share of the wrong area. */
const LEFT_OVER = 0.25;
/** The order in which slips are tried: first those whose values are sizes of the part. */
const LIKELY = { exact: 0, exchanged: 1, reversed: 2, near: 3, either: 4, start: 5, no: 6 } as const;
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

const NUMBER = String.raw`([+-]?\d+(?:\.\d+)?|[+-]?\.\d+)`;
const written = (value: number): string => `${value < 0 ? "-" : "+"}${Math.abs(Math.round(value * 1000) / 1000)}`;

/** A number in the text of a block, with its place. */
interface Literal extends Omit<SlipValue, "better"> {
  readonly index: number;
  readonly kind: Param["kind"] | "x" | "z";
  readonly place: Param["place"] | null;
}

/** The dimensions in a block that a slip can change: positions of a cycle, or X and Z of a path. */
function literalsOf({ statement: s, raw }: Block, index: number, block: number): readonly Literal[] {
  if (s.kind === "cycle") {
    const params: Readonly<Partial<Record<string, Param>>> = cycleByNumber(s.cycle)?.params ?? {};
    return s.parameters.flatMap(({ q, value }): Literal[] => {
      const param = params[q];
      if (typeof value !== "number" || (param?.kind !== "diameter" && param?.kind !== "axial")) return [];
      if (param.incremental) return [];
      return [{ index, block, q, value, kind: param.kind, place: param.place }];
    });
  }
  if (s.kind !== "path") return [];
  const said = raw.replace(/;.*$/s, "");
  return (["X", "Z"] as const).flatMap((q): Literal[] => {
    const found = new RegExp(String.raw`(?<![A-Z])${q}[ \t]*${NUMBER}(?![\d.])`, "i").exec(said);
    return found ? [{ index, block, q, value: Number(found[1]), kind: q === "X" ? "x" : "z", place: null }] : [];
  });
}

/** The text of a block with another number. */
function withValue(raw: string, q: string, value: number): string {
  const pattern = q.startsWith("Q")
    ? new RegExp(String.raw`((?:^|\s)${q}[ \t]*=?[ \t]*)${NUMBER}`, "i")
    : new RegExp(String.raw`((?<![A-Z])${q}[ \t]*)${NUMBER}`, "i");
  return raw.replace(pattern, (_, front: string) => front + written(value));
}

const isDiameter = ({ kind }: Literal): boolean => kind === "diameter" || kind === "x";

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

interface Change {
  readonly literal: Literal;
  readonly to: number;
}
interface PossibleSlip extends SlipTrial {
  /** Empty for a reversed contour. */
  readonly changes: readonly Change[];
}

/** Every program that differs from a program by one slip. */
export function everySlip(text: string): readonly PossibleSlip[] {
  const program = parse(text),
    numbers = blockNumbers(program),
    { blocks } = program;
  const literals = blocks.flatMap((block, i) => literalsOf(block, i, numbers[i] ?? 0));
  const put = (kind: Slip["kind"], ...changes: readonly Change[]): PossibleSlip => ({
    slip: { kind, values: changes.map(({ literal: { block, q, value }, to }) => ({ block, q, value, better: to })) },
    changes,
    text: blocks
      .map(({ raw }, i) =>
        changes.reduce((now, { literal: { index, q }, to }) => (index === i ? withValue(now, q, to) : now), raw),
      )
      .join(""),
  });
  const single = literals
    .filter(({ value }) => Math.abs(value) > SAME)
    .flatMap((literal) =>
      isDiameter(literal)
        ? [put("radius", { literal, to: 2 * literal.value }), put("doubled", { literal, to: literal.value / 2 })]
        : [put("sign", { literal, to: -literal.value })],
    );
  // Who takes the radius for the diameter often does so for all values of a cycle.
  const inCycles = literals.filter((each) => each.q.startsWith("Q") && isDiameter(each) && Math.abs(each.value) > SAME);
  const whole = [...new Set(inCycles.map(({ index }) => index))]
    .map((cycle) => inCycles.filter(({ index }) => index === cycle))
    .filter((each) => each.length > 1)
    .flatMap((each) => [
      put("radius", ...each.map((literal) => ({ literal, to: 2 * literal.value }))),
      put("doubled", ...each.map((literal) => ({ literal, to: literal.value / 2 }))),
    ]);
  const pairs = literals.flatMap((one, i) =>
    literals.slice(i + 1).flatMap((other) => {
      if (other.index !== one.index || Math.abs(one.value - other.value) < SAME) return [];
      // Start and end of one axis in a cycle; X and Z in a path.
      const isPair = one.place === null || (one.kind === other.kind && one.place !== other.place);
      return isPair ? [put("exchanged", { literal: one, to: other.value }, { literal: other, to: one.value })] : [];
    }),
  );
  const reversed = reversedContours(blocks).map((turned): PossibleSlip => ({
    slip: { kind: "reversed", values: [{ block: numbers[turned.first] ?? 0, q: "", value: 0, better: 0 }] },
    changes: [],
    text: turned.text,
  }));
  return [...single, ...whole, ...pairs, ...reversed];
}

/** The programs without a slip that a learner may have made in one, the likeliest first. */
function slipTrials(task: Task, text: string): readonly SlipTrial[] {
  const wanted = wantedSizes(task);
  /** Distance of a value from the nearest size of the part. */
  const off = (literal: Literal, value: number) =>
    wanted[isDiameter(literal) ? "x" : "z"].reduce((least, size) => Math.min(least, Math.abs(size - value)), Infinity);
  const isWanted = (literal: Literal, value: number) => off(literal, value) < BESIDE;
  const rank = ({ slip: { kind }, changes }: PossibleSlip): number => {
    const improves = changes.some(
      ({ literal, to }) => isWanted(literal, to) && off(literal, to) < off(literal, literal.value) - SAME,
    );
    const fits = changes.every(({ literal, to }) => isWanted(literal, to) || isWanted(literal, literal.value));
    if (kind === "reversed") return LIKELY.reversed;
    if (kind === "exchanged") return improves || fits ? LIKELY.exchanged : LIKELY.no;
    if (improves) return changes.every(({ literal, to }) => off(literal, to) < SAME) ? LIKELY.exact : LIKELY.near;
    if (fits) return LIKELY.either;
    // Positions off the part are start points: one in the steel may have a wrong sign.
    const isStart = changes.every(({ literal }) => literal.kind === "z" && literal.value < 0);
    return kind === "sign" && isStart ? LIKELY.start : LIKELY.no;
  };
  return everySlip(text)
    .map((trial) => ({ trial, likely: rank(trial) }))
    .filter(({ likely }) => likely !== LIKELY.no)
    .toSorted((a, b) => a.likely - b.likely)
    .map(({ trial }) => trial);
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
    const without = judge(task, answer),
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
    const without = judge(task, answer),
      after = wrongness(without);
    if (!after.any) return { slip: trial.slip, without };
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
 * The judgement of an answer that no slip explains: where a tool is refused, its dimensions are not to blame, so the
 * tool is.
 */
export const withoutSlip = (judgement: TaskJudgement): TaskJudgement => ({
  ...judgement,
  marks: judgement.marks.map((mark) => (mark.issue?.code === "toolUnfit" ? { ...mark, isByTool: true } : mark)),
});

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
