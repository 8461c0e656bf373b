import { diameter, length, radius, toDiameter, toRadius } from "../../kernel/units.ts";
import { readWords } from "../../nc/read-words.ts";
import { Scan } from "../../nc/scan.ts";
import type { AxisName, AxisWord } from "../../nc/words.ts";
import type { Machine } from "../state/machine.ts";
import { NO_SHIFT, type Datum } from "../state/modal.ts";

/** The cycle that shifts the datum, one coordinate a line. */
export const DATUM_CYCLE = 7;

const KEYS: Readonly<Partial<Record<AxisName, keyof Datum>>> = { X: "x", Y: "y", Z: "z" };

const ALL: readonly (keyof Datum)[] = ["x", "y", "z"];

/**
 * Offset from program to workpiece coordinates, in the measure of the word: a diameter for X while turning. Null for an
 * axis without a path. An unknown shift makes a turning position unknown, to avoid false findings; a milling path,
 * which cuts no stock here, continues from the last known datum.
 */
export function datumShiftOf(machine: Machine, axis: AxisName): number | "unknown" | null {
  const key = KEYS[axis];
  if (!key || (key === "y" && machine.now.turning)) return null;
  if (machine.now.turning && machine.now.unknownDatum.includes(key)) return "unknown";
  const by = machine.now.datum[key];
  return key === "x" && machine.now.turning ? toDiameter(radius(by)) : by;
}

/** Moves the datum: an absolute word replaces the shift of its axis, an incremental one adds to it. */
export function shiftDatum(machine: Machine, words: readonly AxisWord[], what: string, index: number): void {
  for (const w of words) {
    const n = machine.number(w.value, index);
    const key = KEYS[w.axis];
    if (!key) {
      if (n !== 0) machine.log.leaveUnproved(what, index);
    } else if (n === null) {
      machine.log.leaveUnproved(what, index);
      machine.set({ unknownDatum: [...others(machine, key), key] });
    } else {
      const typed = machine.length(n);
      const by = key === "x" && machine.now.turning ? toRadius(diameter(typed)) : typed;
      machine.set({
        datum: { ...machine.now.datum, [key]: length(by + (w.incremental ? machine.now.datum[key] : 0)) },
      });
      if (!w.incremental) machine.set({ unknownDatum: others(machine, key) });
    }
  }
}

const others = (machine: Machine, key: keyof Datum) => machine.now.unknownDatum.filter((k) => k !== key);

/** TRANS DATUM RESET. */
export const resetDatum = (machine: Machine): void => machine.set({ datum: NO_SHIFT, unknownDatum: [] });

/** A row of a datum table, which is not available. */
export function tableDatum(machine: Machine, what: string, index: number): void {
  machine.log.leaveUnproved(what.slice(0, 60), index);
  machine.set({ unknownDatum: ALL });
}

const ROW = /^#[ \t]*\S+/;

/** Lines of cycle 7 behind its head: one coordinate each, or a row of a datum table, which is not available. */
export function datumLine(machine: Machine, text: string, what: string, index: number): void {
  const row = ROW.exec(text.trim())?.[0];
  if (row !== undefined) return tableDatum(machine, `${what} ${row}`, index);
  const scan = new Scan(text, 0);
  const { axes, extra } = readWords(scan);
  if (extra) machine.log.leaveUnproved(what, index);
  shiftDatum(machine, axes, what, index);
}
