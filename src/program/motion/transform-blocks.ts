import { NO_TRANSFORM, settledTransform, type CoordinateFrame, type Transform } from "../tools/coordinates-frame.ts";
import { readValue, VALUE } from "../../nc/value.ts";
import type { AxisName, Value } from "../../nc/words.ts";
import type { Machine } from "../state/machine.ts";
import type { Modal } from "../state/modal.ts";

/** Frame of milling coordinates that are more than shifted; null otherwise. */
export const frameOf = ({ turning, datum, transform }: Modal): CoordinateFrame | null =>
  turning || transform === NO_TRANSFORM ? null : { shift: datum, transform };

/** A block that changes the transform: its name and index. */
interface At {
  readonly what: string;
  readonly index: number;
}

/**
 * Applies a change. For turning no manual defines mirrored, rotated or scaled coordinates, so nothing is verified
 * there. Nor is a contour whose transform changes while it is compensated.
 */
function change(machine: Machine, by: Partial<Transform>, { what, index }: At): void {
  const before = machine.now.transform;
  const transform = settledTransform({ ...before, ...by });
  if (JSON.stringify(before) === JSON.stringify(transform)) return;
  machine.set({ transform });
  if ((machine.now.turning && transform !== NO_TRANSFORM) || machine.now.compensation !== "R0")
    machine.log.leaveUnproved(what, index);
}

/** Mirrored, rotated or scaled coordinates continue into turning, where they are not simulated. */
export function transformedTurning(machine: Machine, index: number): void {
  if (machine.now.transform !== NO_TRANSFORM) machine.log.leaveUnproved("FUNCTION MODE TURN", index);
}

/** Mirrored axes from here on, replacing the previous ones. */
export function mirrorAxes(machine: Machine, axes: readonly AxisName[] | "reset", at: At): void {
  const has = (axis: AxisName) => axes !== "reset" && axes.includes(axis);
  change(machine, { mirror: { x: has("X"), y: has("Y"), z: has("Z") } }, at);
  if (axes !== "reset" && axes.some((a) => !"XYZ".includes(a))) machine.log.leaveUnproved(at.what, at.index);
}

export function turnPlane(
  machine: Machine,
  angle: { readonly value: Value; readonly incremental: boolean } | "reset",
  at: At,
): void {
  if (angle === "reset") return change(machine, { rotation: 0 }, at);
  const n = machine.number(angle.value, at.index);
  if (n === null) machine.log.leaveUnproved(at.what, at.index);
  else change(machine, { rotation: n + (angle.incremental ? machine.now.transform.rotation : 0) }, at);
}

/** The three axes alike, about the datum. */
export function scaleAxes(machine: Machine, factor: Value | "reset", at: At): void {
  const n = factor === "reset" ? 1 : machine.number(factor, at.index);
  if (n === null || n <= 0) return machine.log.leaveUnproved(at.what, at.index);
  change(machine, { scale: { x: n, y: n, z: n }, centre: NO_TRANSFORM.centre }, at);
}

interface AxisScale {
  readonly factor: Value | null;
  readonly centre: Value | null;
}

/** Scales single axes, each about its own centre; an unnamed axis keeps its factor. */
function scaleEach(machine: Machine, factors: ReadonlyMap<AxisName, AxisScale>, at: At): void {
  const now = machine.now.transform;
  const [scales, centres] = [{ ...now.scale }, { ...now.centre }];
  for (const [axis, { factor, centre }] of factors) {
    const key = axis.toLowerCase() as "x" | "y" | "z";
    const n = factor === null ? scales[key] : machine.number(factor, at.index);
    const c = centre === null ? 0 : machine.number(centre, at.index);
    if (n === null || n <= 0 || c === null) return machine.log.leaveUnproved(at.what, at.index);
    [scales[key], centres[key]] = [n, machine.length(c)];
  }
  change(machine, { scale: scales, centre: centres }, at);
}

const TURN = new RegExp(String.raw`(I?)ROT[ \t]*(${VALUE})`, "i");
const FACTOR = new RegExp(String.raw`SCL[ \t]*(${VALUE})`, "i");
const WORDS = new RegExp(String.raw`(CC)?([XYZ])[ \t]*(${VALUE})`, "gi");

const LINES: Readonly<Record<number, (machine: Machine, text: string, at: At) => void>> = {
  8: (machine, text, at) => mirrorAxes(machine, (text.toUpperCase().match(/[A-Z]/g) ?? []) as AxisName[], at),
  10: (machine, text, at) => {
    const m = TURN.exec(text);
    const value = m ? readValue(m[2] ?? "") : null;
    if (value === null) machine.log.leaveUnproved(at.what, at.index);
    else turnPlane(machine, { value, incremental: m?.[1] !== "" }, at);
  },
  11: (machine, text, at) => {
    const value = readValue(FACTOR.exec(text)?.[1] ?? "");
    if (value === null) machine.log.leaveUnproved(at.what, at.index);
    else scaleAxes(machine, value, at);
  },
  26: (machine, text, at) => {
    const factors = new Map<AxisName, AxisScale>();
    for (const [, centre, letter = "", digits = ""] of text.matchAll(WORDS)) {
      const axis = letter.toUpperCase() as AxisName;
      const before = factors.get(axis) ?? { factor: null, centre: null };
      factors.set(axis, { ...before, [centre ? "centre" : "factor"]: readValue(digits) });
    }
    if (factors.size === 0) machine.log.leaveUnproved(at.what, at.index);
    else scaleEach(machine, factors, at);
  },
};

export const transforms = (cycle: number): boolean => cycle in LINES;

/** Lines of cycles 8, 10, 11 and 26 behind their heads. */
export function transformLine(
  machine: Machine,
  s: { readonly cycle: number; readonly line: number; readonly text: string },
  index: number,
): void {
  if (s.line > 0) LINES[s.cycle]?.(machine, s.text, { what: `CYCL DEF ${s.cycle}`, index });
}
