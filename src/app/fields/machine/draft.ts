import { anyNumber, readText } from "../../../program/values/field.ts";
import type { MachineData } from "../../../program/machine/machine-data.ts";
import {
  MACHINE_FORMAT,
  readMachine,
  type MachineProblem,
  type ReadMachine,
} from "../../../program/machine/machine-file.ts";

/** Numbers of the form, except the torque curve, each with its path in the file. */
export const MACHINE_FIELDS = {
  rapidX: "rapid.x",
  rapidZ: "rapid.z",
  accelerationX: "acceleration.x",
  accelerationZ: "acceleration.z",
  toolChange: "toolChange",
  most: "spindle.most",
  runUp: "spindle.runUp",
  power: "spindle.power",
} as const;
export type MachineField = keyof typeof MACHINE_FIELDS;

/** A point of the torque curve as typed. */
export interface DraftPoint {
  readonly speed: string;
  readonly torque: string;
}

/** Machine data as typed: an empty text is no value. */
export interface MachineDraft extends Readonly<Record<MachineField, string>> {
  readonly name: string;
  readonly torque: readonly DraftPoint[];
}

const typed = (n: number | undefined): string => (n === undefined ? "" : String(n));

/** Data as one types them. */
export const draftOfMachine = ({ name, rapid, acceleration, toolChange, spindle }: MachineData): MachineDraft => ({
  name,
  rapidX: typed(rapid?.x),
  rapidZ: typed(rapid?.z),
  accelerationX: typed(acceleration?.x),
  accelerationZ: typed(acceleration?.z),
  toolChange: typed(toolChange),
  most: typed(spindle?.most),
  runUp: typed(spindle?.runUp),
  power: typed(spindle?.power),
  torque: (spindle?.torque ?? []).map(({ speed, torque }) => ({ speed: typed(speed), torque: typed(torque) })),
});

/** A typed number; other text is passed on for the file check to reject. */
const valueOf = (text: string): number | string | undefined =>
  text.trim() === "" ? undefined : (readText(anyNumber, text).value ?? text);

/** A group of values; undefined if all are empty. */
function group<T extends object>(values: T): T | undefined {
  return Object.values(values).some((value) => value !== undefined) ? values : undefined;
}

/** Reads the form by the rules of the file. */
export function readMachineDraft(draft: MachineDraft): ReadMachine {
  const of = (field: MachineField) => valueOf(draft[field]);
  const torque = draft.torque.map((point) => ({ speed: valueOf(point.speed), torque: valueOf(point.torque) }));
  return readMachine(
    JSON.stringify({
      format: MACHINE_FORMAT,
      name: draft.name.trim(),
      rapid: group({ x: of("rapidX"), z: of("rapidZ") }),
      acceleration: group({ x: of("accelerationX"), z: of("accelerationZ") }),
      toolChange: of("toolChange"),
      spindle: group({
        most: of("most"),
        runUp: of("runUp"),
        power: of("power"),
        torque: torque.length > 0 ? torque : undefined,
      }),
    }),
  );
}

/** The problem at a path of the file, if any. */
export const problemAt = (problems: readonly MachineProblem[], at: string): MachineProblem | undefined =>
  problems.find((problem) => problem.at === at);
