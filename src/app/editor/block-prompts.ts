import { cycleByNumber } from "../../cycles/index.ts";
import { blockNumbers, startLines, type Program } from "../../nc/program.ts";
import { withBlock } from "../../nc/edit.ts";
import type { CycleParameter, Statement } from "../../nc/statement.ts";
import { feedWord } from "../../program/field.ts";
import { exampleJob, type Job } from "../../program/job.ts";
import { readDraft, type Draft } from "../../program/read-draft.ts";
import type { RunFinding } from "../../program/run-types.ts";
import { entryAt, type FindingEntry } from "../findings/entry.ts";
import type { JobReading } from "../reading.ts";
import { contourBefore, parametersBefore, perRevolutionBefore } from "./block-context.ts";
import { blockValue, parameterAsTyped } from "../../program/typed-value.ts";

type CycleStatement = Extract<Statement, { kind: "cycle" }>;

/** The prompts of a cycle block: what its text holds, with what is just being typed over it. */
export function readingOfBlock(program: Program, index: number, typed: Draft): JobReading | null {
  const s = program.blocks[index]?.statement;
  const cycle = s?.kind === "cycle" ? cycleByNumber(s.cycle) : undefined;
  if (!cycle || s?.kind !== "cycle") return null;
  const draft: Draft = { ...Object.fromEntries(s.parameters.map((p) => [p.q, parameterAsTyped(p.value)])), ...typed };
  const job: Job = {
    ...exampleJob(cycle),
    drafts: { [cycle.number]: draft },
    perRevolution: perRevolutionBefore(program, index),
    contour: cycle.contour === "free" ? contourBefore(program, index) : [],
  };
  return { job, cycle, draft, reading: readDraft(cycle, draft, parametersBefore(program, index)) };
}

/** The program with another value in a cycle block; the same program where the text can not be read as one. */
export function withPrompt(program: Program, index: number, q: string, text: string): Program {
  const s = program.blocks[index]?.statement;
  if (s?.kind !== "cycle") return program;
  const param = cycleByNumber(s.cycle)?.params[q];
  const empty = text.trim() === "" && (param?.optional ?? false);
  const value: CycleParameter["value"] = param?.kind === "feed" && feedWord(text) === "auto"
    ? "auto"
    : empty
    ? 0
    : blockValue(text, param?.decimals);
  return value === null ? program : withBlock(program, index, withParameter(s, q, value));
}

/** A missing parameter is put where the catalogue has it. */
function withParameter(s: CycleStatement, q: string, value: CycleParameter["value"]): CycleStatement {
  if (s.parameters.some((p) => p.q === q)) return { ...s, parameters: s.parameters.map((p) => (p.q === q ? { ...p, value } : p)) };
  const order = Object.keys(cycleByNumber(s.cycle)?.params ?? {});
  const before = s.parameters.findLastIndex((p) => order.indexOf(p.q) >= 0 && order.indexOf(p.q) < order.indexOf(q));
  return { ...s, parameters: s.parameters.toSpliced(before + 1, 0, { q, value, label: null }) };
}

/** What was found in the lines of a block, and what is wrong with its prompts as typed; none twice. */
export function problemsOfBlock(
  program: Program,
  index: number,
  read: JobReading | null,
  findings: readonly RunFinding[],
): readonly FindingEntry[] {
  const line = startLines(program)[index] ?? 0;
  const last = line + (program.blocks[index]?.lines ?? 1) - 1;
  const block = blockNumbers(program)[index] ?? null;
  const typed = read?.reading.issues.map((issue): FindingEntry => entryAt(issue, issue.at ?? null, block)) ?? [];
  const found = findings.filter((f) => f.line !== null && f.line >= line && f.line <= last).map(({ issue }): FindingEntry =>
    entryAt(issue, ("at" in issue ? issue.at : null) ?? null, block)
  );
  const all = new Map<string, FindingEntry>();
  for (const problem of [...typed, ...found]) {
    const key = JSON.stringify([problem.issue.code, problem.at, problem.issue.data]);
    if (!all.has(key)) all.set(key, problem);
  }
  return [...all.values()];
}
