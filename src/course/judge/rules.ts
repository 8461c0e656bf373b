import { producedParts } from "../../sim/produced-parts.ts";
import { REAL_AREA } from "../../kernel/area/real-area.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { cycleByNumber } from "../../cycles/index.ts";
import type { Param, Topic } from "../../cycles/params.ts";
import { parse } from "../../nc/parse.ts";
import { blockNumbers } from "../../nc/program.ts";
import type { Operation } from "../../program/state/run-types.ts";
import { roughnessOf } from "../../sim/load/roughness.ts";
import type { TaskRules } from "../task.ts";
import type { Answer, TaskMark, RuleName } from "./judgement.ts";
import { depthsBeyondLimit } from "./hand-depth.ts";
import { foreignToolMarks, secondsOfAnswer } from "./shop.ts";
import { wordMarks } from "./word-rule.ts";

/** Tolerance of a measured depth, mm: passes are levelled, and the stock consists of chords. */
const DEPTH_SLACK = 0.02;
/** Stretches of a surface within this of an end of the Z range are its ends, mm. */
const SURFACE_END = 0.05;

const ofCall = ({ block }: Operation, operation: number) => ({ block, operation });
const ofDefinition = ({ definedIn }: Operation, operation: number) => ({ block: definedIn, operation });

/** One failed mark for each violation, or one passed mark without any. */
const marks = (rule: RuleName, wrong: readonly Partial<TaskMark>[], right: Partial<TaskMark> = {}): TaskMark[] =>
  wrong.length > 0 ? wrong.map((w) => ({ rule, passed: false, ...w })) : [{ rule, passed: true, ...right }];

/** Whether an operation has roughing passes, and how many. */
export const hasRoughing = ({ plan }: Operation) => plan.moves.some((move) => move.phase === "rough");

/** The passes of a call, those of a thread too; 0 where it only finishes. */
export const roughingPasses = ({ plan }: Operation) =>
  plan.moves.some(({ phase }) => phase === "rough" || phase === "thread") ? plan.passes : 0;

/** The prompt of a call that a topic of its cycle belongs to, with its value. */
function promptOf({ cycle, call }: Operation, topic: Topic): { readonly q: string; readonly value: number } | null {
  const params: Readonly<Record<string, Param>> = cycleByNumber(cycle)?.params ?? {};
  const [q] = Object.entries(params).find(([, { shown }]) => shown === topic) ?? [];
  const value = q === undefined ? undefined : (call?.values as Readonly<Record<string, unknown>> | undefined)?.[q];
  return q !== undefined && typeof value === "number" ? { q, value } : null;
}

/** The prompt that decides a depth beyond the limit: the infeed, or what was left for the finishing cut. */
function decidingPrompt(operation: Operation | undefined, limit: number, isFinishing: boolean): Partial<TaskMark> {
  if (!operation) return {};
  const prompt = (topic: Topic) => promptOf(operation, topic);
  const infeed = prompt("infeed") ?? prompt("depthLimit"),
    oversize = prompt("oversizeDiameter");
  const isOversize = oversize && oversize.value > 2 * limit;
  const leftOver = isOversize ? oversize : prompt(hasRoughing(operation) ? "oversizeZ" : "operation");
  const decides = isFinishing ? leftOver : infeed && (infeed.value > limit || infeed.value === 0) ? infeed : null;
  return decides ? { q: decides.q } : {};
}

function depth(limit: number, answer: Answer): TaskMark[] {
  const { run, simulation } = answer;
  const found = run.operations.map((operation, index): Partial<TaskMark> => {
    const deepest = simulation.proof.operations[index]?.deepest;
    // Passes along the contour count only where they cut deeper than their cycle allows.
    const infeed = operation.plan.isParallel && hasRoughing(operation) ? operation.plan.infeed : 0;
    const by = deepest && deepest.depth >= infeed ? { step: deepest.step } : {};
    return { value: Math.max(deepest?.depth ?? 0, infeed), limit, ...by, ...ofCall(operation, index) };
  });
  const all = [...found, ...depthsBeyondLimit(answer, limit + DEPTH_SLACK).map((mark) => ({ ...mark, limit }))];
  const most = all.reduce((sum, { value = 0 }) => Math.max(sum, value), 0);
  const isFinishing = ({ step = -1 }: Partial<TaskMark>) => run.steps[step]?.move.phase === "finish";
  return marks(
    "depth",
    all
      .filter(({ value = 0 }) => value > limit + DEPTH_SLACK)
      .map((mark) => ({ ...mark, ...decidingPrompt(run.operations[mark.operation ?? -1], limit, isFinishing(mark)) })),
    { value: most, limit },
  );
}

/** The last block before a step that sets the spindle speed. */
function spindleBlock({ text, run }: Answer, step: number): Partial<TaskMark> {
  const program = parse(text);
  const until = run.stepBlocks[step] ?? 0;
  const index = program.blocks.findLastIndex(
    ({ statement: s }, i) => i <= until && (s.kind === "spin" || (s.kind === "toolCall" && s.speed !== null)),
  );
  return index < 0 ? {} : { block: blockNumbers(program)[index] ?? 0 };
}

function speed(limit: number, answer: Answer): TaskMark[] {
  const { spindles, steps } = answer.run;
  const inForce = spindles.filter(({ step }, i) => step < (spindles[i + 1]?.step ?? steps.length));
  const fastest = ({ spindle }: (typeof spindles)[number]) =>
    spindle?.kind === "constant" ? spindle.speed : spindle && spindle.limit > 0 ? spindle.limit : Infinity;
  const wrong = inForce.filter((s) => s.spindle && fastest(s) > limit);
  const most = inForce.reduce((sum, s) => (s.spindle ? Math.max(sum, fastest(s)) : sum), 0);
  return marks(
    "speed",
    wrong.map((s) => {
      const value = fastest(s);
      return { ...(Number.isFinite(value) && { value }), limit, step: s.step, ...spindleBlock(answer, s.step) };
    }),
    { value: most, limit },
  );
}

/** The tools that a program calls, each with the block of its first call. */
export function calledTools({ text, run }: Answer): Map<number, number> {
  const program = parse(text);
  const numbers = blockNumbers(program);
  const called = new Map<number, number>();
  const note = (tool: number, block: number) => void (called.has(tool) || called.set(tool, block));
  program.blocks.forEach(
    ({ statement: s }, i) => s.kind === "toolCall" && typeof s.tool === "number" && note(s.tool, numbers[i] ?? 0),
  );
  for (const { tool, block } of [...run.steps, ...run.operations]) note(tool.T, block);
  return called;
}

/** Checks the value of one parameter in the called cycles. */
function values(asked: NonNullable<TaskRules["values"]>, { run }: Answer): TaskMark[] {
  return asked.flatMap(({ q, cycle, from = -Infinity, to = Infinity }, entry) => {
    const found = run.operations.flatMap((operation, index) => {
      if (cycle !== undefined && operation.cycle !== cycle) return [];
      const values: Readonly<Record<string, number | "auto">> = operation.call?.values ?? {};
      return q in values ? [{ value: values[q], ...ofDefinition(operation, index) }] : [];
    });
    const isRight = (value: unknown) => typeof value === "number" && value >= from - SAME && value <= to + SAME;
    const wrong = found.filter(({ value }) => !isRight(value));
    const told = (wrong.length > 0 ? wrong : found.slice(0, 1)).map(({ value, ...where }): Partial<TaskMark> => ({
      ...where,
      q,
      entry,
      ...(typeof value === "number" && { value }),
    }));
    if (found.length === 0) return marks("values", [{ q, entry }]);
    return marks("values", wrong.length > 0 ? told : [], told[0]);
  });
}

function passes(limit: number, { run }: Answer): TaskMark[] {
  const value = run.operations.reduce((sum, o) => sum + roughingPasses(o), 0);
  const index = run.operations.findIndex(hasRoughing);
  const operation = run.operations[index],
    infeed = operation && value !== limit ? promptOf(operation, "infeed") : null;
  const decides = infeed && { q: infeed.q };
  return [
    {
      rule: "passes",
      passed: value === limit,
      value,
      limit,
      ...(operation && { ...ofCall(operation, index), ...decides }),
    },
  ];
}

/** The greatest Rz of the made surface between two Z. A stretch without a known feed per revolution is too rough. */
function rz(asked: NonNullable<TaskRules["rz"]>, { run, simulation }: Answer): TaskMark[] {
  const all = roughnessOf(producedParts(simulation), run.steps, run.spindles);
  return asked.map(({ from, to, most }, entry): TaskMark => {
    const [low, high] = [Math.min(from, to), Math.max(from, to)];
    const inside = all.filter(({ points, rz: height, by }) => {
      const z = points.map((p) => p.z);
      const reach = Math.min(high, Math.max(...z)) - Math.max(low, Math.min(...z));
      const isFace = Math.max(...z) - Math.min(...z) < SAME;
      const within = isFace ? (z[0] ?? 0) > low + SURFACE_END && (z[0] ?? 0) < high - SURFACE_END : reach > SURFACE_END;
      return within && (height !== null || by === "unknown");
    });
    const worst = inside.toSorted((a, b) => (b.rz ?? Infinity) - (a.rz ?? Infinity))[0];
    if (!worst) return { rule: "rz", passed: false, limit: most, entry };
    const { block, operation, position, points, rz: value } = worst;
    const where = { block, step: position.step, ...(operation !== null && { operation }) };
    const place = points[Math.floor(points.length / 2)];
    return {
      rule: "rz",
      passed: value !== null && value <= most,
      limit: most,
      entry,
      ...(value !== null && { value }),
      ...(place && { place }),
      ...where,
    };
  });
}

/** Checks an answer against the rules of a task: one mark or more for each rule. */
export function ruleMarks(rules: TaskRules, answer: Answer): TaskMark[] {
  const { run, simulation } = answer;
  const out: TaskMark[] = foreignToolMarks(answer);
  if (rules.depth !== undefined) out.push(...depth(rules.depth, answer));
  if (rules.speed !== undefined) out.push(...speed(rules.speed, answer));
  const called = rules.tools || rules.mostTools !== undefined ? calledTools(answer) : new Map<number, number>();
  const { tools, mostTools: most, seconds } = rules;
  if (tools) {
    const others = [...called].filter(([tool]) => !tools.includes(tool));
    out.push(
      ...marks(
        "tools",
        others.map(([about, block]) => ({ about, block })),
      ),
    );
  }
  if (most !== undefined) {
    const [, block] = [...called][most] ?? [];
    out.push({
      rule: "mostTools",
      passed: called.size <= most,
      value: called.size,
      limit: most,
      ...(block !== undefined && { block }),
    });
  }
  if (seconds !== undefined)
    out.push({
      rule: "seconds",
      passed: secondsOfAnswer(answer) <= seconds,
      value: secondsOfAnswer(answer),
      limit: seconds,
    });
  const cuts = (index: number) => (simulation.proof.operations[index]?.cut ?? 0) >= REAL_AREA;
  for (const about of rules.cycles ?? []) {
    const index = run.operations.findIndex((o, i) => o.cycle === about && (cuts(i) || o.plan.thread !== undefined));
    const operation = run.operations[index];
    out.push({ rule: "cycles", passed: operation !== undefined, about, ...(operation && ofCall(operation, index)) });
  }
  if (rules.without) {
    const called = run.operations.flatMap((o, i) =>
      rules.without?.includes(o.cycle) ? [{ about: o.cycle, ...ofCall(o, i) }] : [],
    );
    out.push(...marks("without", called));
  }
  if (rules.values) out.push(...values(rules.values, answer));
  if (rules.passes !== undefined) out.push(...passes(rules.passes, answer));
  if (rules.rz) out.push(...rz(rules.rz, answer));
  if (rules.words) out.push(...wordMarks(rules.words, answer.text));
  return out;
}
