import { cycleByNumber } from "../../cycles/index.ts";
import type { CycleParameter } from "../../nc/words.ts";
import { NUMBER_PARAMETER, PARAMETER, readValue, VALUE } from "../../nc/value.ts";
import { NO_TRANSFORM } from "../tools/coordinates-frame.ts";
import { dwellFunction, dwellLine, DWELL_CYCLE } from "./dwell.ts";
import type { Machine } from "../state/machine.ts";
import { NO_SHIFT } from "../state/modal.ts";
import { uncorrectTool } from "./tool-call.ts";

/** Unread blocks that leave path and stock unchanged: messages, tables, strings, pulsating feeds, counters, logs. */
const HARMLESS = new RegExp(
  String.raw`^(?:FN[ \t]*(?:1[4569]|2[0679]|3[789])[ \t]*:|FUNCTION[ \t]+(?:TCPM|RESET|FEED|S-PULSE|COUNT|DWELL|DCM|FILE|AFC|LIFTOFF|` +
    String.raw`SECTION[ \t]+MONITORING)|AFC|LIFTOFF|SECTION[ \t]+MONITORING|` +
    String.raw`DECLARE|OPEN|CLOSE|SEL[ \t]+(?:TABLE|CORR-TABLE)|PATTERN[ \t]+DEF|` +
    String.raw`POLARKIN[ \t]+OFF|MONITORING|STOP|PLANE[ \t]+RESET)`,
  "i",
);
/** Resets the tool corrections, in one system or in both; moves no axis. */
const UNCORRECTING = /^(?:FUNCTION[ \t]+)?(?:TURNDATA[ \t]+CORR[ \t]+OFF|CORRDATA[ \t]+RESET)\b(?:.*?(TCS|WPL))?/i;
/** FN 18 and FN 28 only read a value into a parameter. */
const READING = new RegExp(String.raw`^FN[ \t]*(?:18|28)[ \t]*:[^=]*?(${NUMBER_PARAMETER})`, "i");
/** After a program or a probe the tool position is unknown. */
const ELSEWHERE = /^(?:CALL[ \t]+(?:PGM|SELECTED)|TCH[ \t]+PROBE|CALL[ \t]+LBL)/i;
const PROBE = /^TCH[ \t]+PROBE/i;
/** A formula that reads values of the machine or its tables. */
const UNREAD_ASSIGNMENT = new RegExp(
  String.raw`^(?:FN[ \t]*\d+[ \t]*:[ \t]*|DECLARE[ \t]+STRING[ \t]+)?(${PARAMETER})[ \t]*=`,
  "i",
);
const ANY_PARAMETER = new RegExp(String.raw`(${PARAMETER})(?![ \t]*=)`, "gi");
const SQL = /^SQL[ \t]+([A-Z]*)/i;

/** SQL reads into the parameters it names; BIND ties them to columns for every later fetch. */
function readTable(machine: Machine, text: string): void {
  const word = SQL.exec(text)?.[1]?.toUpperCase();
  const named = [...text.replace(/"[^"]*"|'[^']*'/g, "").matchAll(ANY_PARAMETER)].map(([name]) => name.toUpperCase());
  if (word === "BIND") machine.known.bind(named);
  for (const name of [...named, ...machine.known.bound]) machine.known.markUnknown(name);
}

/** A probe writes into the parameters it names; the older measuring cycle also into those that follow. */
function probed(machine: Machine, text: string): void {
  machine.known.markProbed();
  for (const [name] of text.matchAll(ANY_PARAMETER)) machine.known.markUnknown(name.toUpperCase());
  const first = /^TCH[ \t]+PROBE[ \t]*[34]\.1[ \t]+Q(\d+)/i.exec(text)?.[1];
  if (first !== undefined) {
    for (const more of [1, 2, 3]) machine.known.markUnknown(`Q${Number(first) + more}`);
  }
}
/** Name of a block: its first words, with the number of FN and TCH PROBE. */
const NAME = /^(?:FN[ \t]*\d+|TCH[ \t]+PROBE[ \t]*\d+(?:\.\d+)?|[A-Z][A-Z-]*(?:[ \t]+[A-Z][A-Z-]*(?![\w:.\\]))?)/i;
const NUMBERS = new RegExp(String.raw`(?<![A-Z])([A-Z]+)[ \t]*(${VALUE})`, "gi");

/** Name of a block that is not simulated. */
export const nameOf = (text: string): string =>
  (NAME.exec(text)?.[0] ?? text)
    .replace(/[ \t]+/g, " ")
    .trim()
    .slice(0, 40);

/** True when a word of the text differs from its neutral value or has no readable value. */
function changes(machine: Machine, text: string, neutral: number, index: number, only: RegExp = /^/): boolean {
  return [...text.matchAll(NUMBERS)].some(([, word = "", digits = ""]) => {
    const value = only.test(word) ? readValue(digits) : neutral;
    return value === null || machine.number(value, index) !== neutral;
  });
}

/** A block kept as text: unverified from here on, unless it is known to change nothing. */
export function textBlock(machine: Machine, text: string, index: number): void {
  if (text === "") return;
  if (SQL.test(text)) return readTable(machine, text);
  const assigned = UNREAD_ASSIGNMENT.exec(text)?.[1];
  if (assigned !== undefined) return machine.known.markUnknown(assigned.toUpperCase());
  if (HARMLESS.test(text)) return dwellFunction(machine, text, index);
  const reset = UNCORRECTING.exec(text);
  if (reset) return uncorrectTool(machine, reset[1]?.toUpperCase() as "TCS" | "WPL" | undefined);
  const read = READING.exec(text)?.[1];
  if (read !== undefined) return machine.known.markUnknown(read.toUpperCase());
  if (/^PLANE[ \t]/i.test(text) && !changes(machine, text, 0, index, /^(?!(?:MB|F|DIST)$)/i)) return;
  if (ELSEWHERE.test(text)) machine.losePosition();
  if (PROBE.test(text)) probed(machine, text);
  machine.log.leaveUnproved(nameOf(text), index);
}

const WORKING_PLANE = 19;
const PRESET = 247;
/**
 * Cycles without a finding: dwell, oriented spindle stop and tolerance leave path and stock unchanged; a preset is
 * simulated.
 */
const SILENT: ReadonlySet<number> = new Set([9, 13, 32, PRESET]);
export const isSilent = (cycle: number): boolean => SILENT.has(cycle);

/** One line of an older cycle that acts at once: a dwell takes time, a tilted plane is not simulated. */
export function actingLine(
  machine: Machine,
  { cycle, line, text }: { readonly cycle: number; readonly line: number; readonly text: string },
  index: number,
): void {
  if (line > 0 && cycle === DWELL_CYCLE) dwellLine(machine, text, index);
  if (line > 0 && cycle === WORKING_PLANE && changes(machine, text, 0, index))
    machine.log.leaveUnproved(`CYCL DEF ${cycle}`, index);
}

/** A preset resets shift, mirror, rotation and scale; a new preset number moves the workpiece against earlier cuts. */
function usePreset(machine: Machine, n: number | null, what: string, index: number): void {
  machine.set({ datum: NO_SHIFT, unknownDatum: [], transform: NO_TRANSFORM });
  if (n === null || (machine.now.preset !== null && machine.now.preset !== n)) machine.log.leaveUnproved(what, index);
  machine.set({ preset: n });
}

/** A cycle with Q parameters that acts at its definition: unverified from here on when it changes coordinates. */
export function actingCycle(
  machine: Machine,
  cycle: number,
  parameters: readonly CycleParameter[],
  index: number,
): void {
  const number = (q: string) => {
    const value = parameters.find((p) => p.q === q)?.value;
    return value === undefined || value === null || typeof value === "string"
      ? undefined
      : machine.number(value, index);
  };
  const what = `CYCL DEF ${cycle}`;
  if (cycle === PRESET) return usePreset(machine, number("Q339") ?? null, what, index);
  const neutral = Object.entries(cycleByNumber(cycle)?.acts?.neutral ?? {});
  const moves = neutral.some(([q, values]) => {
    const n = number(q);
    return n !== undefined && (n === null || !values.includes(n));
  });
  if (moves || UNREAD.has(cycle)) machine.log.leaveUnproved(what, index);
}

/** Written as cycles with Q parameters, which no control has: their effect is unknown. */
const UNREAD: ReadonlySet<number> = new Set([7, 8, 10, 11, 12, 19, 26, 220, 221]);
/**
 * Cycles that act at their definition and leave the defined machining cycle unchanged: datum, mirror, dwell and the
 * like.
 */
const ACTIVE_AT_ONCE: ReadonlySet<number> = new Set([7, 8, 9, 10, 11, 12, 13, 14, 19, 20, 26, 32, 220, 221, 239, 247]);
export const actsAtOnce = (cycle: number): boolean =>
  ACTIVE_AT_ONCE.has(cycle) || cycleByNumber(cycle)?.acts !== undefined;
