import type { Issue } from "../kernel/issue.ts";
import type { Pt } from "../kernel/point.ts";
import type { Step, Unproved } from "../kernel/step.ts";
import { axial, radius } from "../kernel/units.ts";
import type { NcIssue } from "../nc/issue.ts";
import { blockNumbers, eachIssue, startLines, type Program } from "../nc/program.ts";
import { fewAlike, MOST_ALIKE } from "./alike.ts";
import { programIssue, type ProgramIssue } from "./issue.ts";
import type { ApproachRun, PlaneStep } from "./plane-types.ts";
import type { Operation, Run, RunFinding } from "./run-types.ts";

const NO_SHIFT_POINT: Pt = { z: axial(0), r: radius(0) };

/** What a run has done and said so far, each at its block. */
export class Log {
  /** Number of each block, and its line in the text. */
  readonly numbers: readonly number[];
  readonly lines: readonly number[];
  readonly steps: Step[] = [];
  readonly stepBlocks: number[] = [];
  /** Motions of mills. */
  readonly milled: PlaneStep[] = [];
  readonly operations: Operation[] = [];
  readonly approaches: ApproachRun[] = [];
  readonly datums: Run["datums"][number][] = [];
  readonly findings: RunFinding[] = [];
  readonly unproved: Unproved[] = [];
  private readonly said = new Set<string>();
  private readonly left = new Set<string>();

  constructor(private readonly program: Program) {
    this.numbers = blockNumbers(program);
    this.lines = startLines(program);
  }

  /** Notes a finding at a block, once however often the block runs. `within` counts lines inside the block. */
  say(issue: Issue | ProgramIssue, index: number | null, within = 0, operation: number | null = null): void {
    const key = `${index} ${issue.code} ${issue.at ?? ""} ${operation ?? ""} ${operation === null ? "" : JSON.stringify(issue.data)}`;
    if (this.said.has(key)) return;
    this.said.add(key);
    const place = index === null
      ? { block: null, line: null }
      : { block: this.numbers[index] ?? 0, line: (this.lines[index] ?? 1) + within };
    this.findings.push({ issue, ...place, operation });
  }

  /** Notes from which point the program counts at the step that comes next. */
  countsFrom(x: number, z: number): void {
    const last = this.datums.at(-1)?.at ?? NO_SHIFT_POINT;
    if (last.r === x && last.z === z) return;
    const [step, at] = [this.steps.length, { z: axial(z), r: radius(x) }];
    if (this.datums.at(-1)?.step === step) this.datums.pop();
    this.datums.push({ step, at });
  }

  notSimulated(what: string, index: number, severity: "info" | "warning" = "info"): void {
    this.say(programIssue("notSimulated", severity, { what }), index);
  }

  /** Notes a finding where it is met first, and nowhere else. */
  sayOnce(issue: Issue | ProgramIssue, index: number): void {
    const key = `once ${issue.code} ${issue.at ?? ""}`;
    if (this.said.has(key)) return;
    this.said.add(key);
    this.say(issue, index);
  }

  /** Notes that from here on nothing is proved, once for each block. `what` as the program spells it. */
  leaveUnproved(what: string, index: number): void {
    const block = this.numbers[index] ?? 0;
    const key = `${block} ${what}`;
    if (this.left.has(key)) return;
    this.left.add(key);
    // The first of all says from where on nothing is proved; a list of all that follow would fill the memory.
    if (this.unproved.length < MOST_ALIKE) this.unproved.push({ step: this.steps.length, block, what });
    this.say(programIssue("notProved", "warning", { what }), index);
  }

  /** All findings in the order of the text, those of the reader included. */
  allFindings(): RunFinding[] {
    const missing = new Set(this.findings.filter((f) => f.issue.code === "missing").map((f) => f.line));
    const order = (a: RunFinding, b: RunFinding) => (a.line ?? 0) - (b.line ?? 0);
    return [...fewAlike(this.read(missing)), ...fewAlike(this.findings.sort(order))].sort(order);
  }

  /** What the reader found, less what is also said as a missing parameter. */
  private *read(missing: ReadonlySet<number | null>): Generator<RunFinding> {
    for (const i of eachIssue(this.program)) if (!(i.code === "wordMissing" && missing.has(i.line))) yield this.located(i);
  }

  private located(issue: NcIssue): RunFinding {
    let [low, high] = [0, this.lines.length - 1];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if ((this.lines[middle] ?? 0) <= issue.line) low = middle;
      else high = middle - 1;
    }
    return { issue, block: this.numbers[low] ?? null, line: issue.line, operation: null };
  }
}
