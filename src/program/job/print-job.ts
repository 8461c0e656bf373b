import type { Cycle } from "../../cycles/define.ts";
import { cycleByNumber } from "../../cycles/index.ts";
import type { Param } from "../../cycles/params.ts";
import { programText } from "../../nc/print.ts";
import type { Statement } from "../../nc/statement.ts";
import { noWords, type AxisWord, type CycleParameter, type Value, type Words } from "../../nc/words.ts";
import { LAYOUTS, type Style } from "../../nc/style.ts";
import { clampingText } from "../clamping/words.ts";
import type { KnownParameters } from "../values/expression.ts";
import { knownParameters, usedParameters } from "./job-parameters.ts";
import type { BlankDraft, Job, SetJob } from "./job.ts";
import type { NcOutput } from "../machine/nc-output.ts";
import { contourStatements } from "./print-contour.ts";
import { anyNumber, roundedTo, readText } from "../values/field.ts";
import { readDraft, type Draft } from "./read-draft.ts";
import { POSITION_DECIMALS, typedAxis as axis, typedValue as value } from "../values/typed-value.ts";

/** Words of NC text in one language, supplied by `i18n`. */
export interface Labels {
  cycleName(cycle: number): string;
  /** Label behind `;`, by the text key of the parameter. */
  label(text: string): string;
  /** Cycle 14: text behind 14.0, and before the label number behind 14.1. */
  readonly contour: { readonly title: string; readonly label: string };
}

/** Label of the contour subprogram, as in the printed examples. */
const CONTOUR_LABEL = 2;
/** Decimals of the value of a Q parameter. */
const PARAMETER_DECIMALS = 6;
/** Distance of the safe position from blank and start point: ⌀ and Z, mm. */
export const SAFE_DISTANCE = { x: 20, z: 50 };
const path = (words: Partial<Words>): Statement => ({ kind: "path", path: "L", words: { ...noWords, ...words } });
const number = (typed: string, otherwise: number) => {
  const read = value(typed);
  return typeof read === "number" ? read : otherwise;
};

/** Parameter list of a cycle as typed; omitted optional values are 0 or have no effect. */
function parameters(cycle: Cycle, draft: Draft, known: KnownParameters, labels: Labels): CycleParameter[] {
  const { partial } = readDraft({ params: cycle.params }, draft, known);
  return Object.entries<Param>(cycle.params).map(([q, p]) => {
    const { written, empty } = readText({ ...anyNumber, kind: p.kind, decimals: p.decimals }, draft[q] ?? "", known);
    return { q, value: written ?? (empty ? (partial[q] ?? null) : null), label: labels.label(p.text) };
  });
}

function spin(job: Job): Statement {
  const { mode, speed, cuttingSpeed, limit } = job.spindle;
  const none = { cuttingSpeed: null, speed: null, limit: null, gear: null };
  return mode === "surface"
    ? { kind: "spin", constantSurface: true, ...none, cuttingSpeed: value(cuttingSpeed), limit: value(limit) }
    : { kind: "spin", constantSurface: false, ...none, speed: value(speed) };
}

/** Names of programs on the control: letters, digits and underscores. */
export const nameOnControl = (typed: string) =>
  typed
    .trim()
    .replace(/[^\p{L}\p{N}_+-]+/gu, "_")
    .slice(0, 32) || "PROGRAM";

/** BLK FORM of a typed cylinder. */
export function blankStatement({ outside, bore, length, allowance }: BlankDraft): Statement {
  const [wide, hole] = [value(outside), value(bore)];
  return {
    kind: "blankCylinder",
    axis: "Z",
    length: value(length),
    distance: value(allowance) ?? 0,
    outside: wide === null ? null : { measure: "D", value: wide },
    inside: hole === null || hole === 0 ? null : { measure: "DI", value: hole },
  };
}

/** `Q5 = 25` for each Q parameter used in a prompt that has a value. */
const assignments = (job: Job, known: KnownParameters): Statement[] =>
  usedParameters(job).flatMap((target): Statement[] => {
    const of = known[target];
    return of === undefined
      ? []
      : [{ kind: "assign", fn: null, target, formula: { kind: "value", value: roundedTo(of, PARAMETER_DECIMALS) } }];
  });

/**
 * Position of the start point: clear of the blank, in its bore, or below its outside, where a shoulder may be higher, or
 * behind a tailstock, where the way along the axis is not free.
 */
type StartPlace = "clear" | "bore" | "low";

function placeOfStart({ blank, start, clamping }: Job): StartPlace {
  if (clamping?.words.QUILL) return "low";
  const [outside, bore, x] = [number(blank.outside, 0), number(blank.bore, 0), number(start.x, 0)];
  if (number(start.z, 0) >= number(blank.allowance, 0)) return "clear";
  if (bore > 0 && x <= bore) return "bore";
  return x >= outside ? "clear" : "low";
}

/**
 * Retraction to the safe position, first across the axis from a low start; then spindle off, unless M30 or M2 does it.
 */
function wayOut(output: NcOutput, place: StartPlace, safe: { readonly x: number; readonly z: number }): Statement[] {
  const { retract, spindleOff } = output;
  const along = (axes: AxisWord[]) => path({ axes, compensation: "R0", feed: "max" });
  const limit: Statement = { kind: "functions", words: { ...noWords, functions: [140], retract: "max" } };
  return [
    ...(place === "low" ? [along([{ axis: "X", value: safe.x, incremental: false }])] : []),
    retract === "limit" ? limit : along([{ axis: "Z", value: safe.z, incremental: false }]),
    ...(spindleOff === null ? [] : [functions(spindleOff)]),
  ];
}

const functions = (m: number): Statement => ({ kind: "functions", words: { ...noWords, functions: [m] } });

/** The blocks from the tool call to the retraction: `cut` begins at the safe position and ends at the start point. */
export function machiningStatements(job: SetJob, cut: readonly Statement[]): Statement[] {
  const place = placeOfStart(job);
  // A quill may be thicker than what it holds.
  const outermost = [job.blank.outside, job.start.x, job.clamping?.words.QUILL ?? ""].map((x) => number(x, 0));
  const safeX = roundedTo(Math.max(...outermost) + SAFE_DISTANCE.x, POSITION_DECIMALS);
  const safeZ = roundedTo(
    Math.max(number(job.blank.allowance, 0), number(job.start.z, 0), 0) + SAFE_DISTANCE.z,
    POSITION_DECIMALS,
  );
  const at = (x: Value, z: Value): AxisWord[] => [
    { axis: "X", value: x, incremental: false },
    { axis: "Z", value: z, incremental: false },
  ];
  return [
    {
      kind: "toolCall",
      tool: job.tool,
      axis: null,
      speed: null,
      feed: null,
      deltaLength: null,
      deltaRadius: null,
      extra: [],
    },
    spin(job),
    functions(job.perRevolution ? 136 : 137),
    path({ axes: at(safeX, safeZ), compensation: "R0", feed: "max" }),
    ...(place === "bore" ? [path({ axes: axis("X", job.start.x), feed: "max" })] : []),
    ...(place === "low" ? [path({ axes: axis("Z", job.start.z), feed: "max" })] : []),
    ...cut,
    ...wayOut(job.output, place, { x: safeX, z: safeZ }),
  ];
}

/** The way to the start point of a job at rapid, with the spindle started. */
export const startStatement = ({ start, output }: Pick<SetJob, "start" | "output">): Statement =>
  path({
    axes: [...axis("X", start.x), { axis: "Y", value: 0, incremental: false }, ...axis("Z", start.z)],
    feed: "max",
    functions: [output.spindleOn],
  });

/** The blocks of a job, from BEGIN PGM to END PGM. */
export function jobStatements(job: SetJob, cycle: Cycle, labels: Labels): Statement[] {
  const { output } = job;
  const name = nameOnControl(output.capitals ? job.name.toUpperCase() : job.name);
  const free = cycle.contour === "free";
  const draft = job.drafts[cycle.number] ?? {};
  const known = knownParameters(job);
  const cycleLine = (line: number, text: string): Statement => ({ kind: "cycleLine", cycle: 14, line, text });
  return [
    { kind: "begin", name, unit: "MM" },
    blankStatement(job.blank),
    ...(job.clamping ? [{ kind: "comment" as const, text: ` ${clampingText(job.clamping)}` }] : []),
    { kind: "mode", mode: "TURN", kinematics: null },
    ...machiningStatements(job, [
      ...assignments(job, known),
      ...(free ? [cycleLine(0, labels.contour.title), cycleLine(1, `${labels.contour.label}${CONTOUR_LABEL}`)] : []),
      {
        kind: "cycle",
        cycle: cycle.number,
        name: labels.cycleName(cycle.number),
        parameters: parameters(cycle, draft, known, labels),
      },
      startStatement(job),
      { kind: "cycleCall", how: "", words: noWords },
    ]),
    functions(output.end),
    ...(free
      ? [
          { kind: "label" as const, label: CONTOUR_LABEL },
          ...contourStatements(job.contour),
          { kind: "label" as const, label: 0 },
        ]
      : []),
    { kind: "end", name, unit: "MM" },
  ];
}

/** Style of a job's Klartext. Manual layout and DIN/ISO are run as a TNC 640 file. */
export const styleOfJob = ({ layout, output: { newLine } }: Pick<Job, "layout" | "output">): Style => ({
  ...LAYOUTS[layout === "tnc7" ? "tnc7" : "tnc640"],
  newLine,
});

/** Complete program text of a job for its control; empty for an unknown cycle. */
export function printJob(job: SetJob, labels: Labels): string {
  const cycle = cycleByNumber(job.cycle);
  return cycle ? programText(jobStatements(job, cycle, labels), styleOfJob(job), job.output.numbered) : "";
}

/** The same program in the layout of the printed manual: for reading only, no control loads it. */
export function printAsInManual(job: SetJob, labels: Labels): string {
  const cycle = cycleByNumber(job.cycle);
  return cycle ? programText(jobStatements(job, cycle, labels), LAYOUTS.manual, job.output.numbered) : "";
}
