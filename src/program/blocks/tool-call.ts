import type { Tool } from "../../kernel/plan/tool.ts";
import { length } from "../../kernel/units.ts";
import type { Statement, StatementOf } from "../../nc/statement.ts";
import type { Parameter } from "../../nc/words.ts";
import { breaksRule } from "../state/control-rule.ts";
import { programIssue } from "../state/issue.ts";
import type { Machine } from "../state/machine.ts";
import type { Modal } from "../state/modal.ts";
import { drillOf } from "../tools/drill-of.ts";
import type { Mill } from "../tools/plane-types.ts";
import { noTool } from "../state/preconditions.ts";

/** TOOL DEF with L and R, as older programs define their tools. */
export function toolDefinition(machine: Machine, s: StatementOf<"toolDefinition">, index: number): void {
  const n = s.radius === null ? null : machine.number(s.radius, index);
  if (n !== null) machine.change({ radii: machine.run.radii.with(s.tool, machine.length(n)) });
}

/** TOOL CALL: feed, tool axis, and the tool of either table with its number or name. */
export function toolCall(machine: Machine, s: StatementOf<"toolCall">, index: number): void {
  if (s.axis !== null) machine.setMill({ otherAxis: s.axis !== "Z" });
  const wanted = typeof s.tool === "object" && s.tool !== null ? toolOf(machine, s.tool, index) : s.tool;
  if (s.tool !== null && machine.now.compensation !== "R0")
    breaksRule(machine, "toolCallCompensated", machine.now.compensation, index);
  if (s.tool !== null) changeTool(machine, wanted);
  if (wanted === null && s.tool !== null) unknownTool(machine);
  if (wanted !== null) takeMill(machine, s, wanted, index);
  if (typeof s.feed === "object" && s.feed) {
    const n = machine.number(s.feed.value, index);
    if (n !== null) machine.set({ toolFeed: machine.feedOf(n), feed: machine.feedOf(n) });
    machine.set({ feedWord: "F" });
  }
  if (wanted !== null) takeTool(machine, s, wanted, index);
  if (s.speed !== null && machine.now.speedElsewhere === null) machine.set({ speedElsewhere: "toolCall" });
}

const toolOf = (machine: Machine, held: Parameter, index: number) =>
  held.parameter.startsWith("QS") ? machine.text(held.parameter, index) : machine.number(held, index);

/** A tool change takes time unless the tool is already in: the index behind the point is another edge of it. */
function changeTool(machine: Machine, wanted: number | string | null): void {
  const {
    shop: { tools, mills = [], machine: data },
    log,
    now,
  } = machine;
  const row = wanted === null ? undefined : (find(tools, wanted) ?? find(mills, wanted));
  const number = row?.T ?? wanted;
  const name = typeof number === "number" ? String(Math.floor(number)) : number;
  if (name !== null && name === now.changedTo) return;
  machine.set({ changedTo: name });
  log.addSeconds("toolChange", data?.toolChange ?? 0);
}

/** The called tool is unknown; the previous one is no longer in the spindle. */
function unknownTool(machine: Machine): void {
  machine.closeArrival();
  machine.setMill({ tool: "", radius: null });
  machine.known.setToolRadius(null);
  machine.setPlace({ sure: { x: false, z: false }, positionedBy: null, last: null });
  machine.set({ compensation: "R0", tool: null, toolRefused: true, corrections: {} });
}

function takeMill(machine: Machine, s: StatementOf<"toolCall">, wanted: number | string, index: number): void {
  const {
    run: { radii },
    shop,
  } = machine;
  const row = find(shop.mills ?? [], wanted);
  const radius = radii.get(wanted) ?? (row ? row.R + (row.DR ?? 0) : null);
  const delta = s.deltaRadius === null ? 0 : (machine.number(s.deltaRadius, index) ?? 0);
  const own = radius === null ? null : Math.max(0, radius + machine.length(delta));
  machine.setMill({ tool: String(wanted), radius: own });
  machine.known.setToolRadius(own === null ? null : own / machine.length(1));
}

function takeTool(machine: Machine, s: StatementOf<"toolCall">, wanted: number | string, index: number): void {
  machine.closeArrival();
  const refused = machine.shop.refused?.get(Number(wanted));
  const tool = refused ? undefined : (find(machine.shop.tools, wanted) ?? drillIn(machine.shop.mills ?? [], wanted));
  machine.setPlace({ sure: { x: false, z: false }, positionedBy: null, homedBy: null, last: null });
  machine.set({ compensation: "R0", tool: tool ? asBefore(machine, tool) : null, toolRefused: !tool, corrections: {} });
  if (refused && typeof wanted === "number") {
    for (const i of refused) machine.log.report(i, index);
  } else if (!tool) notInTable(machine, wanted, index);
  if (tool && ((tool.DZL ?? 0) !== 0 || (tool.DXL ?? 0) !== 0))
    machine.log.report(programIssue("lengthDelta", "info", { tool: tool.T }, "tool"), index);
  // Off the turning plane: the edge may be above or below the axis.
  if (tool && (tool.DYL ?? 0) !== 0) machine.log.leaveUnproved("DYL", index);
  const deltas = [s.deltaLength, s.deltaRadius].some((d) => d !== null && d !== 0);
  if (deltas && tool && machine.now.turning) machine.log.leaveUnproved("DL DR", index);
}

/** Table rows of a tool, with any index. */
function rowsOf({ shop }: Machine, wanted: number): readonly number[] {
  const numbers = [...shop.tools, ...(shop.mills ?? [])].map(({ T }) => T).concat([...(shop.refused?.keys() ?? [])]);
  return numbers.filter((T) => Math.floor(T) === Math.floor(wanted)).sort((a, b) => a - b);
}

/**
 * Neither turning tool nor drill. For a tool with an index, names the rows that exist. An unknown mill may be
 * machine-specific, but not when its tool has rows.
 */
function notInTable(machine: Machine, wanted: number | string, index: number): void {
  const tool = String(wanted);
  const turns = machine.now.turning || turnsLater(machine, index);
  if (typeof wanted === "string" || Number.isInteger(wanted)) {
    if (turns) machine.log.report(programIssue("toolUnknown", "error", { tool }, "tool"), index);
    return;
  }
  const rows = rowsOf(machine, wanted);
  const isMill = find(machine.shop.mills ?? [], wanted) !== undefined || machine.run.radii.has(wanted);
  if (turns || (rows.length > 0 && !isMill))
    machine.log.report(programIssue("toolIndexUnknown", "error", { tool, rows: rows.map(String) }, "tool"), index);
}

/** Returns the object of the previous run for an equal tool. */
const asBefore = ({ shop }: Machine, tool: Tool): Tool => shop.memory?.canonical(tool) ?? tool;

/**
 * A tool of another table is no fault while only milling follows: for a mill of known radius until something is turned
 * before the next tool call, else until turning begins.
 */
function turnsLater(machine: Machine, index: number): boolean {
  const isMill = machine.now.mill.radius !== null;
  let turns = false;
  for (let i = index + 1; i < machine.unit.to; i += 1) {
    const s = machine.peek(i);
    if (s?.kind === "toolCall") return false;
    if (s?.kind === "mode") {
      turns = s.mode === "TURN";
      if (!isMill || !turns) return turns;
    } else if (turns && s && MOVES.has(s.kind)) return true;
  }
  return turns;
}

/** Blocks that move the tool, or may do so. */
const MOVES: ReadonlySet<Statement["kind"]> = new Set([
  "path",
  "approach",
  "free",
  "cycleCall",
  "call",
  "callProgram",
  "callSelected",
]);

function drillIn(mills: readonly Mill[], wanted: number | string): Tool | undefined {
  const row = find(mills, wanted);
  return row && (drillOf(row) ?? undefined);
}

/** Row numbers differ by tenths; a calculated number may deviate by this much. */
const SAME_ROW = 0.001;

/** By number with its index, or by name. */
const find = <T extends Pick<Tool, "T" | "NAME">>(tools: readonly T[], wanted: number | string): T | undefined =>
  typeof wanted === "number"
    ? tools.find((t) => Math.abs(t.T - wanted) < SAME_ROW)
    : (tools.find((t) => t.NAME === wanted) ?? tools.find((t) => t.NAME.toUpperCase() === wanted.trim().toUpperCase()));

type Correction = NonNullable<Tool["correction"]>;
type Plus = (a: Correction, b: Correction) => Correction;
const NONE: Correction = { z: length(0), r: length(0) };
const plus: Plus = (a, b) => ({ z: length(a.z + b.z), r: length(a.r + b.r) });

/** The tool with FUNCTION TURNDATA CORR applied; both systems add up. */
function corrected(tool: Tool, corrections: Modal["corrections"]): Tool {
  const { correction: _, ...bare } = tool;
  const sum = plus(corrections.TCS ?? NONE, corrections.WPL ?? NONE);
  return sum.z === 0 && sum.r === 0 ? bare : { ...bare, correction: sum };
}

/** FUNCTION TURNDATA CORR OFF and CORRDATA RESET: the tool of the table again, in one system or in both. */
export function uncorrectTool(machine: Machine, system?: keyof Modal["corrections"]): void {
  const { tool, corrections } = machine.now;
  const { [system ?? "TCS"]: _, ...kept } = corrections;
  machine.set({ corrections: system ? kept : {} });
  if (tool) machine.set({ tool: asBefore(machine, corrected(tool, machine.now.corrections)) });
}

/**
 * FUNCTION TURNDATA CORR: until the next tool call the control assumes a tool longer by DZL and DXL (decision 0006), so
 * the insert is that far towards +Z and +X of the programmed tip.
 */
export function correctTool(machine: Machine, s: StatementOf<"turnCorrection">, index: number): void {
  machine.log.report(programIssue("wordsRecalled", "info", { what: `FUNCTION TURNDATA CORR-${s.system}` }), index);
  if (!machine.now.tool) return noTool(machine, index);
  const word = (name: string) => {
    const found = s.words.find((w) => w.name === name);
    return length(found ? machine.length(machine.number(found.value, index) ?? 0) : 0);
  };
  for (const { name } of s.words) if (name !== "DZL" && name !== "DXL") machine.log.leaveUnproved(name, index);
  machine.set({ corrections: { ...machine.now.corrections, [s.system]: { z: word("DZL"), r: word("DXL") } } });
  machine.set({ tool: asBefore(machine, corrected(machine.now.tool, machine.now.corrections)) });
}
