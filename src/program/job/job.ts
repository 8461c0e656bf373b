import type { NcLanguage } from "../../nc/nc-languages.ts";
import type { Cycle } from "../../cycles/define.ts";
import type { Measurement } from "../../kernel/plan/measured.ts";
import type { ClampingDraft } from "../clamping/words.ts";
import { NC_OUTPUTS, type JobLayout, type NcOutput } from "../machine/nc-output.ts";
import type { Control } from "../tools/plane-types.ts";
import { exampleDraft, type Draft } from "./read-draft.ts";
import type { ToolList } from "../tools/tool-list.ts";

/** One row of the contour table, as typed: end point, radius, corner element, centre. */
export interface ContourRow {
  readonly id: string;
  readonly kind: "L" | "RND" | "CHF" | "CR" | "CC" | "C" | "CT" | "LP" | "CP" | "CTP" | "UDC" | "GRV";
  /**
   * ⌀ mm. Empty: the coordinate stays as it was, except where an angle, a length or a tangential transition is given:
   * then it is sought. "?" seeks it in any case.
   */
  readonly x: string;
  readonly z: string;
  /** Radius of RND and CR, length of CHF, mm. */
  readonly r: string;
  readonly turn: "cw" | "ccw";
  readonly incrementalX: boolean;
  readonly incrementalZ: boolean;
  /** Angle of a line to +Z, degrees, counter-clockwise with X upwards; empty where none is given. */
  readonly angle: string;
  /** Length of a line, mm; empty where none is given. */
  readonly length: string;
  /** The element leaves the one before it tangentially. */
  readonly tangent: boolean;
  /** The less likely of two solutions is meant. */
  readonly second: boolean;
  /** Form of an undercut ("E" …) or direction of a recess ("RADIAL", "AXIAL"); empty elsewhere. */
  readonly form: string;
  /** Words of an undercut, a recess or a polar element by name, as typed: DEPTH, PR, IPA. */
  readonly words: Readonly<Record<string, string>>;
}

/** A contour row in which nothing is typed but what is given here. */
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

/**
 * Cylinder as typed, mm: outside and bore as ⌀, whole length, and how far it reaches in front of Z0. An empty field is
 * proposed.
 */
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

/** What a work that was handed on brings along: it runs with these in place of what the device has. */
export interface HandedOn {
  /** The only tools that it can call, as typed. */
  readonly tools?: ToolList;
  readonly control?: Control;
  /** Text of the machine file that its times are worked out with; empty where that is none. */
  readonly machine?: string;
}

/** What a work is that was begun as a task of the course, or of an instructor. */
export interface TaskWork {
  readonly id: string;
  /** The task itself, where it came from outside: plain data that is read where it is used. */
  readonly file?: unknown;
  /** Its run is not shown until something was foretold. */
  readonly veiled?: boolean;
  /** What was foretold, as typed, one text for each question. */
  readonly told?: readonly string[];
}

/** Everything an operator enters. All typed text is kept as typed; the program text is made from it. */
export interface Job extends HandedOn {
  readonly name: string;
  readonly cycle: number;
  /** Values of every cycle that was edited, so that changing the cycle loses nothing. */
  readonly drafts: Readonly<Record<number, Draft>>;
  /** Values of Q parameters that stand in prompts, as typed, by upper-case name: "Q5". */
  readonly parameters: Readonly<Record<string, string>>;
  /** Null as long as nobody has chosen one: it is proposed then. */
  readonly tool: number | null;
  readonly blank: BlankDraft;
  /** Tip at the cycle call: ⌀ and Z, mm. An empty field is proposed. */
  readonly start: { readonly x: string; readonly z: string };
  /** What it is held by, as typed; absent where nothing is stated. */
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
  /** What its setup sheet says to the setter. */
  readonly remarks?: string;
  /** What it is turned from, by its id in the cutting data; that of the device where it names none. */
  readonly material?: string;
  /** What was measured in its picture and stays there, in the order in which it was measured. */
  readonly measured?: readonly Measurement[];
  readonly task?: TaskWork;
}

/** A job with a value in every place of its set-up: set, or proposed. */
export interface SetJob extends Job {
  readonly tool: number;
}

/** A set-up of which nobody has set anything yet. */
export const UNSET = {
  tool: null,
  blank: { outside: "", bore: "", length: "", allowance: "" },
  start: { x: "", z: "" },
} as const;

/**
 * A job that shows the printed example of a cycle. A thread is cut at a constant speed: its pitch hangs on the turns of
 * the spindle.
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
