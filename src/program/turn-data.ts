import type { Tool } from "../kernel/tool.ts";
import { length } from "../kernel/units.ts";
import type { Statement } from "../nc/statement.ts";
import { outlinedBlank } from "./cycle-call.ts";
import { programIssue } from "./issue.ts";
import type { Machine } from "./machine.ts";
import { noTool } from "./preconditions.ts";

type Correction = NonNullable<Tool["correction"]>;
type Plus = (a: Correction, b: Correction) => Correction;
const NONE: Correction = { z: length(0), r: length(0) };
const plus: Plus = (a, b) => ({ z: length(a.z + b.z), r: length(a.r + b.r) });

/** The tool as FUNCTION TURNDATA CORR leaves it; both systems add up. */
function corrected(tool: Tool, corrections: Machine["corrections"]): Tool {
  const { correction: _, ...bare } = tool;
  const sum = plus(corrections.TCS ?? NONE, corrections.WPL ?? NONE);
  return sum.z === 0 && sum.r === 0 ? bare : { ...bare, correction: sum };
}

/**
 * FUNCTION TURNDATA CORR: from here to the next tool call the control counts with a tool that is longer by DZL and DXL
 * (decision 0006), so the insert stands that far towards +Z and +X from the programmed tip.
 */
export function correctTool(machine: Machine, s: Extract<Statement, { kind: "turnCorrection" }>, index: number): void {
  machine.say(programIssue("wordsRecalled", "info", { what: `FUNCTION TURNDATA CORR-${s.system}` }), index);
  if (!machine.tool) return noTool(machine, index);
  const word = (name: string) => {
    const found = s.words.find((w) => w.name === name);
    return length(found ? machine.length(machine.number(found.value, index) ?? 0) : 0);
  };
  for (const { name } of s.words) if (name !== "DZL" && name !== "DXL") machine.leaveUnproved(name, index);
  machine.corrections = { ...machine.corrections, [s.system]: { z: word("DZL"), r: word("DXL") } };
  machine.tool = corrected(machine.tool, machine.corrections);
}

/** FUNCTION TURNDATA BLANK: the outline in a label is the stock where the program has no blank; air cuts are not left out. */
export function blankOfTurnData(machine: Machine, s: Extract<Statement, { kind: "turnBlank" }>, index: number): void {
  if (s.blank === "off") return;
  if ("file" in s.blank) return machine.leaveUnproved(`FUNCTION TURNDATA BLANK "${s.blank.file}"`, index);
  const first = machine.blank.length === 0;
  if (first) outlinedBlank(machine, s.blank.label, false, index);
  const label = String(s.blank.label);
  if (!first) machine.say(programIssue("blankNotTaken", "info", { label }), index);
  else if (machine.blank.length > 0) machine.say(programIssue("blankTaken", "info", { label }), index);
}
