import { diameter, length, radius, toDiameter, toRadius } from "../kernel/units.ts";
import { readWords } from "../nc/read-words.ts";
import { Scan } from "../nc/scan.ts";
import type { AxisName, AxisWord } from "../nc/statement.ts";
import type { Machine } from "./machine.ts";
import type { Datum } from "./modal.ts";

/** The cycle that shifts the datum, one coordinate a line. */
export const DATUM_CYCLE = 7;

const KEYS: Readonly<Partial<Record<AxisName, keyof Datum>>> = { X: "x", Y: "y", Z: "z" };

/**
 * From a coordinate of the program to that of the workpiece, in the measure of its word: of X a diameter while turning. Null for an
 * axis that no path runs along.
 */
export function datumShiftOf(machine: Machine, axis: AxisName): number | null {
  const key = KEYS[axis];
  if (!key || (key === "y" && machine.now.turning)) return null;
  const by = machine.now.datum[key];
  return key === "x" && machine.now.turning ? toDiameter(radius(by)) : by;
}

/** Moves the datum: an absolute word takes the place of the shift in its axis, an incremental one adds to it. */
export function shiftDatum(machine: Machine, words: readonly AxisWord[], what: string, index: number): void {
  for (const w of words) {
    const n = machine.number(w.value, index);
    const key = KEYS[w.axis];
    if (!key) {
      if (n !== 0) machine.log.leaveUnproved(what, index);
    } else if (n === null) machine.log.leaveUnproved(what, index);
    else {
      const typed = machine.length(n);
      const by = key === "x" && machine.now.turning ? toRadius(diameter(typed)) : typed;
      machine.set({ datum: { ...machine.now.datum, [key]: length(by + (w.incremental ? machine.now.datum[key] : 0)) } });
    }
  }
}

/** The lines of cycle 7 behind its head: a coordinate each, or a row of a datum table, which the run does not have. */
export function datumLine(machine: Machine, text: string, what: string, index: number): void {
  const scan = new Scan(text, 0);
  const { axes, extra } = readWords(scan);
  if (extra.length > 0) machine.log.leaveUnproved(what, index);
  shiftDatum(machine, axes, what, index);
}
