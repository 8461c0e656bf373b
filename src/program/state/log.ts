import type { Issue } from "../../kernel/plan/issue.ts";
import type { Pt, Ring } from "../../kernel/geometry/point.ts";
import type { Spindle, StatedBlank, Step, UnsimulatedBlock } from "../../kernel/time/step.ts";
import { axial, radius } from "../../kernel/units.ts";
import type { NcIssue } from "../../nc/issue.ts";
import { spellingFix } from "../../nc/typing-slips.ts";
import { blockNumbers, eachIssue, startLines, type Program } from "../../nc/program.ts";
import { AppendList, AppendSet, type Mutable } from "../values/persistent.ts";
import { limitPerCode, MOST_PER_CODE } from "./finding-limit.ts";
import { programIssue, type ProgramIssue } from "./issue.ts";
import type { ApproachRun, PlaneStep } from "../tools/plane-types.ts";
import type { ProgramFile } from "./program-files.ts";
import type { RunInput } from "./run-input.ts";
import type { Operation, Run, RunFinding, NonMotionSeconds } from "./run-types.ts";
import type { Unit } from "./units.ts";

const NO_SHIFT_POINT: Pt = { z: axial(0), r: radius(0) };

/** A called program, appended behind the earlier texts. */
interface CalledText {
  readonly file: ProgramFile;
  readonly unit: Unit;
  readonly numbers: readonly number[];
  readonly lines: readonly number[];
  /** Block of the main program with the latest call; -1 before any. */
  readonly caller: number;
}

const IN_PROGRAM = {};

/** Lists that a run appends to. */
interface Noted {
  readonly steps: Step;
  readonly stepBlocks: number;
  /** Motions of mills. */
  readonly milled: PlaneStep;
  readonly operations: Operation;
  readonly approaches: ApproachRun;
  readonly datums: Run["datums"][number];
  readonly spindles: Run["spindles"][number];
  readonly findings: RunFinding;
  readonly unproved: UnsimulatedBlock;
  /** Blanks stated after the first cut. */
  readonly stated: StatedBlank;
}

/** Steps and findings of a run so far. Immutable. */
export interface LogState extends Readonly<{ [List in keyof Noted]: AppendList<Noted[List]> }> {
  /** Blank before the first restated one. */
  readonly firstBlank: readonly Ring[] | null;
  /** Turning time so far, s. */
  readonly seconds: number;
  /** Time outside of motions, s. */
  readonly nonMotion: NonMotionSeconds;
  readonly said: AppendSet<string>;
  readonly left: AppendSet<string>;
  /** Texts of called programs, in the order of their blocks. */
  readonly texts: readonly CalledText[];
}

export const emptyLog = (): LogState => ({
  steps: new AppendList(),
  stepBlocks: new AppendList(),
  milled: new AppendList(),
  operations: new AppendList(),
  approaches: new AppendList(),
  datums: new AppendList(),
  spindles: new AppendList(),
  findings: new AppendList(),
  unproved: new AppendList(),
  stated: new AppendList(),
  firstBlank: null,
  seconds: 0,
  nonMotion: { toolChange: 0, spindle: 0, dwell: 0 },
  said: new AppendSet(),
  left: new AppendSet(),
  texts: [],
});

/** Blocks and words for which another spelling is tried: more slips are another language. */
const MOST_SPELT = 40;
/** Characters of their blocks, all together: each try reads its whole block. */
const MOST_READ_AGAIN = 8000;

/** Records steps and findings of a run, each at its block. */
export class Log {
  private readonly draft: Mutable<LogState>;

  constructor(
    private readonly input: RunInput,
    state: LogState,
  ) {
    this.draft = { ...state };
  }

  get state(): LogState {
    return { ...this.draft };
  }

  get steps(): LogState["steps"] {
    return this.draft.steps;
  }

  get milled(): LogState["milled"] {
    return this.draft.milled;
  }

  get operations(): LogState["operations"] {
    return this.draft.operations;
  }

  get unproved(): LogState["unproved"] {
    return this.draft.unproved;
  }

  note<List extends keyof Noted>(list: List, item: Noted[List]): void {
    const lists: { readonly [Each in keyof Noted]: AppendList<Noted[Each]> } = this.draft;
    Object.assign(this.draft, { [list]: lists[list].with(item) });
  }

  /** Adds the steps of a block and their total time. */
  move(steps: readonly Step[], seconds: number, index: number): void {
    const block = this.callingBlock(index);
    this.draft.seconds += seconds;
    this.draft.steps = this.steps.withAll(steps);
    this.draft.stepBlocks = this.draft.stepBlocks.withAll(steps.map(() => block));
  }

  /** Unit of a program that was called before. */
  unitOf(program: Program): Unit | undefined {
    return this.draft.texts.find(({ file }) => file.program === program)?.unit;
  }

  /** Adds the blocks of a program that is called. */
  append(file: ProgramFile, unit: Unit): void {
    const { program } = file;
    const text = { file, unit, numbers: blockNumbers(program), lines: startLines(program), caller: -1 };
    this.draft.texts = [...this.draft.texts, text];
  }

  /** Records a block that calls or reads another program. */
  calledBy(index: number, unit: Unit): void {
    const caller = this.callingBlock(index);
    this.draft.texts = this.draft.texts.map((text) => (text.unit === unit ? { ...text, caller } : text));
  }

  /** Number of a block; in a called program that of the calling block. */
  numberOf(index: number): number | undefined {
    return this.input.numbers[this.callingBlock(index)];
  }

  /** Line of a block; in a called program that of the calling block. */
  private startOf(index: number): number {
    return this.input.lines[this.callingBlock(index)] ?? 1;
  }

  private isOwn(index: number): boolean {
    return index < this.input.program.blocks.length;
  }

  private textOf(index: number): CalledText | undefined {
    return this.isOwn(index) ? undefined : this.draft.texts.findLast(({ unit }) => unit.from <= index);
  }

  /** Main-program block: the block itself, or the calling block of a called program. */
  callingBlock(index: number): number {
    return this.textOf(index)?.caller ?? index;
  }

  /** File and line of a block in a called program. */
  lineOf(index: number): Pick<Step, "file" | "line"> {
    const { inFile } = this.inFile(index, 0);
    return inFile ? { file: inFile.file, line: inFile.line } : IN_PROGRAM;
  }

  /** File of a block in a called program. */
  fileOf(index: number): { readonly file?: string } {
    const text = this.textOf(index);
    return text ? { file: text.file.name } : IN_PROGRAM;
  }

  /** Records a finding at a block, once even if the block repeats. `within` counts lines inside the block. */
  report(issue: Issue | ProgramIssue, index: number | null, within = 0, operation: number | null = null): void {
    const key = `${index} ${issue.code} ${issue.at ?? ""} ${operation ?? ""} ${operation === null ? "" : JSON.stringify(issue.data)}`;
    if (this.draft.said.has(key)) return;
    this.draft.said = this.draft.said.with(key);
    const place =
      index === null
        ? { block: null, line: null }
        : {
            block: this.numberOf(index) ?? 0,
            line: this.startOf(index) + (this.isOwn(index) ? within : 0),
            ...this.inFile(index, within),
          };
    this.note("findings", { issue, ...place, operation });
  }

  /** Adds time outside of motions, s. */
  addSeconds(what: keyof NonMotionSeconds, seconds: number): void {
    const { nonMotion } = this.draft;
    if (seconds > 0) this.draft.nonMotion = { ...nonMotion, [what]: nonMotion[what] + seconds };
  }

  /** Records the datum of the next step. */
  noteDatum(x: number, z: number): void {
    const { datums } = this.draft;
    const last = datums.last?.at ?? NO_SHIFT_POINT;
    if (last.r === x && last.z === z) return;
    const [step, at] = [this.steps.length, { z: axial(z), r: radius(x) }];
    const before = datums.last?.step === step ? datums.withoutLast() : datums;
    this.draft.datums = before.with({ step, at });
  }

  /** Records the spindle state of the next step. */
  turnsAt(spindle: Spindle | null, backwards: boolean): void {
    const { last } = this.draft.spindles,
      turnsBack = last?.backwards ?? false;
    if ((last?.spindle ?? null) === spindle && turnsBack === backwards) return;
    this.note("spindles", { step: this.steps.length, spindle, ...(backwards && { backwards }) });
  }

  /** Block number and line in the block's own text. */
  placeOf(index: number): { readonly block: number; readonly line: number; readonly file?: string } {
    const { inFile } = this.inFile(index, 0);
    if (inFile) return { ...inFile, block: inFile.block ?? 0 };
    return { block: this.numberOf(index) ?? 0, line: this.startOf(index) };
  }

  /** Place of a finding in the file of a called program. */
  private inFile(index: number, within: number): Pick<RunFinding, "inFile"> {
    const text = this.textOf(index);
    if (!text) return IN_PROGRAM;
    const at = index - text.unit.from;
    return { inFile: { file: text.file.name, block: text.numbers[at] ?? 0, line: (text.lines[at] ?? 1) + within } };
  }

  /** Reports labels that a text sets twice. */
  reportDuplicateLabels({ setTwice }: Unit): void {
    for (const [label, index] of setTwice)
      this.report(programIssue("labelTwice", "error", { label: String(label) }), index);
  }

  notSimulated(what: string, index: number, severity: "info" | "warning" = "info"): void {
    this.report(programIssue("notSimulated", severity, { what }), index);
  }

  /** Records a finding at its first place only. */
  reportOnce(issue: Issue | ProgramIssue, index: number): void {
    const key = `once ${issue.code} ${issue.at ?? ""}`;
    if (this.draft.said.has(key)) return;
    this.draft.said = this.draft.said.with(key);
    this.report(issue, index);
  }

  /** Marks the run as unverified from here on, once per block. `what` as the program spells it. */
  leaveUnproved(what: string, index: number): void {
    const block = this.numberOf(index) ?? 0;
    const key = `${this.isOwn(index) ? block : index} ${what}`;
    if (this.draft.left.has(key)) return;
    this.draft.left = this.draft.left.with(key);
    // The first entry decides where verification ends; listing all others would fill the memory.
    if (this.unproved.length < MOST_PER_CODE)
      this.note("unproved", { step: this.steps.length, block, what, ...this.fileOf(index) });
    this.report(programIssue("notProved", "warning", { what }), index);
  }

  /** Records a new blank from the next step on. */
  noteBlank(
    rings: readonly Ring[],
    { what, before }: { readonly what: string; readonly before: readonly Ring[] },
    index: number,
  ): void {
    this.draft.firstBlank = this.draft.firstBlank ?? before;
    const block = this.numberOf(index) ?? 0;
    this.note("stated", { step: this.steps.length, block, what, rings, ...this.fileOf(index) });
  }

  /** All findings in the order of the text, those of the reader included. */
  allFindings(): RunFinding[] {
    const findings = this.draft.findings.slice();
    const missing = new Set(findings.filter((f) => f.issue.code === "missing").map((f) => f.line));
    const order = (a: RunFinding, b: RunFinding) => (a.line ?? 0) - (b.line ?? 0);
    const read = limitPerCode(this.read(missing));
    const unread = read.filter(({ issue }) => issue.code === "notUnderstood" || issue.code === "wordNotUnderstood");
    const spelt = new Set(unread.slice(0, MOST_SPELT));
    const again = { characters: MOST_READ_AGAIN, begins: spelt.size > 0 ? this.beginnings() : [] };
    return [
      ...read.map((found) => (spelt.has(found) ? this.spelt(found, again) : found)),
      ...limitPerCode(findings.toSorted(order)),
    ].sort(order);
  }

  /** Findings of the reader, except those also reported as missing parameters. */
  private *read(missing: ReadonlySet<number | null>): Generator<RunFinding> {
    for (const i of eachIssue(this.input.program))
      if (!(i.code === "wordMissing" && missing.has(i.line))) yield this.located(i);
    for (const { file, caller } of this.draft.texts) {
      const { numbers, lines } = this.input;
      const at = { block: numbers[caller] ?? null, line: lines[caller] ?? null };
      for (const issue of eachIssue(file.program))
        if (issue.severity !== "info")
          yield { issue, ...at, operation: null, inFile: { file: file.name, block: null, line: issue.line } };
    }
  }

  /** A finding of the reader with the right spelling, where a typing slip is its cause. */
  private spelt(found: RunFinding, again: { characters: number; readonly begins: readonly number[] }): RunFinding {
    const { issue, line, inFile } = found;
    if (inFile || !("offset" in issue) || issue.fix) return found;
    const at = this.blockOn(line ?? 0);
    const raw = this.input.program.blocks[at]?.raw ?? "";
    again.characters -= raw.length;
    const fix = again.characters < 0 ? null : spellingFix(issue, raw, again.begins[at] ?? 0);
    return fix ? { ...found, issue: { ...issue, fix } } : found;
  }

  /** Where each block begins in the text. */
  private beginnings(): readonly number[] {
    let offset = 0;
    return this.input.program.blocks.map(({ raw }) => {
      offset += raw.length;
      return offset - raw.length;
    });
  }

  /** Index of the block on a line. */
  private blockOn(line: number): number {
    const { lines } = this.input;
    let [low, high] = [0, lines.length - 1];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if ((lines[middle] ?? 0) <= line) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  private located(issue: NcIssue): RunFinding {
    const block = this.input.numbers[this.blockOn(issue.line)] ?? null;
    return { issue, block, line: issue.line, operation: null };
  }
}
