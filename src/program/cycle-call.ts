import type { Cycle, Given } from "../cycles/define.ts";
import { cycleByNumber } from "../cycles/index.ts";
import type { Params, Values } from "../cycles/params.ts";
import { issue, type Issue } from "../kernel/issue.ts";
import type { Plan } from "../kernel/plan.ts";
import { empty } from "../kernel/strategy/leveled.ts";
import type { Pt, Segment } from "../kernel/point.ts";
import type { Tool } from "../kernel/tool.ts";
import { toDiameter } from "../kernel/units.ts";
import { readContour } from "./contour-subprogram.ts";
import { cycleValues } from "./cycle-values.ts";
import { programIssue } from "./issue.ts";
import type { Defined, Machine } from "./machine.ts";
import { rotation } from "./blank-form.ts";
import { rankTools } from "./which-tool.ts";

const nothing: Plan = empty([]);

const unique = (issues: readonly Issue[]) =>
  [...new Map(issues.map((i) => [JSON.stringify([i.code, i.at ?? "", i.data]), i])).values()];

/** Line of a parameter inside its definition, from 0. */
function lineOf(raw: string, q: string): number {
  const at = new RegExp(String.raw`(?:^|[\r\n])[ \t]*${q}(?!\d)`, "i").exec(raw);
  return at ? raw.slice(0, at.index + 1).split(/\r\n|\n|\r/).length - 1 : 0;
}

/** The contour that cycle 14 names, with its issues said at their blocks. */
function givenContour(machine: Machine, cycle: number, index: number, operation: number): readonly Segment[] | null {
  if (machine.contourLabels.length === 0) {
    const { contourFile: file } = machine;
    machine.say(file === null ? programIssue("contourNotNamed", "error", { cycle }) : programIssue("contourInFile", "error", { file }), index);
    return null;
  }
  const read = machine.contourLabels.map((label) => readContour(machine, label, index));
  for (const r of read) for (const i of r?.contour.issues ?? []) {
    const element = "element" in i.data ? i.data.element : 0;
    machine.say(i, r?.blocks[element - 1] ?? index, 0, operation);
  }
  const segments = read.flatMap((r) => r?.contour.segments ?? []);
  return segments.length > 0 ? segments : null;
}

/**
 * A part of a program that calls no tool is shown all the same, with the tool of the table that makes most of its contour;
 * that no tool is called has been said, as an error.
 */
function standIn(machine: Machine, cycle: Cycle, values: Values<Params> | null, given: Given, start: Pt, index: number): Tool | null {
  if (!values || (cycle.contour === "free" && !given.contour)) return null;
  const best = rankTools(cycle, values, given, { start, feedUnit: machine.feedUnit, autoFeed: machine.toolFeed, stock: null }, machine.shop.tools)[0]?.tool;
  if (best) machine.say(issue("betterTool", "info", { tool: best.T, name: best.NAME }, "tool"), index);
  return best ?? null;
}

/** Executes a cycle call: plans the defined cycle from where the tip stands and runs its moves. */
export function callCycle(machine: Machine, index: number): void {
  const { defined } = machine;
  if (!defined) return machine.say(programIssue("noCycleDefined", "error", {}), index);
  const cycle = cycleByNumber(defined.cycle);
  if (!cycle) {
    const statement = machine.blocks[defined.index]?.statement;
    const name = statement?.kind === "cycle" ? statement.name : "";
    machine.leaveUnproved(`CYCL DEF ${defined.cycle} ${name}`.trim(), index);
    return machine.say(programIssue("cycleNotSimulated", "warning", { cycle: defined.cycle, name }), index);
  }
  if (!machine.turning) machine.say(programIssue("notInTurnMode", "error", {}), index);
  if (!machine.tool) machine.say(programIssue("noToolCalled", "error", {}), index);
  const start = machine.tip;
  if (!start) return machine.say(programIssue("startUnknown", "error", {}), index);
  if (!machine.sure.x || !machine.sure.z) machine.say(programIssue("startUnknown", "warning", {}), index);
  if (!machine.spindle) machine.say(programIssue("spindleMissing", "warning", {}), index);
  if (!machine.roomForOperation(index)) return;
  const operation = machine.operations.length;
  const given: Given = { contour: cycle.contour === "free" ? givenContour(machine, cycle.number, index, operation) : null, start };
  const { values, issues } = cycleValues(machine, cycle, defined.values);
  const tool = machine.tool ?? standIn(machine, cycle, values, given, start, index);
  if (!tool) return;
  // What earlier cycles have left is known to the simulation only.
  const stock = operation === 0 && machine.blank.length > 0 ? machine.blank : null;
  const setting = { tool, start, feedUnit: machine.feedUnit, autoFeed: machine.toolFeed, stock };
  const plan = values && (cycle.contour === "own" || given.contour) ? cycle.plan(values, setting, given) : nothing;
  const outlined = values && plan !== nothing ? cycle.outline(values, given).issues : [];
  const all = unique([...issues, ...outlined, ...plan.issues]);
  const firstStep = machine.steps.length;
  let [from, seconds] = [start, 0];
  for (const move of plan.moves) {
    seconds += machine.step(from, move, index, operation, plan.tool ?? tool);
    from = move.to;
  }
  machine.z = from.z;
  machine.x = toDiameter(from.r);
  machine.last = null;
  machine.operations.push({
    block: machine.numbers[index] ?? 0, definedIn: machine.numbers[defined.index] ?? 0, definedLine: machine.lines[defined.index] ?? 1,
    cycle: cycle.number, tool, start, feedUnit: machine.feedUnit, spindle: machine.spindle, plan, seconds,
    firstStep, lastStep: machine.steps.length - 1, issues: all,
    call: values && { values, given, autoFeed: machine.toolFeed },
  });
  for (const i of all) {
    const parameter = i.at?.startsWith("Q") ? i.at : null;
    if (parameter) machine.say(i, defined.index, lineOf(machine.blocks[defined.index]?.raw ?? "", parameter), operation);
    else machine.say(i, index, 0, operation);
  }
}

/** Takes up a definition; parameters are read now, as the control does, and stand in Q parameters of their number. */
export function defineCycle(machine: Machine, index: number): void {
  const s = machine.blocks[index]?.statement;
  if (s?.kind !== "cycle") return;
  if (!cycleByNumber(s.cycle)) machine.say(programIssue("cycleNotSimulated", "info", { cycle: s.cycle, name: s.name }), index);
  if (ACTIVE_AT_ONCE.has(s.cycle)) return;
  const values = new Map<string, number | "auto" | null>();
  for (const p of s.parameters) {
    if (p.value === null || p.value === "max") values.set(p.q, null);
    else if (p.value === "auto") values.set(p.q, "auto");
    else values.set(p.q, machine.number(p.value, index));
  }
  values.forEach((v, q) => typeof v === "number" && machine.parameters.set(q, v));
  machine.defined = { index, cycle: s.cycle, values } satisfies Defined;
}

/** Cycles that act where they are defined and leave the defined machining cycle as it is: datum, mirror, dwell and the like. */
const ACTIVE_AT_ONCE: ReadonlySet<number> = new Set([7, 8, 9, 10, 11, 12, 13, 14, 19, 20, 26, 32, 247, 800, 801]);

/** The blank that a label outlines. */
export function outlinedBlank(machine: Machine, label: number | string, radii: boolean, index: number): void {
  const read = readContour(machine, label, index, radii);
  if (!read) return;
  for (const i of read.contour.issues) machine.say(i, read.blocks["element" in i.data ? i.data.element - 1 : 0] ?? index);
  const rings = rotation(read.contour.segments);
  if (rings) machine.blank = rings;
  else machine.say(programIssue("blankImpossible", "error", {}), index);
}
