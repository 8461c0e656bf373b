import { neutralValueOf, hasNoEffect, type SomeValues } from "../../../cycles/effect.ts";
import { cycleByNumber } from "../../../cycles/index.ts";
import type { Issue } from "../../../kernel/plan/issue.ts";
import { blockNumbers, startLines, type Program } from "../../../nc/program.ts";
import { withBlock } from "../../../nc/edit.ts";
import type { Param } from "../../../cycles/params.ts";
import type { Statement } from "../../../nc/statement.ts";
import type { CycleParameter } from "../../../nc/words.ts";
import { contourBefore } from "../../../program/job/contour-of-text.ts";
import { decimalsInInches, valueInProgram } from "../../../program/blocks/cycle-values.ts";
import { OWN_DECIMALS, ownField } from "../../../program/edits/own-cycle.ts";
import { countsInches } from "../../../program/edits/program-unit.ts";
import { ownCycle } from "../../document/own-reading.ts";
import { feedWord } from "../../../program/values/field.ts";
import { exampleJob, type SetJob } from "../../../program/job/job.ts";
import { readDraft, type Draft } from "../../../program/job/read-draft.ts";
import type { RunFinding } from "../../../program/state/run-types.ts";
import { entryAt, type FindingEntry } from "../../findings/entry.ts";
import type { JobReading } from "../../document/reading.ts";
import { parametersBefore, perRevolutionBefore } from "./block-context.ts";
import { blockValue, parameterAsTyped } from "../../../program/values/typed-value.ts";

type CycleStatement = Extract<Statement, { kind: "cycle" }>;

/** The prompts of a cycle block: the values of its text, overridden by the text being typed. */
export function readingOfBlock(program: Program, index: number, typed: Draft): JobReading | null {
  const s = program.blocks[index]?.statement;
  const cycle = s?.kind === "cycle" ? cycleByNumber(s.cycle) : undefined;
  if (!cycle || s?.kind !== "cycle") return null;
  // For a parameter list of older software, use the values that the control fills in.
  const filled = Object.entries<Param>(cycle.params).flatMap(([q, { filledIn }]) =>
    filledIn === null ? [] : [[q, String(filledIn)]],
  );
  const written = s.parameters.map((p) => [p.q, parameterAsTyped(p.value)]);
  const draft: Draft = { ...Object.fromEntries<string>([...filled, ...written] as [string, string][]), ...typed };
  const perRevolution = perRevolutionBefore(program, index);
  const inches = countsInches(program) ? { perRevolution } : null;
  const job: SetJob = {
    ...exampleJob(cycle),
    drafts: { [cycle.number]: draft },
    perRevolution,
    contour: cycle.contour === "free" ? contourBefore(program, index) : [],
  };
  return {
    job,
    setup: null,
    tools: [],
    cycle,
    draft,
    reading: readDraft(cycle, draft, parametersBefore(program, index), inches),
    ...(inches && { inches }),
  };
}

/** What a parameter accepts, and its text when it is inserted. */
interface Asked {
  readonly kind: Param["kind"] | "number";
  readonly optional: boolean;
  readonly decimals: number;
  readonly rapid?: boolean;
  readonly label?: string;
}

/** The parameters of a cycle in order, from the catalogue or the operator's description. */
function askedOf(number: number): Readonly<Record<string, Asked>> {
  const known = cycleByNumber(number)?.params;
  if (known) return known;
  const own = ownCycle(number)?.parameters ?? [];
  return Object.fromEntries(own.map((p) => [p.q, { ...ownField(p), decimals: OWN_DECIMALS, label: p.prompt }]));
}

/** Sets a value in a cycle block; returns the same program if the text is no value. */
export function withPrompt(program: Program, index: number, q: string, text: string): Program {
  const s = program.blocks[index]?.statement;
  if (s?.kind !== "cycle") return program;
  const param = askedOf(s.cycle)[q];
  const left = text.trim() === "" ? leftOut(s, q) : null;
  const word = param?.kind === "feed" ? feedWord(text) : null;
  const value: CycleParameter["value"] =
    word === "auto" || (word === "max" && param?.rapid) ? word : (left ?? blockValue(text, decimalsIn(program, param)));
  return value === null ? program : withBlock(program, index, withParameter(s, q, value));
}

/** Converts mm to the unit of a program. */
export const inProgram = (program: Program, mm: number): number =>
  valueInProgram({ kind: "length" }, mm, countsInches(program));

/** Decimals that the control keeps for a parameter; undefined if unknown. */
const decimalsIn = (program: Program, param: Asked | undefined): number | undefined =>
  param && countsInches(program) ? decimalsInInches(param) : param?.decimals;

/** The value to write for an omitted prompt; null if it must not be omitted. */
function leftOut(s: CycleStatement, q: string): number | null {
  if (askedOf(s.cycle)[q]?.optional) return 0;
  const param = cycleByNumber(s.cycle)?.params[q];
  const known: SomeValues = Object.fromEntries(
    s.parameters.map(({ q: name, value }) => [name, typeof value === "number" ? value : undefined]),
  );
  return param && hasNoEffect(param, known) ? neutralValueOf(param) : null;
}

/** Sets a parameter. A missing one is inserted in the order of the catalogue or the description. */
function withParameter(s: CycleStatement, q: string, value: CycleParameter["value"]): CycleStatement {
  if (s.parameters.some((p) => p.q === q))
    return { ...s, parameters: s.parameters.map((p) => (p.q === q ? { ...p, value } : p)) };
  const asked = askedOf(s.cycle);
  const order = Object.keys(asked);
  const before = s.parameters.findLastIndex((p) => order.indexOf(p.q) >= 0 && order.indexOf(p.q) < order.indexOf(q));
  return { ...s, parameters: s.parameters.toSpliced(before + 1, 0, { q, value, label: asked[q]?.label ?? null }) };
}

/** Findings in the lines of a block and problems of its typed prompts, without duplicates. */
export function problemsOfBlock(
  program: Program,
  index: number,
  issues: readonly Issue[],
  findings: readonly RunFinding[],
): readonly FindingEntry[] {
  const line = startLines(program)[index] ?? 0;
  const last = line + (program.blocks[index]?.lines ?? 1) - 1;
  const block = blockNumbers(program)[index] ?? null;
  const typed = issues.map((issue): FindingEntry => entryAt(issue, issue.at ?? null, block));
  const found = findings
    .filter((f) => f.line !== null && f.line >= line && f.line <= last)
    .map(({ issue, inFile }): FindingEntry => entryAt(issue, ("at" in issue ? issue.at : null) ?? null, block, inFile));
  const all = new Map<string, FindingEntry>();
  for (const problem of [...typed, ...found]) {
    const key = JSON.stringify([problem.issue.code, problem.at, problem.issue.data, problem.inFile]);
    if (!all.has(key)) all.set(key, problem);
  }
  return [...all.values()];
}
