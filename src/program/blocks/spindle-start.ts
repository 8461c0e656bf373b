import { isDrill } from "../../kernel/cutter/drill.ts";
import { issue } from "../../kernel/plan/issue.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { Words } from "../../nc/words.ts";
import type { Machine } from "../state/machine.ts";
import { spindleFaultOf } from "../state/spindle-state.ts";

/** M functions that start a spindle: the standard ones, with or without coolant, and those of the turning spindle. */
const START: readonly number[] = [3, 4, 13, 14, 303, 304];
/** The reversing ones among them. Machine-specific functions count as forwards. */
const BACKWARDS: readonly number[] = [4, 14, 304];
/** M functions that stop it. */
export const STOPS_SPINDLE: readonly number[] = [5, 305];
/** Standard M functions that start nothing. All others are machine-specific and may start the spindle. */
const ELSE: readonly number[] = [0, 1, 2, 6, 8, 9, 30];
const FIRST_OF_PATH = 89;
const LAST_OF_PATH = 199;

const mayStart = (m: number) =>
  START.includes(m) || !(STOPS_SPINDLE.includes(m) || ELSE.includes(m) || (m >= FIRST_OF_PATH && m <= LAST_OF_PATH));

const spunAt = (machine: Machine, index: number) => ({ index, unproved: machine.log.unproved.length, told: false });

/** Applies spindle starts at the beginning of a block. */
export function applySpindleStart(machine: Machine, { functions }: Words, index: number): void {
  const last = functions.findLast(mayStart);
  if (last !== undefined)
    machine.set({ turns: true, backwards: BACKWARDS.includes(last), spindleChange: spunAt(machine, index) });
}

/** Applies spindle stops at the end of a block. A spindle at rest was stopped by an earlier block. */
export function applySpindleStop(machine: Machine, { functions }: Words, index: number): void {
  const { turns, spindleChange } = machine.now;
  if (!functions.some((m) => STOPS_SPINDLE.includes(m))) return;
  machine.set({
    turns: false,
    lastTurns: null,
    spindleChange: turns || spindleChange.index === null ? spunAt(machine, index) : spindleChange,
  });
}

/** A cycle call: its operation, and whether its thread is left-hand where the cycle says so. */
interface Called {
  readonly operation?: number;
  readonly leftHand?: boolean | undefined;
}

/** Reports a stopped spindle at a cycle call, and suppresses the same report for later cuts in this state. */
export function requireSpindle(
  machine: Machine,
  tool: Tool,
  index: number,
  { operation, leftHand }: Called = {},
): void {
  const idle = spindleFaultOf(machine.now, machine.log, tool, leftHand);
  if (!idle) {
    const { spindleDirections, backwards, turns } = machine.now;
    if (turns && !isDrill(tool) && !spindleDirections.has(tool.T))
      machine.set({ spindleDirections: new Map([...spindleDirections, [tool.T, backwards]]) });
    return;
  }
  machine.set({ spindleChange: { ...machine.now.spindleChange, told: true } });
  const { how, by } = idle;
  machine.log.report(
    issue("spindleStopped", "error", { how, ...(by !== null && { block: by }) }),
    index,
    0,
    operation ?? null,
  );
}
