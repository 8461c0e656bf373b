import { never } from "../../kernel/never.ts";
import type { Block, Program } from "../../nc/program.ts";
import type { Statement } from "../../nc/statement.ts";
import { firstReadAt, runInput, type RunInput } from "../state/run-input.ts";
import type { RunState } from "../state/run-state.ts";
import type { Run } from "../state/run-types.ts";
import type { Shop } from "../state/shop.ts";
import { firstState, finishedRun, step } from "./run.ts";

/** Programs that the run can call. */
type CallableFiles = readonly { readonly name: string; readonly text: string }[];

/** A previous run with its snapshots. */
interface PreviousRun {
  readonly input: RunInput;
  readonly beside: CallableFiles;
  readonly snapshots: readonly RunState[];
}

/** Snapshots are taken before these blocks, whose values are typed most; about this many in a long program. */
const NOTED: ReadonlySet<Statement["kind"]> = new Set(["cycle", "toolCall"]);
const MOST_NOTED = 48;

/** Blocks with an effect on the whole program: unit, labels, outlines, beginning. */
const OF_ALL: ReadonlySet<Statement["kind"]> = new Set([
  "begin",
  "end",
  "label",
  "mode",
  "spin",
  "cycleLine",
  "contourDefinition",
  "blankRotation",
  "turnBlank",
]);

/** Whether replacing one block by another keeps labels, numbers, lines and the kind of program. */
function isLike(a: Block, b: Block | undefined): boolean {
  if (!b || a.lines !== b.lines || a.number !== b.number || a.skip !== b.skip) return false;
  const [s, t] = [a.statement, b.statement];
  return s.kind === t.kind && !OF_ALL.has(s.kind) && (s.kind !== "cycle" || t.kind !== "cycle" || s.cycle === t.cycle);
}

/** Indices of changed blocks; null where one of them affects the whole program. */
function changedBlocks(before: Program, now: Program): readonly number[] | null {
  if (before.blocks.length !== now.blocks.length) return null;
  const changed: number[] = [];
  for (const [i, block] of before.blocks.entries()) {
    const other = now.blocks[i];
    if (block === other || block.raw === other?.raw) continue;
    if (!isLike(block, other)) return null;
    changed.push(i);
  }
  return changed;
}

const isSame = (a: unknown, b: unknown): boolean => a === b || JSON.stringify(a) === JSON.stringify(b);

const areSame = (a: CallableFiles, b: CallableFiles): boolean =>
  a === b || (a.length === b.length && a.every(({ name, text }, i) => name === b[i]?.name && text === b[i].text));

/** Whether two runs have the same environment, apart from called programs. */
const isSameShop = (a: Shop, b: Shop): boolean =>
  a.rapid === b.rapid &&
  isSame(a.machine, b.machine) &&
  a.control === b.control &&
  a.skipMarked === b.skipMarked &&
  a.memory === b.memory &&
  isSame(a.tools, b.tools) &&
  isSame(a.mills, b.mills) &&
  isSame([...(a.refused ?? [])], [...(b.refused ?? [])]);

/** Snapshots of the previous run before its first read of a changed block, and that block. */
function reusablePart(
  { input, snapshots, beside }: PreviousRun,
  program: Program,
  shop: Shop,
  calls: CallableFiles,
): { readonly passed: readonly RunState[]; readonly first: number | null } | null {
  if (!isSameShop(input.shop, shop) || !areSame(beside, calls)) return null;
  const changed = changedBlocks(input.program, program);
  if (!changed) return null;
  const looked = Math.min(...changed.map((index) => firstReadAt(input, index)));
  return { passed: snapshots.filter(({ executed }) => executed < looked), first: changed[0] ?? null };
}

/** Runs a program, reusing the previous run. `beside`: all that `shop.files` finds, as text. */
interface Runner {
  (program: Program, shop: Shop, beside: CallableFiles): Run;
  /** The same, or null when `continuesStep` returned false: the next run of the same program continues from there. */
  readonly interruptible: (program: Program, shop: Shop, beside: CallableFiles, goesOn: () => boolean) => Run | null;
}

/** Moves a state to another program with the same blocks up to that state. */
const rebased = ({ program: { blocks }, unit }: RunInput, state: RunState): RunState => ({ ...state, blocks, unit });

/**
 * Runs versions of a program one after the other without repeating what precedes the first read of a changed block. The
 * result equals that of `run`.
 */
export function incrementalRunner(): Runner {
  let former: PreviousRun | null = null;
  const interruptible: Runner["interruptible"] = (program, shop, beside, goesOn) => {
    const same = former && reusablePart(former, program, shop, beside);
    const snapshots = [...(same?.passed ?? [])],
      last = snapshots.at(-1);
    const input = runInput(
      program,
      shop,
      former && last ? { input: former.input, executed: last.executed } : undefined,
    );
    former = { input, beside, snapshots };
    let state = last ? rebased(input, last) : firstState(input);
    /** Whether to take a snapshot: some distance after the previous one, or before the first changed block. */
    const isDue = (next: number, executed: number) => {
      if (next === same?.first) return firstReadAt(input, next) === Infinity;
      const kind = program.blocks[next]?.statement.kind;
      const far = executed - (snapshots.at(-1)?.executed ?? 0);
      return kind !== undefined && NOTED.has(kind) && far >= Math.max(program.blocks.length, executed) / MOST_NOTED;
    };
    while (!state.flow.ending) {
      state = step(input, state, isDue);
      // A called program is a new object in each run.
      if (state.flow.ending || state.log.texts.length > 0) continue;
      snapshots.push(state);
      if (!goesOn()) return null;
    }
    return finishedRun(input, state);
  };
  const whole = (program: Program, shop: Shop, beside: CallableFiles) =>
    interruptible(program, shop, beside, () => true) ?? never("a run without an end", program);
  return Object.assign(whole, { interruptible });
}
