import { lengthsIn, type Lengths } from "../i18n/lengths.ts";
import { message } from "../i18n/message.ts";
import { measureOf } from "../i18n/sentence.ts";
import { printedLengths } from "../i18n/printed-lengths.ts";
import { isLength } from "../i18n/write.ts";
import type { Language } from "../i18n/languages.ts";
import type { AnyIssue } from "../i18n/message-texts.ts";
import { cycleByNumber } from "../cycles/index.ts";
import type { Kind } from "../cycles/params.ts";
import type { Clamping } from "../kernel/area/clamping.ts";
import { issue, type Severity } from "../kernel/plan/issue.ts";
import { part, type Pt, type Segment } from "../kernel/geometry/point.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import { IN_MM, toDiameter } from "../kernel/units.ts";
import { programIssue } from "../program/state/issue.ts";
import { timesOf, type Times } from "../program/run/run-times.ts";
import type { Operation, Run, RunFinding, Timing } from "../program/state/run-types.ts";
import { stockIssues } from "../sim/issues.ts";
import { LEAST_RESIDUAL } from "../sim/residual.ts";
import type { Simulation, Verdict } from "../sim/simulation.ts";
import { FIXED_BY_TOOL, toolSuggester } from "./offered-tool.ts";
import { joinPlaces, operationKey } from "./places.ts";
import { remedies } from "./remedies.ts";
import { reportedMove, outsideCycles, type ReportMove } from "./report-moves.ts";
import { verdictOf, type Judged, type VerdictReason } from "./verdict.ts";

/** [z, r], mm. */
export type ReportPoint = readonly [z: number, r: number];
export type ReportRing = readonly ReportPoint[];

export interface ReportIssue {
  readonly code: string;
  readonly severity: Severity;
  readonly at?: string;
  readonly block?: number;
  /** Its place in the file of a called program; `block` is then that of the call. */
  readonly inFile?: NonNullable<RunFinding["inFile"]>;
  readonly data?: object;
  readonly text: string;
}

export interface ReportOperation {
  readonly block: number;
  readonly cycle: number;
  readonly tool: Readonly<Record<string, string | number>>;
  readonly start: { readonly x: number; readonly z: number };
  readonly contour: readonly ReportPoint[];
  readonly passes: number;
  readonly infeed: number;
  readonly moves: readonly ReportMove[];
  readonly seconds: number;
  readonly issues: readonly ReportIssue[];
}

export interface ReportResidual {
  readonly area: number;
  readonly reason: string;
  readonly ring: ReportRing;
  /** Diameter of the largest circle in it, mm. */
  readonly thickness: number;
  /** Tools that would take it, by what they leave, least first. */
  readonly tools: readonly number[];
}

export interface Milliseconds {
  readonly parse: number;
  readonly plan: number;
  readonly simulate: number;
}

/**
 * The result of one program as data for other programs. Lengths are in mm also for inch programs, except in the data of
 * issues.
 */
export interface Report {
  readonly format: "turnwise-report/1";
  readonly file: string;
  readonly program: Run["program"];
  readonly stock: { readonly initial: readonly ReportRing[]; readonly final: readonly ReportRing[] };
  /** The stated clamping; null: not stated, so contacts with it are not checked. */
  readonly clamping: Clamping | null;
  readonly operations: readonly ReportOperation[];
  readonly moves: readonly ReportMove[];
  readonly proof: {
    readonly gouge: number;
    readonly rapidInStock: number;
    readonly residual: readonly ReportResidual[];
    /** mm² of stock that feed moves removed. */
    readonly cut: number;
    /** Roughing passes that touched no stock. */
    readonly airPasses: number;
    /** Greatest real depth of a roughing pass against its Q463, mm; `allowed` 0: the values set no limit. */
    readonly deepest: { readonly depth: number; readonly allowed: number; readonly block: number } | null;
    readonly holder: "clear" | "contact" | "unknown";
    /** Block 0: the whole program. */
    readonly unproved: readonly { readonly block: number; readonly what: string }[];
    readonly verdict: Verdict;
    readonly reasons: readonly VerdictReason[];
  };
  readonly time: ReportTime;
  readonly issues: readonly ReportIssue[];
  readonly milliseconds: Milliseconds;
}

/** Running time by category, s, and the data used for it. */
export interface ReportTime extends Times, Omit<Timing, "beside" | "turning"> {}

/** Arcs of a reported contour stay this near to their circle: 1 µm. */
const CONTOUR_CHORD = 0.001;

const pointOf = (p: Pt): ReportPoint => [p.z, p.r];
const ringOf = (ring: readonly Pt[]): ReportRing => ring.map(pointOf);

const columnsOf = (tool: Tool): Record<string, string | number> =>
  Object.fromEntries(Object.entries(tool).filter((e): e is [string, string | number] => typeof e[1] !== "object"));

function contourOf(contour: readonly Segment[]): ReportPoint[] {
  const first = contour[0];
  return first
    ? [pointOf(first.from), ...contour.flatMap((s) => part.flattened(s, CONTOUR_CHORD).slice(1).map(pointOf))]
    : [];
}

/** A finding of the run or of the stock; `cycle`: to find the kind of the value it concerns. */
interface LocatedIssue extends Pick<RunFinding, "block" | "operation" | "inFile"> {
  readonly issue: AnyIssue;
  readonly cycle: number | null;
}

/** Issues whose offered value is no length, or is one of the tool table, which is in mm in any program. */
const OTHER_OFFERS: ReadonlySet<AnyIssue["code"]> = new Set([
  "notWhole",
  "notAChoice",
  "wallsMeet",
  "angleNotFollowed",
  "flankInfeedTooSteep",
  "toolColumn",
  "toolNumberTwice",
]);
/** Decimals of an offer in another unit than mm, as its sentence shows it. */
const OFFERED = 5;

/** Whether the value offered by a finding is a length. */
function offersLength({ code, data }: AnyIssue, kind: Kind | undefined): boolean {
  if (kind !== undefined) return isLength(kind);
  return !OTHER_OFFERS.has(code) && !("quantity" in data && (data.quantity === "angle" || data.quantity === "tangent"));
}

/** The data of a finding, with printed and offered values in the unit of the program. */
function dataOf(found: AnyIssue, field: Kind | undefined, { unit, per }: Lengths): object {
  const { data } = found;
  if (unit === "mm") return data;
  const kind = measureOf(found, field),
    printed = printedLengths(found, kind);
  return Object.fromEntries(
    Object.entries(data).map(([name, value]: [string, unknown]) => {
      if (typeof value !== "number") return [name, value];
      if (name === "nearest") return [name, offersLength(found, kind) ? Number((value / per).toFixed(OFFERED)) : value];
      const as = printed.get(name);
      return [name, as === "length" ? value / per : as === "area" ? value / per ** 2 : value];
    }),
  );
}

function issueOf({ issue: found, block, cycle, inFile }: LocatedIssue, spoken: Lengths): ReportIssue {
  const { at } = found;
  const field = at === undefined || cycle === null ? undefined : cycleByNumber(cycle)?.params[at]?.kind;
  return {
    code: found.code,
    severity: found.severity,
    ...(at !== undefined && { at }),
    ...(block !== null && { block }),
    ...(inFile && { inFile }),
    data: dataOf(found, field, spoken),
    text: message(spoken, found, field),
  };
}

/** An issue with a tool of the table that fixes it. */
function withTool(found: ReportIssue, { T, NAME }: Tool, spoken: Lengths): ReportIssue {
  const offer = message(spoken, issue("betterTool", "info", { tool: T, name: NAME }));
  return { ...found, data: { ...found.data, otherTool: T }, text: `${found.text} ${offer}` };
}

/** Inputs of a report: the run and its simulation. */
export interface Checked {
  readonly file: string;
  readonly run: Run;
  readonly simulation: Pick<Simulation, "final" | "findings" | "proof">;
  readonly milliseconds: Milliseconds;
  /** Tools to try on residual material; none if absent. */
  readonly tools?: readonly Tool[];
}

/** Most regions on which tools are tried, the largest first: each costs a cut per tool. */
const MOST_TRIED = 40;

/** The entry for all milling in the list of unverified parts. */
const MILLING = "FUNCTION MODE MILL";

/** The unverified parts, milling included. */
function unprovedOf(judged: Judged): { block: number; what: string }[] {
  return judged.reasons.flatMap((r) =>
    r.kind === "unproved"
      ? [{ block: r.block ?? 0, what: r.what }]
      : r.kind === "milling"
        ? [{ block: r.block, what: MILLING }]
        : [],
  );
}

function residualsOf({ run, simulation, tools = [] }: Checked): ReportResidual[] {
  const told = simulation.proof.residual.filter((r) => r.area > LEAST_RESIDUAL);
  const tried = new Set([...told].sort((a, b) => b.area - a.area).slice(0, MOST_TRIED));
  const find = remedies(tools);
  return told.map((r) => {
    const operation = run.operations[r.operation];
    const better = operation && tried.has(r) ? find(operation, r) : [];
    return {
      area: r.area,
      reason: r.reason,
      ring: ringOf(r.ring),
      thickness: r.thickness,
      tools: better.map((b) => b.tool.T),
    };
  });
}

/** Puts a run and its simulation into the form of the report, with sentences in one language. */
export function report(checked: Checked, language: Language): Report {
  const { file, run, simulation, milliseconds } = checked;
  const { beside: _, turning: __, ...timing } = run.timing;
  const spoken = lengthsIn(language, run.program.unit, IN_MM[run.program.unit]);
  const judged = verdictOf(run, simulation);
  const { gouge, rapidInStock, cut, airPasses, deepest, holder } = simulation.proof;
  const proved = stockIssues(simulation);
  const ran = run.issues.map((f): LocatedIssue => ({
    ...f,
    cycle: f.operation === null ? null : (run.operations[f.operation]?.cycle ?? null),
  }));
  const stands = proved.map((p): LocatedIssue => {
    const block = p.block ?? (p.operation === null ? null : (run.operations[p.operation]?.block ?? null));
    return { ...p, block, cycle: null };
  });
  const notProved = (what: string, block: number | null): LocatedIssue => ({
    issue: programIssue("notProved", "warning", { what }),
    block,
    operation: null,
    cycle: null,
  });
  const toolFor = toolSuggester(checked.tools ?? []);
  const listed = (all: readonly LocatedIssue[]): ReportIssue[] => {
    const placed = all.map((f) => ({
      ...f,
      work: operationKey(f, f.operation === null ? undefined : run.operations[f.operation]),
    }));
    return joinPlaces(placed).map((f) => {
      const operation = f.operation === null ? undefined : run.operations[f.operation];
      const tool =
        operation && FIXED_BY_TOOL.has(f.issue.code) && f.issue.severity !== "info" ? toolFor(operation) : null;
      return tool ? withTool(issueOf(f, spoken), tool, spoken) : issueOf(f, spoken);
    });
  };
  const operation = (o: Operation, index: number): ReportOperation => ({
    block: o.block,
    cycle: o.cycle,
    tool: columnsOf(o.tool),
    start: { x: toDiameter(o.start.r), z: o.start.z },
    contour: contourOf(o.plan.contour),
    passes: o.plan.passes,
    infeed: o.plan.infeed,
    moves: run.steps.slice(o.firstStep, o.lastStep + 1).map((s) => reportedMove(s.move, s.block)),
    seconds: o.seconds,
    issues: listed([...ran, ...stands].filter((f) => f.operation === index)),
  });
  return {
    format: "turnwise-report/1",
    file,
    program: run.program,
    stock: { initial: run.blank.map(ringOf), final: simulation.final.map(ringOf) },
    clamping: run.clamping?.clamping ?? null,
    operations: run.operations.map(operation),
    moves: outsideCycles(run),
    proof: {
      gouge,
      rapidInStock,
      residual: residualsOf(checked),
      cut,
      airPasses,
      deepest: deepest && { depth: deepest.depth, allowed: deepest.allowed, block: deepest.block },
      holder,
      unproved: unprovedOf(judged),
      verdict: judged.verdict,
      reasons: judged.reasons,
    },
    issues: listed([
      ...ran,
      ...judged.reasons.flatMap((r) => (r.kind === "milling" ? [notProved(MILLING, r.block)] : [])),
      ...simulation.proof.unproved.slice(run.unproved.length).map(({ what, block }) => notProved(what, block)),
      ...stands,
    ]),
    time: { ...timesOf(run), ...timing },
    milliseconds,
  };
}

/** True when a program has a fault that must not reach a machine. */
export const hasErrors = (r: Report) => r.issues.some((i) => i.severity === "error");
