import { never } from "../../kernel/never.ts";
import type { Block, Program } from "../../nc/program.ts";
import type { Statement } from "../../nc/statement.ts";
import { firstLook, runInput, type RunInput } from "../state/run-input.ts";
import type { RunState } from "../state/run-state.ts";
import type { Run } from "../state/run-types.ts";
import type { Shop } from "../state/shop.ts";
import { firstState, ended, step } from "./run.ts";

/** Programs that can be called. */
type Beside = readonly { readonly name: string; readonly text: string }[];

/** A run with the states that were noted on its way. */
interface Former {
  readonly input: RunInput;
  readonly beside: Beside;
  readonly passed: readonly RunState[];
}

/** States are noted before these, whose values are typed most; of a long program about so many. */
const NOTED: ReadonlySet<Statement["kind"]> = new Set(["cycle", "toolCall"]);
const MOST_NOTED = 48;

/**
 * What counts for all of a program, wherever it stands: its unit, its labels, which of them are outlines, how it
 * begins.
 */
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

/** Whether one block in the place of another leaves labels, numbers, lines and the kind of the program as they are. */
function isLike(a: Block, b: Block | undefined): boolean {
  if (!b || a.lines !== b.lines || a.number !== b.number || a.skip !== b.skip) return false;
  const [s, t] = [a.statement, b.statement];
  return s.kind === t.kind && !OF_ALL.has(s.kind) && (s.kind !== "cycle" || t.kind !== "cycle" || s.cycle === t.cycle);
}

/** Blocks that are others than before; null where one of them changes what counts for the whole program. */
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

const areSame = (a: Beside, b: Beside): boolean =>
  a === b || (a.length === b.length && a.every(({ name, text }, i) => name === b[i]?.name && text === b[i].text));

/** Whether two runs can use the same, apart from programs that they call. */
const isSameShop = (a: Shop, b: Shop): boolean =>
  a.rapid === b.rapid &&
  isSame(a.machine, b.machine) &&
  a.control === b.control &&
  a.skipMarked === b.skipMarked &&
  a.memory === b.memory &&
  isSame(a.tools, b.tools) &&
  isSame(a.mills, b.mills) &&
  isSame([...(a.refused ?? [])], [...(b.refused ?? [])]);

/** What the former run passed before it looked at anything that is another now, and the first block that is. */
function common(
  { input, passed, beside }: Former,
  program: Program,
  shop: Shop,
  calls: Beside,
): { readonly passed: readonly RunState[]; readonly first: number | null } | null {
  if (!isSameShop(input.shop, shop) || !areSame(beside, calls)) return null;
  const changed = changedBlocks(input.program, program);
  if (!changed) return null;
  const looked = Math.min(...changed.map((index) => firstLook(input, index)));
  return { passed: passed.filter(({ executed }) => executed < looked), first: changed[0] ?? null };
}

/** Runs a program whose run before is known. `beside`: all that `shop.files` finds, as text. */
interface Runner {
  (program: Program, shop: Shop, beside: Beside): Run;
  /** The same, or null when `goesOn` has said no on the way: the next run of the same program goes on from there. */
  readonly part: (program: Program, shop: Shop, beside: Beside, goesOn: () => boolean) => Run | null;
}

/** A state of another program with the same blocks up to where it stands. */
const over = ({ program: { blocks }, unit }: RunInput, state: RunState): RunState => ({ ...state, blocks, unit });

/**
 * Runs one state of a program after the other: what it comes to before it looks at a block that is another one than in
 * the run before is not run again. What comes is the same as of `run`.
 */
export function runningAgain(): Runner {
  let former: Former | null = null;
  const part: Runner["part"] = (program, shop, beside, goesOn) => {
    const same = former && common(former, program, shop, beside);
    const passed = [...(same?.passed ?? [])],
      last = passed.at(-1);
    const input = runInput(
      program,
      shop,
      former && last ? { input: former.input, executed: last.executed } : undefined,
    );
    former = { input, beside, passed };
    let state = last ? over(input, last) : firstState(input);
    /** Whether a state is worth noting: some way behind the one before, or where the first block is that is another. */
    const isDue = (next: number, executed: number) => {
      if (next === same?.first) return firstLook(input, next) === Infinity;
      const kind = program.blocks[next]?.statement.kind;
      const far = executed - (passed.at(-1)?.executed ?? 0);
      return kind !== undefined && NOTED.has(kind) && far >= Math.max(program.blocks.length, executed) / MOST_NOTED;
    };
    while (!state.flow.ending) {
      state = step(input, state, isDue);
      // A program that was called is another object in each run.
      if (state.flow.ending || state.log.texts.length > 0) continue;
      passed.push(state);
      if (!goesOn()) return null;
    }
    return ended(input, state);
  };
  const whole = (program: Program, shop: Shop, beside: Beside) =>
    part(program, shop, beside, () => true) ?? never("a run without an end", program);
  return Object.assign(whole, { part });
}
