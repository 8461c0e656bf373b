import type { Cycle, Given, Outline } from "../cycles/define.ts";
import type { Params } from "../cycles/params.ts";
import type { Issue } from "../kernel/issue.ts";
import type { Plan, Setting } from "../kernel/plan.ts";
import type { KnownParameters } from "./expression.ts";
import { type Draft, type DraftReading, readDraft } from "./read-draft.ts";

/** What the dialog needs to know about a draft: its fields, its drawing, and its path where a tool is chosen. */
export interface CheckedDraft<P extends Params = Params> {
  readonly reading: DraftReading<P>;
  readonly outline: Outline | null;
  readonly plan: Plan | null;
  /** All findings: of single fields, of fields against each other, of fields against the tool. None twice. */
  readonly issues: readonly Issue[];
}

interface Circumstances {
  readonly given: Given;
  /** Null while there is no tool, or no start point. */
  readonly setting: Setting | null;
  readonly known?: KnownParameters;
}

const unique = (issues: readonly Issue[]) =>
  [...new Map(issues.map((found) => [JSON.stringify([found.code, found.at ?? "", found.data]), found])).values()];

/** Reads a draft and collects the findings of every stage that it reaches. */
export function checkDraft<P extends Params>(
  cycle: Cycle<P>, draft: Draft, { given, setting, known = {} }: Circumstances,
): CheckedDraft<P> {
  const reading = readDraft(cycle, draft, known);
  if (!reading.values) return { reading, outline: null, plan: null, issues: reading.issues };
  const outline = cycle.outline(reading.values, given);
  const plan = setting ? cycle.plan(reading.values, setting, given) : null;
  return { reading, outline, plan, issues: unique([...outline.issues, ...(plan?.issues ?? [])]) };
}
