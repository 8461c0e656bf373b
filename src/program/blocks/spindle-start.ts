import { isDrill } from "../../kernel/cutter/drill.ts";
import { issue } from "../../kernel/plan/issue.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { Words } from "../../nc/words.ts";
import type { Machine } from "../state/machine.ts";
import { idleSpindle } from "../state/spindle-state.ts";

/**
 * M functions that start a spindle: those of every control, with coolant or without, and those of the turning spindle.
 */
const START: readonly number[] = [3, 4, 13, 14, 303, 304];
/** Those of them that start it the other way round. What a machine has of its own counts as forwards. */
const BACKWARDS: readonly number[] = [4, 14, 304];
/** M functions that stop it. */
export const STOPS_SPINDLE: readonly number[] = [5, 305];
/** M functions of the control that start nothing. What is not among them is the machine's own, and may. */
const ELSE: readonly number[] = [0, 1, 2, 6, 8, 9, 30];
const FIRST_OF_PATH = 89;
const LAST_OF_PATH = 199;

const mayStart = (m: number) =>
  START.includes(m) || !(STOPS_SPINDLE.includes(m) || ELSE.includes(m) || (m >= FIRST_OF_PATH && m <= LAST_OF_PATH));

const spunAt = (machine: Machine, index: number) => ({ index, unproved: machine.log.unproved.length, told: false });

/** What the M functions of a block start as it begins. */
export function startedBy(machine: Machine, { functions }: Words, index: number): void {
  const last = functions.findLast(mayStart);
  if (last !== undefined)
    machine.set({ turns: true, backwards: BACKWARDS.includes(last), spun: spunAt(machine, index) });
}

/** What they stop at its end. A spindle that stands already was stopped by the block before. */
export function stoppedBy(machine: Machine, { functions }: Words, index: number): void {
  const { turns, spun } = machine.now;
  if (!functions.some((m) => STOPS_SPINDLE.includes(m))) return;
  machine.set({ turns: false, runsAs: null, spun: turns || spun.index === null ? spunAt(machine, index) : spun });
}

/** A cycle that is called: its operation, and whether its thread is a left-hand one, where it says so. */
interface Called {
  readonly operation?: number;
  readonly leftHand?: boolean | undefined;
}

/** A cycle is called: it is blamed itself, and what is cut behind it in the same state is not blamed again. */
export function mustTurn(machine: Machine, tool: Tool, index: number, { operation, leftHand }: Called = {}): void {
  const idle = idleSpindle(machine.now, machine.log, tool, leftHand);
  if (!idle) {
    const { ways, backwards, turns } = machine.now;
    if (turns && !isDrill(tool) && !ways.has(tool.T)) machine.set({ ways: new Map([...ways, [tool.T, backwards]]) });
    return;
  }
  machine.set({ spun: { ...machine.now.spun, told: true } });
  const { how, by } = idle;
  machine.log.say(
    issue("spindleStopped", "error", { how, ...(by !== null && { block: by }) }),
    index,
    0,
    operation ?? null,
  );
}
