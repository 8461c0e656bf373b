import type { Words } from "../nc/statement.ts";
import { programIssue } from "./issue.ts";
import type { Machine } from "./machine.ts";

/** M functions that start a spindle: those of every control, with coolant or without, and those of the turning spindle. */
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

/** What the M functions of a block start as it begins. */
export function startedBy(machine: Machine, { functions }: Words): void {
  const last = functions.findLast(mayStart);
  if (last !== undefined) machine.set({ turns: true, backwards: BACKWARDS.includes(last) });
}

/** What they stop at its end. */
export function stoppedBy(machine: Machine, { functions }: Words): void {
  if (functions.some((m) => STOPS_SPINDLE.includes(m))) machine.set({ turns: false, runsAs: null });
}

/** A call with a speed and no start. Silent where blocks that nobody here knows came before: any of them may have started the spindle. */
export function mustTurn(machine: Machine, index: number): void {
  if (machine.now.turns || machine.now.mode !== "TURN" || machine.log.unproved.length > 0) return;
  machine.log.sayOnce(programIssue("spindleStopped", "warning", {}), index);
}
