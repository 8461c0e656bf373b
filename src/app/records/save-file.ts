import { NC_LANGUAGES } from "../../nc/nc-languages.ts";
import { z } from "zod/mini";
import { measure, moment, whole } from "../../program/files/bounded.ts";
import { LARGEST_PROGRAM } from "../base/limits.ts";
import type { MeasuredPlace, Measurement } from "../../kernel/plan/measured.ts";
import { askedQuestions, otherNumbers } from "../../course/made/other-numbers.ts";
import { at } from "../../kernel/geometry/point.ts";
import { NUMBER_PARAMETER } from "../../nc/value.ts";
import { CLAMPING_KINDS } from "../../program/clamping/words.ts";
import type { ContourRow, Job, TaskWork } from "../../program/job/job.ts";
import { SETUP_PLACES } from "../../program/job/setup-places.ts";
import { LEGACY_OUTPUT, isNcOutput, JOB_LAYOUTS, type NcOutput } from "../../program/machine/nc-output.ts";
import { toolRows } from "../document/tool-rows.ts";
import {
  LONGEST_MACHINE,
  LONGEST_REMARKS,
  MOST_MEASURED,
  type ProgramWork,
  type Work,
  type WorkFile,
} from "../document/work.ts";

/** Incremented with each change of the layout; each step has its upgrade below. */
export const SAVE_VERSION = 3;

/** One work as it is kept on the device. */
export interface SaveFile {
  readonly version: number;
  /** Milliseconds since 1970, for the order of the list. */
  readonly savedAt: number;
  /** A job or a program. */
  readonly job: Work;
}

const PARAMETER_NAME = new RegExp(`^${NUMBER_PARAMETER}$`);
const text = z.string().check(z.maxLength(500));
/** Most rows of a contour and files of a program, far above what an operator makes. */
const MOST = { rows: 5000, files: 5000 };
/** Defaults of fields that older saves do not have. */
const later = { text: z._default(text, ""), flag: z._default(z.boolean(), false) };
const remarks = z.optional(z.string().check(z.maxLength(LONGEST_REMARKS)));
const point = z.pipe(
  z.object({ z: measure, r: measure }),
  z.transform(({ z: along, r }) => at(along, r)),
);
const segment = z.union([
  z.object({ kind: z.literal("line"), from: point, to: point }),
  z.object({ kind: z.literal("arc"), from: point, to: point, centre: point, turn: z.enum(["cw", "ccw"]) }),
]);
const measuredPlace = z.object({
  at: point,
  spot: z.enum(["corner", "centre", "edge", "path", "free"]),
  edge: z.optional(
    z.object({ of: z.enum(["contour", "blank", "stock"]), chain: whole, element: whole, shape: text, segment }),
  ),
});
const measurement = z.object({
  id: text,
  kind: z.enum(["diameter", "length", "depth", "distance", "radius", "angle", "wall"]),
  plane: z.enum(["ZX", "XY"]),
  places: z.array(measuredPlace).check(z.minLength(1), z.maxLength(2)),
  text: z.optional(point),
  moment: z.optional(
    z.object({
      step: whole,
      fraction: measure,
      block: z.optional(measure),
      pass: z.optional(measure),
      print: text,
    }),
  ),
});
const measured = z.optional(z.array(measurement).check(z.maxLength(MOST_MEASURED)));
/** A row of a contour as typed. */
export const contourRow = z.object({
  id: text,
  kind: z.enum(["L", "RND", "CHF", "CR", "CC", "C", "CT", "LP", "CP", "CTP", "UDC", "GRV"]),
  x: text,
  z: text,
  r: text,
  turn: z.enum(["cw", "ccw"]),
  incrementalX: z.boolean(),
  incrementalZ: z.boolean(),
  angle: later.text,
  length: later.text,
  tangent: later.flag,
  second: later.flag,
  form: later.text,
  words: z._default(z.record(z.string(), text), {}),
});
/** What a shared work contains. */
const handedOn = {
  tools: z.optional(toolRows),
  control: z.optional(z.enum(["TNC 640", "TNC7"])),
  // Read where times are calculated; invalid data counts as no machine.
  machine: z.optional(z.string().check(z.maxLength(LONGEST_MACHINE))),
};
/** The file of a task is checked by its own schema where it is used. */
const task = z.object({
  id: text,
  file: z.optional(z.unknown()),
  veiled: z.optional(z.boolean()),
  told: z.optional(z.array(text).check(z.maxLength(60))),
  varied: z.optional(otherNumbers),
  asked: z.optional(askedQuestions),
});
/** What belongs to every work. */
const ofWork = { ...handedOn, task: z.optional(task), name: text, remarks, material: z.optional(text), measured };
const output = z.custom<NcOutput>(isNcOutput);
const job = z.object({
  ...ofWork,
  cycle: whole,
  drafts: z.record(z.string().check(z.regex(/^\d+$/)), z.record(z.string(), text)),
  parameters: z._default(z.record(z.string().check(z.regex(PARAMETER_NAME)), text), {}),
  tool: z.nullable(measure),
  blank: z.object({ outside: text, bore: text, length: text, allowance: text }),
  start: z.object({ x: text, z: text }),
  proposals: z.optional(z.partialRecord(z.enum(SETUP_PLACES), text)),
  clamping: z.optional(z.object({ kind: z.enum(CLAMPING_KINDS), words: z.record(z.string(), text) })),
  spindle: z.object({ mode: z.enum(["constant", "surface"]), speed: text, cuttingSpeed: text, limit: text }),
  perRevolution: z.boolean(),
  rapid: text,
  contour: z.array(contourRow).check(z.maxLength(MOST.rows)),
  layout: z.enum(JOB_LAYOUTS),
  output,
  ncLanguage: z.enum(NC_LANGUAGES),
});
const textFile = {
  name: text,
  text: z.string().check(z.maxLength(LARGEST_PROGRAM)),
  encoding: z.enum(["utf-8", "windows-1252"]),
};
const workFile = z.object(textFile);
const program = z.object({
  ...ofWork,
  ...textFile,
  files: z.optional(z.array(workFile).check(z.maxLength(MOST.files))),
  skipMarked: z.optional(z.boolean()),
  output: z.optional(output),
});
/** Compile-time check that the layout above has every field of a work; a missing one would not be saved. */
type Complete = [
  keyof Job extends keyof z.output<typeof job> ? true : never,
  keyof ContourRow extends keyof z.output<typeof contourRow> ? true : never,
  keyof ProgramWork extends keyof z.output<typeof program> ? true : never,
  keyof WorkFile extends keyof z.output<typeof workFile> ? true : never,
  keyof Measurement extends keyof z.output<typeof measurement> ? true : never,
  keyof MeasuredPlace extends keyof z.output<typeof measuredPlace> ? true : never,
  keyof TaskWork extends keyof z.output<typeof task> ? true : never,
];
export const complete: Complete = [true, true, true, true, true, true, true];

const work = z.union([job, program]);
/** A date that no clock shows costs the date, not the work. */
export const UNDATED = 0;
const file = z.object({ version: z.literal(SAVE_VERSION), savedAt: z.catch(moment, UNDATED), job: work });

/** From version n to n + 1. A saved work passes all steps from its own version to the present one. */
export type Upgrades = Readonly<
  Record<number, (old: Readonly<Record<string, unknown>>) => Readonly<Record<string, unknown>>>
>;
const upgrades: Upgrades = {
  // Empty set-up fields became proposals, so a blank without bore or without stock on the face gets 0.
  1: (old) => ({ ...old, version: 2, job: withBlankSet(old["job"]) }),
  // The TNC 640 layout was that of the printed manual, and the program end could not be set; old works keep both.
  2: (old) => ({ ...old, version: 3, job: withLayoutKept(old["job"]) }),
};

const asText = (value: unknown, otherwise: string) => (value === "" ? otherwise : value);

function withBlankSet(job: unknown): unknown {
  if (
    typeof job !== "object" ||
    job === null ||
    !("blank" in job) ||
    typeof job.blank !== "object" ||
    job.blank === null
  )
    return job;
  const { blank } = job;
  const [bore, allowance] = [
    "bore" in blank ? blank.bore : undefined,
    "allowance" in blank ? blank.allowance : undefined,
  ];
  return { ...job, blank: { ...blank, bore: asText(bore, "0"), allowance: asText(allowance, "0") } };
}

function withLayoutKept(job: unknown): unknown {
  if (typeof job !== "object" || job === null || !("layout" in job)) return job;
  return { ...job, layout: job.layout === "tnc640" ? "manual" : job.layout, output: LEGACY_OUTPUT };
}

/** Upgrades a saved work of any version; other data is returned unchanged. */
export function upgrade(raw: unknown, steps: Upgrades = upgrades, to = SAVE_VERSION): unknown {
  let now = raw;
  for (let step = 0; step < to; step++) {
    if (typeof now !== "object" || now === null) return raw;
    const old = now as Readonly<Record<string, unknown>>;
    if (old["version"] === to) return old;
    const next = typeof old["version"] === "number" ? steps[old["version"]] : undefined;
    if (!next) return raw;
    now = next(old);
  }
  return now;
}

/** A saved work, or null when it is damaged or from a newer edition. Never throws. */
export function readSave(raw: unknown): SaveFile | null {
  try {
    const read = file.safeParse(upgrade(raw));
    return read.success ? (read.data as SaveFile) : null;
  } catch {
    return null;
  }
}

/** Reads a work from data that anybody may have written, in the layout of a version; null if it is none. */
export const plainWork = (raw: unknown, version = SAVE_VERSION): Work | null =>
  readSave({ version, savedAt: 0, job: raw })?.job ?? null;

/** True for a save of a newer edition, which this one cannot read and must not touch. */
export const isNewer = (raw: unknown): boolean =>
  typeof raw === "object" &&
  raw !== null &&
  "version" in raw &&
  typeof raw.version === "number" &&
  raw.version > SAVE_VERSION;

/** The name of a work in data that may be anything; null if there is none. */
export function nameIn(raw: unknown): string | null {
  const name = z.object({ job: z.object({ name: z.string() }) }).safeParse(raw).data?.job.name;
  return name === undefined || name === "" ? null : name.slice(0, 100);
}
