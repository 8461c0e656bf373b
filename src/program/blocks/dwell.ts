import { VALUE, readValue } from "../../nc/value.ts";
import { speedAt } from "../../kernel/time/time.ts";
import type { Machine } from "../state/machine.ts";

/** The cycle of a dwell. */
export const DWELL_CYCLE = 9;
const LAST_NUMBER = new RegExp(String.raw`(${VALUE})[ \t]*$`, "i");
const FUNCTION_DWELL = new RegExp(String.raw`^FUNCTION[ \t]+DWELL[ \t]+(TIME|REV)[ \t]*(${VALUE})`, "i");

function dwells(machine: Machine, digits: string | undefined, unit: "TIME" | "REV", index: number): void {
  const value = digits === undefined ? null : readValue(digits);
  const n = value === null ? null : machine.number(value, index);
  if (n === null || !(n > 0)) return;
  if (unit === "TIME") return machine.log.addSeconds("dwell", n);
  const { spindle, tip } = machine;
  const speed = spindle ? speedAt(spindle, tip?.r ?? 0) : 0;
  if (speed > 0) machine.log.addSeconds("dwell", (60 * n) / speed);
}

/** A line of cycle 9: its number counts seconds. */
export const dwellLine = (machine: Machine, text: string, index: number): void =>
  dwells(machine, LAST_NUMBER.exec(text)?.[1], "TIME", index);

/** FUNCTION DWELL, in seconds or spindle revolutions; other text is ignored. */
export function dwellFunction(machine: Machine, text: string, index: number): void {
  const [, unit = "", digits] = FUNCTION_DWELL.exec(text) ?? [];
  if (unit !== "") dwells(machine, digits, unit.toUpperCase() === "REV" ? "REV" : "TIME", index);
}
