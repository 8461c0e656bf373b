import { cycleByNumber } from "../../../cycles/index.ts";
import type { Program } from "../../../nc/program.ts";
import type { FindingEntry } from "../../findings/entry.ts";
import { nearestOf } from "../../findings/host.ts";
import { valueInProgram } from "../../../program/blocks/cycle-values.ts";
import { countsInches } from "../../../program/edits/program-unit.ts";
import { perRevolutionBefore } from "./block-context.ts";
import { withPrompt } from "./block-prompts.ts";
import type { Repair } from "./repair.ts";

/** Repairs for a finding at a cycle value: the value it offers, or two values swapped. */
export function valueRepairs(entry: FindingEntry, program: Program, index: number): readonly Repair[] {
  const { issue, at } = entry,
    nearest = nearestOf(entry),
    s = program.blocks[index]?.statement;
  if (at === null || s?.kind !== "cycle") return [];
  const typed = (q: string, mm: number) =>
    valueInProgram(cycleByNumber(s.cycle)?.params[q], mm, countsInches(program), perRevolutionBefore(program, index));
  if (issue.code === "endsExchanged") {
    const { start, end, other } = issue.data,
      first = typed(at, end),
      last = typed(other, start);
    const next = () => withPrompt(withPrompt(program, index, at, String(first)), index, other, String(last));
    return [{ kind: "take", text: `${at} ${first}, ${other} ${last}`, block: "", open: index, next }];
  }
  if (nearest === null) return [];
  const text = typed(at, nearest);
  return [{ kind: "take", text, block: "", open: index, next: () => withPrompt(program, index, at, String(text)) }];
}
