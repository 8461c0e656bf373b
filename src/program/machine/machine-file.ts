import { readJson } from "../files/bounded.ts";
import { z } from "zod/mini";
import type { MachineData } from "./machine-data.ts";
import { isNcOutput, type NcOutput } from "./nc-output.ts";

/** First member of a machine file: its format and edition. */
const FORMAT = "turnwise-machine/",
  EDITION = 1;
export const MACHINE_FORMAT = `${FORMAT}${EDITION}`;

/** A machine file: data for times, and NC output settings. */
export interface MachineFile extends MachineData {
  readonly output?: NcOutput;
}

/** Longest name, and longest file that is read, characters. */
const LONGEST_NAME = 60,
  LONGEST_FILE = 10_000;
/** Fewest and most points of a torque curve. */
const FEWEST_POINTS = 2,
  MOST_POINTS = 20;

/** Range of each number, in its unit: wide enough for any lathe, narrow enough to detect a wrong unit. */
export const MACHINE_RANGES = {
  /** mm/min */
  rapid: [100, 200_000],
  /** m/s² */
  acceleration: [0.05, 50],
  /** s */
  toolChange: [0, 600],
  /** rpm */
  most: [10, 99_999],
  /** s */
  runUp: [0, 120],
  /** kW */
  power: [0.1, 500],
  /** rpm, Nm */
  speed: [0, 99_999],
  torque: [0.1, 100_000],
} as const satisfies Readonly<Record<string, readonly [low: number, high: number]>>;

const within = (name: keyof typeof MACHINE_RANGES) => {
  const [low, high] = MACHINE_RANGES[name];
  return z.number().check(z.gte(low), z.lte(high));
};
const axes = (name: "rapid" | "acceleration") => z.optional(z.strictObject({ x: within(name), z: within(name) }));

type Points = readonly { readonly speed: number }[];
const rise = (points: Points) => points.every(({ speed }, i) => i === 0 || speed > (points[i - 1]?.speed ?? Infinity));

const spindle = z.strictObject({
  most: within("most"),
  runUp: z.optional(within("runUp")),
  power: z.optional(within("power")),
  torque: z.optional(
    z
      .array(z.strictObject({ speed: within("speed"), torque: within("torque") }))
      .check(z.minLength(FEWEST_POINTS), z.maxLength(MOST_POINTS), z.refine(rise, { params: { kind: "order" } })),
  ),
});

/** The machine file. */
export const machineSchema = z
  .strictObject({
    format: z.literal(MACHINE_FORMAT),
    name: z.string().check(z.minLength(1), z.maxLength(LONGEST_NAME)),
    rapid: axes("rapid"),
    acceleration: axes("acceleration"),
    toolChange: z.optional(within("toolChange")),
    spindle: z.optional(spindle),
    output: z.optional(z.custom<NcOutput>(isNcOutput)),
  })
  .check(
    z.refine(({ rapid, acceleration }) => rapid !== undefined || acceleration === undefined, {
      path: ["acceleration"],
      params: { kind: "alone" },
    }),
  );

/** A problem of a machine file, and its path: `spindle.torque.2.speed`, empty for the whole file. */
export interface MachineProblem {
  readonly kind:
    | "notJson"
    | "notMachine"
    | "newer"
    | "missing"
    | "unknown"
    | "low"
    | "high"
    | "wrong"
    | "order"
    | "alone";
  readonly at: string;
  /** The exceeded limit. */
  readonly limit?: number;
}

type Found = NonNullable<ReturnType<typeof machineSchema.safeParse>["error"]>["issues"][number];

/** The value at a path in plain data. */
const valueAt = (raw: unknown, path: readonly PropertyKey[]): unknown =>
  path.reduce<unknown>(
    (value, key) =>
      typeof value === "object" && value !== null ? (value as Record<PropertyKey, unknown>)[key] : undefined,
    raw,
  );

function problemOf(found: Found, raw: unknown): MachineProblem {
  const at = found.path.map(String).join(".");
  switch (found.code) {
    case "unrecognized_keys":
      return { kind: "unknown", at: [...found.path.map(String), found.keys[0] ?? ""].join(".") };
    case "too_small":
      return { kind: "low", at, limit: Number(found.minimum) };
    case "too_big":
      return { kind: "high", at, limit: Number(found.maximum) };
    case "custom":
      return {
        kind: found.params?.["kind"] === "order" ? "order" : found.params?.["kind"] === "alone" ? "alone" : "wrong",
        at,
      };
    default:
      return { kind: valueAt(raw, found.path) === undefined ? "missing" : "wrong", at };
  }
}

const isRecord = (raw: unknown): raw is Readonly<Record<string, unknown>> =>
  typeof raw === "object" && raw !== null && !Array.isArray(raw);

/** A machine file as read, or all of its problems. */
export type ReadMachine =
  | { readonly machine: MachineFile }
  | { readonly problems: readonly [MachineProblem, ...MachineProblem[]] };

const refusal = (kind: MachineProblem["kind"]): ReadMachine => ({ problems: [{ kind, at: "" }] });

/** Reads the text of a machine file. Never throws. */
export function readMachine(text: string): ReadMachine {
  let raw: unknown = null;
  try {
    raw = text.length > LONGEST_FILE ? null : readJson(text);
  } catch (error) {
    return refusal(error instanceof SyntaxError ? "notJson" : "notMachine");
  }
  const format = isRecord(raw) && typeof raw["format"] === "string" ? raw["format"] : "";
  if (!format.startsWith(FORMAT)) return refusal("notMachine");
  if (Number(format.slice(FORMAT.length)) > EDITION) return refusal("newer");
  const read = machineSchema.safeParse(raw);
  if (!read.success) {
    const [first, ...others] = read.error.issues.map((found) => problemOf(found, raw));
    return first ? { problems: [first, ...others] } : refusal("wrong");
  }
  const { format: _, ...machine } = read.data;
  return { machine: machine as MachineFile };
}

/** Writes a machine file, in the order of the format. Nothing is rounded. */
export function writeMachine({ name, rapid, acceleration, toolChange, spindle: own, output }: MachineFile): string {
  return `${JSON.stringify({ format: MACHINE_FORMAT, name, rapid, acceleration, toolChange, spindle: own, output }, null, 2)}\n`;
}

/** Machine data of a stored text, for times; null where it is empty or invalid. */
export function machineOf(text: string): MachineData | null {
  const read = text === "" ? null : readMachine(text);
  if (!read || "problems" in read) return null;
  const { output: _, ...data } = read.machine;
  return data;
}
