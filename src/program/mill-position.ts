import type { PlanePoint } from "../kernel/plane.ts";
import type { AxisWord } from "../nc/statement.ts";
import { shiftOf } from "./datum.ts";
import { programIssue } from "./issue.ts";
import type { Machine } from "./machine.ts";

/** A position of a mill in the workpiece, mm; null where nobody knows. */
export interface Position {
  x: number | null;
  y: number | null;
  z: number | null;
}

/** A plane that an arc may lie in. Its angles count from the first axis towards the second: X to Y, Y to Z, Z to X. */
export type Plane = "XY" | "YZ" | "ZX";
/** A plane beside that of the tool axis Z. */
export type SidePlane = Exclude<Plane, "XY">;

/** CC of a mill: its coordinates, those it does not name where the tool stood, and the plane that it names. */
export interface MillPole {
  readonly at: Readonly<Position>;
  readonly plane: Plane;
}

const AXES_OF = { XY: ["x", "y"], YZ: ["y", "z"], ZX: ["z", "x"] } as const;

/** A position seen in a plane; null when nobody knows where that is. */
export function inPlane(p: Readonly<Position>, plane: Plane = "XY"): PlanePoint | null {
  const [a, b] = AXES_OF[plane];
  const [first, second] = [p[a], p[b]];
  return first === null || second === null ? null : { x: first, y: second };
}

/** The two coordinates of a point of a plane. */
export function offPlane(p: PlanePoint, plane: Plane): { x?: number; y?: number; z?: number } {
  const [a, b] = AXES_OF[plane];
  return { [a]: p.x, [b]: p.y };
}

const isPlaneAxis = (axis: string): axis is "X" | "Y" | "Z" => axis === "X" || axis === "Y" || axis === "Z";

/** The axis words of a block on top of the position before it. */
export function coordinates(machine: Machine, words: readonly AxisWord[], index: number): Position {
  const { x, y, z } = machine.mill;
  const to: Position = { x, y, z };
  for (const w of words) {
    const n = machine.number(w.value, index);
    if (!isPlaneAxis(w.axis)) {
      if (n !== null && n !== 0) machine.leaveUnproved(`${w.incremental ? "I" : ""}${w.axis}`, index);
      continue;
    }
    const key = w.axis.toLowerCase() as keyof Position;
    const before = to[key];
    if (n === null) to[key] = machine.lose();
    else if (!w.incremental) to[key] = machine.length(n) + shiftOf(machine, w.axis);
    else if (before !== null) to[key] = before + machine.length(n);
    else if (machine.lost === null) machine.say(programIssue("startUnknown", "warning", {}), index);
  }
  return to;
}
