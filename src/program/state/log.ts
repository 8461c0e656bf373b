import type { Issue } from "../../kernel/plan/issue.ts";
import type { Pt, Ring } from "../../kernel/geometry/point.ts";
import type { Spindle, Stated, Step, Unproved } from "../../kernel/time/step.ts";
import { axial, radius } from "../../kernel/units.ts";
import type { NcIssue } from "../../nc/issue.ts";
import { blockNumbers, eachIssue, startLines, type Program } from "../../nc/program.ts";
import { fewAlike, MOST_ALIKE } from "./alike.ts";
import { programIssue, type ProgramIssue } from "./issue.ts";
import type { ApproachRun, PlaneStep } from "../tools/plane-types.ts";
import type { ProgramFile } from "./program-files.ts";
import type { Operation, Run, RunFinding, SecondsBeside } from "./run-types.ts";

const NO_SHIFT_POINT: Pt = { z: axial(0), r: radius(0) };

interface Appended {
  readonly file: ProgramFile;
  readonly from: number;
  readonly numbers: readonly number[];
  readonly lines: readonly number[];
  caller: number;
}

const IN_PROGRAM = {};

/** How far a log was at a moment: of what is only added to, how much there was. */
export interface LogMoment {
  readonly counts: Readonly<
    Record<
      | "steps"
      | "milled"
      | "operations"
      | "approaches"
      | "spindles"
      | "findings"
      | "unproved"
      | "stated"
      | "said"
      | "left",
      number
    >
  >;
  readonly datums: Run["datums"];
  readonly firstBlank: readonly Ring[] | null;
  readonly seconds: number;
  readonly beside: SecondsBeside;
}

const firstOf = <Value>(set: ReadonlySet<Value>, count: number): Set<Value> => new Set([...set].slice(0, count));

/** What a run has done and said so far, each at its block. */
export class Log {
  /**
   * Number of each block, and its line in the text; of a block of another program, those of the block that called it.
   */
  readonly numbers: number[];
  readonly lines: number[];
  /**
   * Texts of called programs, in the order of their blocks: each with where its first block stands and which block has
   * called it.
   */
  private readonly appended: Appended[] = [];
  readonly steps: Step[] = [];
  readonly stepBlocks: number[] = [];
  /** Motions of mills. */
  readonly milled: PlaneStep[] = [];
  readonly operations: Operation[] = [];
  readonly approaches: ApproachRun[] = [];
  readonly datums: Run["datums"][number][] = [];
  readonly spindles: Run["spindles"][number][] = [];
  readonly findings: RunFinding[] = [];
  readonly unproved: Unproved[] = [];
  /** Blanks that were stated after something had been cut, and the one before the first of them. */
  readonly stated: Stated[] = [];
  firstBlank: readonly Ring[] | null = null;
  /** What turning has taken so far. */
  seconds = 0;
  /** What was taken beside the motions. */
  beside: SecondsBeside = { toolChange: 0, spindle: 0, dwell: 0 };
  private readonly said: Set<string> = new Set();
  private readonly left: Set<string> = new Set();

  /** How many blocks the program itself has. */
  private readonly own: number;

  /** `before`: a log of the same blocks, what it held at a moment is taken over. */
  constructor(
    private readonly program: Program,
    before?: { readonly log: Log; readonly at: LogMoment },
  ) {
    this.own = program.blocks.length;
    this.numbers = blockNumbers(program);
    this.lines = startLines(program);
    if (!before) return;
    const {
      log,
      at: { counts, datums, firstBlank, seconds, beside },
    } = before;
    this.steps = log.steps.slice(0, counts.steps);
    this.stepBlocks = log.stepBlocks.slice(0, counts.steps);
    this.milled = log.milled.slice(0, counts.milled);
    this.operations = log.operations.slice(0, counts.operations);
    this.approaches = log.approaches.slice(0, counts.approaches);
    this.datums = [...datums];
    this.spindles = log.spindles.slice(0, counts.spindles);
    this.findings = log.findings.slice(0, counts.findings);
    this.unproved = log.unproved.slice(0, counts.unproved);
    this.stated = log.stated.slice(0, counts.stated);
    this.said = firstOf(log.said, counts.said);
    this.left = firstOf(log.left, counts.left);
    this.firstBlank = firstBlank;
    this.seconds = seconds;
    this.beside = beside;
  }

  /** How far it is now; nothing of another program may have been said yet. */
  get moment(): LogMoment {
    const {
      steps,
      milled,
      operations,
      approaches,
      spindles,
      findings,
      unproved,
      stated,
      said,
      left,
      datums,
      firstBlank,
      seconds,
      beside,
    } = this;
    return {
      counts: {
        steps: steps.length,
        milled: milled.length,
        operations: operations.length,
        approaches: approaches.length,
        spindles: spindles.length,
        findings: findings.length,
        unproved: unproved.length,
        stated: stated.length,
        said: said.size,
        left: left.size,
      },
      datums: [...datums],
      firstBlank,
      seconds,
      beside,
    };
  }

  /** Adds the blocks of a program that is called. */
  append(file: ProgramFile, from: number): void {
    const { program } = file;
    this.appended.push({ file, from, numbers: blockNumbers(program), lines: startLines(program), caller: -1 });
  }

  /** Notes that a block, of the program itself or of one that it has called, calls a program or reads it. */
  calledBy(index: number, from: number): void {
    const called = this.appended.find((a) => a.from === from);
    const caller = this.inProgram(index);
    if (!called || called.caller === caller) return;
    called.caller = caller;
    this.numbers.length = Math.max(this.numbers.length, from + called.numbers.length);
    this.lines.length = this.numbers.length;
    this.numbers.fill(this.numbers[caller] ?? 0, from, from + called.numbers.length);
    this.lines.fill(this.lines[caller] ?? 1, from, from + called.numbers.length);
  }

  private textOf(index: number): Appended | undefined {
    return this.appended.findLast((a) => a.from <= index);
  }

  /** The block of the program itself: the one that called, for a block of another. */
  inProgram(index: number): number {
    return index < this.own ? index : (this.textOf(index)?.caller ?? index);
  }

  /** Where the block of a step stands that is not one of the program itself. */
  lineOf(index: number): Pick<Step, "file" | "line"> {
    const { inFile } = this.inFile(index, 0);
    return inFile ? { file: inFile.file, line: inFile.line } : IN_PROGRAM;
  }

  /** The file of a block that is not one of the program itself. */
  fileOf(index: number): { readonly file?: string } {
    const text = index < this.own ? undefined : this.textOf(index);
    return text ? { file: text.file.name } : IN_PROGRAM;
  }

  /** Notes a finding at a block, once however often the block runs. `within` counts lines inside the block. */
  say(issue: Issue | ProgramIssue, index: number | null, within = 0, operation: number | null = null): void {
    const key = `${index} ${issue.code} ${issue.at ?? ""} ${operation ?? ""} ${operation === null ? "" : JSON.stringify(issue.data)}`;
    if (this.said.has(key)) return;
    this.said.add(key);
    const place =
      index === null
        ? { block: null, line: null }
        : {
            block: this.numbers[index] ?? 0,
            line: (this.lines[index] ?? 1) + (index < this.own ? within : 0),
            ...this.inFile(index, within),
          };
    this.findings.push({ issue, ...place, operation });
  }

  /** Adds time that no motion takes, s. */
  takes(what: keyof SecondsBeside, seconds: number): void {
    if (seconds > 0) this.beside = { ...this.beside, [what]: this.beside[what] + seconds };
  }

  /** Notes from which point the program counts at the step that comes next. */
  countsFrom(x: number, z: number): void {
    const last = this.datums.at(-1)?.at ?? NO_SHIFT_POINT;
    if (last.r === x && last.z === z) return;
    const [step, at] = [this.steps.length, { z: axial(z), r: radius(x) }];
    if (this.datums.at(-1)?.step === step) this.datums.pop();
    this.datums.push({ step, at });
  }

  /** Notes how the spindle turns at the step that comes next. */
  turnsAt(spindle: Spindle | null, backwards: boolean): void {
    const last = this.spindles.at(-1),
      turnsBack = last?.backwards ?? false;
    if ((last?.spindle ?? null) === spindle && turnsBack === backwards) return;
    this.spindles.push({ step: this.steps.length, spindle, ...(backwards && { backwards }) });
  }

  /** Where a block stands in the text that it is from. */
  placeOf(index: number): { readonly block: number; readonly line: number; readonly file?: string } {
    const { inFile } = this.inFile(index, 0);
    if (inFile) return { ...inFile, block: inFile.block ?? 0 };
    return { block: this.numbers[index] ?? 0, line: this.lines[index] ?? 1 };
  }

  /** Where a finding stands in the file of a called program. */
  private inFile(index: number, within: number): Pick<RunFinding, "inFile"> {
    const text = index < this.own ? undefined : this.textOf(index);
    if (!text) return IN_PROGRAM;
    const at = index - text.from;
    return { inFile: { file: text.file.name, block: text.numbers[at] ?? 0, line: (text.lines[at] ?? 1) + within } };
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
    const key = `${index < this.own ? block : index} ${what}`;
    if (this.left.has(key)) return;
    this.left.add(key);
    // The first of all says from where on nothing is proved; a list of all that follow would fill the memory.
    if (this.unproved.length < MOST_ALIKE)
      this.unproved.push({ step: this.steps.length, block, what, ...this.fileOf(index) });
    this.say(programIssue("notProved", "warning", { what }), index);
  }

  /** Notes that from the step that comes next on another blank stands in the chuck. */
  states(
    rings: readonly Ring[],
    { what, before }: { readonly what: string; readonly before: readonly Ring[] },
    index: number,
  ): void {
    this.firstBlank ??= before;
    this.stated.push({ step: this.steps.length, block: this.numbers[index] ?? 0, what, rings, ...this.fileOf(index) });
  }

  /** All findings in the order of the text, those of the reader included. */
  allFindings(): RunFinding[] {
    const missing = new Set(this.findings.filter((f) => f.issue.code === "missing").map((f) => f.line));
    const order = (a: RunFinding, b: RunFinding) => (a.line ?? 0) - (b.line ?? 0);
    return [...fewAlike(this.read(missing)), ...fewAlike(this.findings.toSorted(order))].sort(order);
  }

  /** What the reader found, less what is also said as a missing parameter. */
  private *read(missing: ReadonlySet<number | null>): Generator<RunFinding> {
    for (const i of eachIssue(this.program))
      if (!(i.code === "wordMissing" && missing.has(i.line))) yield this.located(i);
    for (const { file, caller } of this.appended) {
      const at = { block: this.numbers[caller] ?? null, line: this.lines[caller] ?? null };
      for (const issue of eachIssue(file.program))
        if (issue.severity !== "info")
          yield { issue, ...at, operation: null, inFile: { file: file.name, block: null, line: issue.line } };
    }
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
