/**
 * How a program is written: as a file of either control, in DIN/ISO, or with the look of the printed manual, which no
 * control loads.
 */
export const JOB_LAYOUTS = ["tnc640", "tnc7", "iso", "manual"] as const;
export type JobLayout = (typeof JOB_LAYOUTS)[number];

/**
 * How the text of a program is written for one machine: M functions of its builder, how the tool leaves, and what the
 * way to the control asks of the file. It is kept with the work and goes along when the work is shared.
 */
export interface NcOutput {
  /** M function that starts the turning spindle. */
  readonly spindleOn: number;
  /** M function that stops it before the end of the program; null where M30 or M2 does. */
  readonly spindleOff: number | null;
  /**
   * Where the tool goes at the end: to the safe position, or along the tool axis to the limit of travel (M140 MB MAX).
   */
  readonly retract: "position" | "limit";
  /** M30 or M2. */
  readonly end: 30 | 2;
  readonly numbered: boolean;
  readonly newLine: "\n" | "\r\n";
  /** The name of the program in capitals, whatever was typed. */
  readonly capitals: boolean;
}

/** M303 and M305 stand in the printed examples (A); which functions turn the spindle of a machine, its builder says. */
const MANUAL: NcOutput = {
  spindleOn: 303,
  spindleOff: 305,
  retract: "position",
  end: 30,
  numbered: true,
  newLine: "\n",
  capitals: false,
};

/**
 * Settings to begin with: the functions of the manual, the same on a machine whose only spindle turns, and a file for
 * older transfer.
 */
export const NC_OUTPUTS = {
  manual: MANUAL,
  mainSpindle: { ...MANUAL, spindleOn: 3, spindleOff: 5 },
  transfer: { ...MANUAL, spindleOn: 3, spindleOff: 5, numbered: false, newLine: "\r\n", capitals: true },
} as const satisfies Readonly<Record<string, NcOutput>>;
export type NcOutputName = keyof typeof NC_OUTPUTS;
export const NC_OUTPUT_NAMES = Object.keys(NC_OUTPUTS) as readonly NcOutputName[];

/** Works that were kept before there was this setting were written so: M30 alone stopped the spindle. */
export const EARLIER_OUTPUT: NcOutput = { ...MANUAL, spindleOff: null };

const KEYS = Object.keys(MANUAL) as readonly (keyof NcOutput)[];

/** The name of settings that are one of those to begin with; null for the builder's own. */
export const nameOfOutput = (output: NcOutput): NcOutputName | null =>
  NC_OUTPUT_NAMES.find((name) => KEYS.every((key) => NC_OUTPUTS[name][key] === output[key])) ?? null;

/** Whether an M function can be set: a whole number that a control takes. */
export const isFunctionNumber = (m: unknown): m is number =>
  typeof m === "number" && Number.isInteger(m) && m >= 0 && m <= 999;

/** Whether plain data, that anybody may have written, are settings. */
export function isNcOutput(raw: unknown): raw is NcOutput {
  if (typeof raw !== "object" || raw === null) return false;
  const { spindleOn, spindleOff, retract, end, numbered, newLine, capitals } = raw as Readonly<
    Record<keyof NcOutput, unknown>
  >;
  return (
    isFunctionNumber(spindleOn) &&
    (spindleOff === null || isFunctionNumber(spindleOff)) &&
    (retract === "position" || retract === "limit") &&
    (end === 30 || end === 2) &&
    typeof numbered === "boolean" &&
    (newLine === "\n" || newLine === "\r\n") &&
    typeof capitals === "boolean"
  );
}
