/** Layout of a program: as a file of either control, in DIN/ISO, or like the printed manual, which no control loads. */
export const JOB_LAYOUTS = ["tnc640", "tnc7", "iso", "manual"] as const;
export type JobLayout = (typeof JOB_LAYOUTS)[number];

/**
 * NC output for one machine: M functions of its builder, retraction, and file format for the transfer. It is stored
 * with the job and shared with it.
 */
export interface NcOutput {
  /** M function that starts the turning spindle. */
  readonly spindleOn: number;
  /** M function that stops it before the end of the program; null where M30 or M2 does. */
  readonly spindleOff: number | null;
  /** Final retraction: to the safe position, or along the tool axis to the limit of travel (M140 MB MAX). */
  readonly retract: "position" | "limit";
  /** M30 or M2. */
  readonly end: 30 | 2;
  readonly numbered: boolean;
  readonly newLine: "\n" | "\r\n";
  /** Writes the program name in capitals. */
  readonly capitals: boolean;
}

/** M303 and M305 are those of the printed examples (A); the machine builder defines the actual functions. */
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
 * Presets: the functions of the manual, those of a machine with a turning spindle only, and a file for older transfer.
 */
export const NC_OUTPUTS = {
  manual: MANUAL,
  mainSpindle: { ...MANUAL, spindleOn: 3, spindleOff: 5 },
  transfer: { ...MANUAL, spindleOn: 3, spindleOff: 5, numbered: false, newLine: "\r\n", capitals: true },
} as const satisfies Readonly<Record<string, NcOutput>>;
export type NcOutputName = keyof typeof NC_OUTPUTS;
export const NC_OUTPUT_NAMES = Object.keys(NC_OUTPUTS) as readonly NcOutputName[];

/** Output of jobs stored before this setting existed: M30 alone stopped the spindle. */
export const LEGACY_OUTPUT: NcOutput = { ...MANUAL, spindleOff: null };

const KEYS = Object.keys(MANUAL) as readonly (keyof NcOutput)[];

/** Preset name of an output; null for custom settings. */
export const nameOfOutput = (output: NcOutput): NcOutputName | null =>
  NC_OUTPUT_NAMES.find((name) => KEYS.every((key) => NC_OUTPUTS[name][key] === output[key])) ?? null;

/** Whether an M function is valid: a whole number that a control accepts. */
export const isFunctionNumber = (m: unknown): m is number =>
  typeof m === "number" && Number.isInteger(m) && m >= 0 && m <= 999;

/** Whether untrusted plain data are valid settings. */
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
