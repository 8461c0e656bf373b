import { cycleByNumber } from "../../cycles/index.ts";
import type { CycleParameter } from "../../nc/words.ts";
import { NUMBER_PARAMETER, PARAMETER, readValue, VALUE } from "../../nc/value.ts";
import { NO_TRANSFORM } from "../tools/coordinates-frame.ts";
import { dwellFunction, dwellLine, DWELL_CYCLE } from "./dwell.ts";
import type { Machine } from "../state/machine.ts";
import { NO_SHIFT } from "../state/modal.ts";
import { uncorrectTool } from "./tool-call.ts";

/**
 * Blocks that nobody here reads and that leave path and stock as they are: messages, tables, strings, feeds that only
 * breathe, functions that count or log.
 */
const HARMLESS = new RegExp(
  String.raw`^(?:FN[ \t]*(?:1[4569]|2[0679]|3[789])[ \t]*:|FUNCTION[ \t]+(?:TCPM|RESET|FEED|S-PULSE|COUNT|DWELL|DCM|FILE|AFC|LIFTOFF|` +
    String.raw`SECTION[ \t]+MONITORING)|AFC|LIFTOFF|SECTION[ \t]+MONITORING|` +
    String.raw`DECLARE|OPEN|CLOSE|SEL[ \t]+(?:TABLE|CORR-TABLE)|PATTERN[ \t]+DEF|` +
    String.raw`POLARKIN[ \t]+OFF|MONITORING|STOP|PLANE[ \t]+RESET)`,
  "i",
);
/** Takes the corrections of the tool back, in one system or in both, and moves no axis. */
const UNCORRECTING = /^(?:FUNCTION[ \t]+)?(?:TURNDATA[ \t]+CORR[ \t]+OFF|CORRDATA[ \t]+RESET)\b(?:.*?(TCS|WPL))?/i;
/** FN 18 and FN 28 only read a value into a parameter. */
const READING = new RegExp(String.raw`^FN[ \t]*(?:18|28)[ \t]*:[^=]*?(${NUMBER_PARAMETER})`, "i");
/** Programs that run on their own leave the tool wherever they end, and so do probes. */
const ELSEWHERE = /^(?:CALL[ \t]+(?:PGM|SELECTED)|TCH[ \t]+PROBE|CALL[ \t]+LBL)/i;
const PROBE = /^TCH[ \t]+PROBE/i;
/** A formula that reads what only the machine or its tables know. */
const UNREAD_ASSIGNMENT = new RegExp(
  String.raw`^(?:FN[ \t]*\d+[ \t]*:[ \t]*|DECLARE[ \t]+STRING[ \t]+)?(${PARAMETER})[ \t]*=`,
  "i",
);
const ANY_PARAMETER = new RegExp(String.raw`(${PARAMETER})(?![ \t]*=)`, "gi");
const SQL = /^SQL[ \t]+([A-Z]*)/i;

/** SQL reads into the parameters that it names; BIND ties them to columns, which every later fetch reads into. */
function readTable(machine: Machine, text: string): void {
  const word = SQL.exec(text)?.[1]?.toUpperCase();
  const named = [...text.replace(/"[^"]*"|'[^']*'/g, "").matchAll(ANY_PARAMETER)].map(([name]) => name.toUpperCase());
  if (word === "BIND") machine.known.bind(named);
  for (const name of [...named, ...machine.known.bound]) machine.known.forget(name);
}

/** A probe writes into the parameters that it names, the older measuring cycle into those behind them too. */
function probed(machine: Machine, text: string): void {
  machine.known.probe();
  for (const [name] of text.matchAll(ANY_PARAMETER)) machine.known.forget(name.toUpperCase());
  const first = /^TCH[ \t]+PROBE[ \t]*[34]\.1[ \t]+Q(\d+)/i.exec(text)?.[1];
  if (first !== undefined) {
    for (const more of [1, 2, 3]) machine.known.forget(`Q${Number(first) + more}`);
  }
}
/** What a block is called: its first words, with the number of FN and TCH PROBE. */
const NAME = /^(?:FN[ \t]*\d+|TCH[ \t]+PROBE[ \t]*\d+(?:\.\d+)?|[A-Z][A-Z-]*(?:[ \t]+[A-Z][A-Z-]*(?![\w:.\\]))?)/i;
const NUMBERS = new RegExp(String.raw`([A-Z]+)[ \t]*(${VALUE})`, "gi");

/** How a block that is kept and not run is called. */
export const nameOf = (text: string): string =>
  (NAME.exec(text)?.[0] ?? text)
    .replace(/[ \t]+/g, " ")
    .trim()
    .slice(0, 40);

/**
 * True when a word of the text has another value than the one that changes nothing; so has one without a value to read.
 */
function changes(machine: Machine, text: string, neutral: number, index: number, only: RegExp = /^/): boolean {
  return [...text.matchAll(NUMBERS)].some(([, word = "", digits = ""]) => {
    const value = only.test(word) ? readValue(digits) : neutral;
    return value === null || machine.number(value, index) !== neutral;
  });
}

/** A block that the reader keeps as text: nothing is proved behind it, unless it is known to change nothing. */
export function textBlock(machine: Machine, text: string, index: number): void {
  if (text === "") return;
  if (SQL.test(text)) return readTable(machine, text);
  const assigned = UNREAD_ASSIGNMENT.exec(text)?.[1];
  if (assigned !== undefined) return machine.known.forget(assigned.toUpperCase());
  if (HARMLESS.test(text)) return dwellFunction(machine, text, index);
  const reset = UNCORRECTING.exec(text);
  if (reset) return uncorrectTool(machine, reset[1]?.toUpperCase() as "TCS" | "WPL" | undefined);
  const read = READING.exec(text)?.[1];
  if (read !== undefined) return machine.known.forget(read.toUpperCase());
  if (/^PLANE[ \t]/i.test(text) && !changes(machine, text, 0, index, /^(?!(?:MB|F|DIST)$)/i)) return;
  if (ELSEWHERE.test(text)) machine.loseAll();
  if (PROBE.test(text)) probed(machine, text);
  machine.log.leaveUnproved(nameOf(text), index);
}

const WORKING_PLANE = 19;
const PRESET = 247;
/**
 * Cycles of which there is nothing to say: dwell, oriented spindle and tolerance leave path and stock as they are, a
 * preset is run.
 */
const SILENT: ReadonlySet<number> = new Set([9, 13, 32, PRESET]);
export const isSilent = (cycle: number): boolean => SILENT.has(cycle);

/** One line of an older cycle that acts at once: a dwell takes its time, the tilted plane is not run. */
export function actingLine(
  machine: Machine,
  { cycle, line, text }: { readonly cycle: number; readonly line: number; readonly text: string },
  index: number,
): void {
  if (line > 0 && cycle === DWELL_CYCLE) dwellLine(machine, text, index);
  if (line > 0 && cycle === WORKING_PLANE && changes(machine, text, 0, index))
    machine.log.leaveUnproved(`CYCL DEF ${cycle}`, index);
}

/**
 * A preset takes shift, mirror, rotation and scale back; another one than before moves the workpiece against what was
 * cut already.
 */
function usePreset(machine: Machine, n: number | null, what: string, index: number): void {
  machine.set({ datum: NO_SHIFT, unknownDatum: [], transform: NO_TRANSFORM });
  if (n === null || (machine.now.preset !== null && machine.now.preset !== n)) machine.log.leaveUnproved(what, index);
  machine.set({ preset: n });
}

/**
 * A cycle of Q parameters that acts where it is defined: nothing is proved behind it when it changes the coordinates.
 */
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

/** Spelt as cycles of Q parameters, which no control has: what they would do, nobody knows. */
const UNREAD: ReadonlySet<number> = new Set([7, 8, 10, 11, 12, 19, 26, 220, 221]);
/**
 * Cycles that act where they are defined and leave the defined machining cycle as it is: datum, mirror, dwell and the
 * like.
 */
const ACTIVE_AT_ONCE: ReadonlySet<number> = new Set([7, 8, 9, 10, 11, 12, 13, 14, 19, 20, 26, 32, 220, 221, 239, 247]);
export const actsAtOnce = (cycle: number): boolean =>
  ACTIVE_AT_ONCE.has(cycle) || cycleByNumber(cycle)?.acts !== undefined;
