import type { NcLanguage } from "../../nc/nc-languages.ts";
import type { Cycle } from "../../cycles/define.ts";
import type { Measurement } from "../../kernel/plan/measured.ts";
import type { ClampingDraft } from "../clamping/words.ts";
import { NC_OUTPUTS, type JobLayout, type NcOutput } from "../machine/nc-output.ts";
import type { Control } from "../tools/plane-types.ts";
import { exampleDraft, type Draft } from "./read-draft.ts";
import type { ToolList } from "../tools/tool-list.ts";
import type { SetupPlace } from "./setup-places.ts";

/** One row of the contour table, as typed: end point, radius, corner element, centre. */
export interface ContourRow {
  readonly id: string;
  readonly kind: "L" | "RND" | "CHF" | "CR" | "CC" | "C" | "CT" | "LP" | "CP" | "CTP" | "UDC" | "GRV";
  /**
   * ⌀ mm. Empty: the coordinate is unchanged, or solved where an angle, a length or a tangential transition is given.
   * "?" always solves it.
   */
  readonly x: string;
  readonly z: string;
  /** Radius of RND and CR, length of CHF, mm. */
  readonly r: string;
  readonly turn: "cw" | "ccw";
  readonly incrementalX: boolean;
  readonly incrementalZ: boolean;
  /** Angle of a line to +Z, degrees, counter-clockwise with X upwards; empty without one. */
  readonly angle: string;
  /** Length of a line, mm; empty without one. */
  readonly length: string;
  /** Tangential transition from the previous element. */
  readonly tangent: boolean;
  /** Selects the less likely of two solutions. */
  readonly second: boolean;
  /** Form of an undercut ("E" …) or direction of a recess ("RADIAL", "AXIAL"); empty elsewhere. */
  readonly form: string;
  /** Words of an undercut, a recess or a polar element by name, as typed: DEPTH, PR, IPA. */
  readonly words: Readonly<Record<string, string>>;
}

/** A contour row with the given cells only. */
export const newRow = (id: string, given: Partial<ContourRow> = {}): ContourRow => ({
  kind: "L",
  x: "",
  z: "",
  r: "",
  turn: "cw",
  incrementalX: false,
  incrementalZ: false,
  angle: "",
  length: "",
  tangent: false,
  second: false,
  form: "",
  words: {},
  ...given,
  id,
});

/** Cylinder as typed, mm: outside and bore as ⌀, total length, and length in front of Z0. Empty fields are proposed. */
export interface BlankDraft {
  readonly outside: string;
  readonly bore: string;
  readonly length: string;
  readonly allowance: string;
}

/** Spindle as typed: rpm for a constant speed; m/min and limit in rpm for a constant cutting speed. */
export interface SpindleDraft {
  readonly mode: "constant" | "surface";
  readonly speed: string;
  readonly cuttingSpeed: string;
  readonly limit: string;
}

/** Environment of a shared job: replaces that of the device. */
export interface HandedOn {
  /** Its only available tools, as typed. */
  readonly tools?: ToolList;
  readonly control?: Control;
  /** Text of the machine file for its times; empty without one. */
  readonly machine?: string;
}

/** Data of a job that is an exercise of the course or of an instructor. */
export interface TaskWork {
  readonly id: string;
  /** The task itself, for an imported one: plain data, validated where used. */
  readonly file?: unknown;
  /** Its run is hidden until the learner has predicted something. */
  readonly veiled?: boolean;
  /** The predictions as typed, one text per question. */
  readonly told?: readonly string[];
  /** Other numbers in its program: the lines, the numbers that its words name, from and to, and the tries before. */
  readonly varied?: {
    readonly lines: readonly string[];
    readonly named: readonly (readonly [string, string])[];
    readonly at: number;
  };
  /** The questions that are asked again, from 0; absent: all. */
  readonly asked?: readonly number[];
}

/** What belongs to every work, whatever its kind. */
export interface OfWork extends HandedOn {
  readonly name: string;
  /** Remarks on its setup sheet. */
  readonly remarks?: string;
  /** Id of its material in the cutting data; by default that of the device. */
  readonly material?: string;
  /** Measurements in its picture, in the order they were made. */
  readonly measured?: readonly Measurement[];
  readonly task?: TaskWork;
}

/** Everything an operator enters, kept as typed; the program text is generated from it. */
export interface Job extends OfWork {
  readonly cycle: number;
  /** Values of every edited cycle, so that changing the cycle loses nothing. */
  readonly drafts: Readonly<Record<number, Draft>>;
  /** Values of Q parameters in prompts, as typed, by upper-case name: "Q5". */
  readonly parameters: Readonly<Record<string, string>>;
  /** Null until one is chosen: it is proposed then. */
  readonly tool: number | null;
  readonly blank: BlankDraft;
  /** Tip at the cycle call: ⌀ and Z, mm. An empty field is proposed. */
  readonly start: { readonly x: string; readonly z: string };
  /** What was proposed for a field of the set-up when it was set. A different proposal is shown beside the field. */
  readonly proposals?: Readonly<Partial<Record<SetupPlace, string>>>;
  /** Clamping as typed; absent without one. */
  readonly clamping?: ClampingDraft;
  readonly spindle: SpindleDraft;
  /** M136: feeds in mm/rev. */
  readonly perRevolution: boolean;
  /** Rapid rate for the time estimate only, mm/min. */
  readonly rapid: string;
  readonly contour: readonly ContourRow[];
  readonly layout: JobLayout;
  readonly output: NcOutput;
  readonly ncLanguage: NcLanguage;
}

/** A job with a complete set-up: set or proposed values. */
export interface SetJob extends Job {
  readonly tool: number;
}

/** A set-up with nothing set. */
export const UNSET = {
  tool: null,
  blank: { outside: "", bore: "", length: "", allowance: "" },
  start: { x: "", z: "" },
} as const;

/**
 * A job with the printed example of a cycle. A thread is cut at constant speed: its pitch depends on the spindle
 * revolutions.
 */
export function exampleJob(cycle: Cycle): SetJob {
  const example = cycle.setup;
  return {
    name: `${example.name}${cycle.number}`,
    cycle: cycle.number,
    drafts: { [cycle.number]: exampleDraft(cycle) },
    parameters: {},
    tool: example.tool,
    blank: { ...example.blank, bore: example.blank.bore || "0" },
    start: example.start,
    spindle: {
      mode: cycle.group === "thread" ? "constant" : "surface",
      speed: "800",
      cuttingSpeed: "180",
      limit: "2500",
    },
    perRevolution: true,
    rapid: "10000",
    contour: example.contour.map((r, i) => newRow(`e${i + 1}`, r)),
    layout: "tnc640",
    output: NC_OUTPUTS.manual,
    ncLanguage: "en",
  };
}
