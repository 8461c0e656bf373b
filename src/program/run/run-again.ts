import { never } from "../../kernel/never.ts";
import type { Block, Program } from "../../nc/program.ts";
import type { Statement } from "../../nc/statement.ts";
import { Machine } from "../state/machine.ts";
import type { RunMoment } from "../state/run-moment.ts";
import { runToEnd } from "./run.ts";
import type { Run } from "../state/run-types.ts";
import type { Shop } from "../state/shop.ts";

/** A place that a run has passed: before a block, and what was in force there. */
interface Passed {
  readonly next: number;
  readonly moment: RunMoment;
}

/** Programs that can be called. */
type Beside = readonly { readonly name: string; readonly text: string }[];

/** A run that has come to its end, with what was noted on its way. */
interface Former {
  readonly machine: Machine;
  readonly beside: Beside;
  readonly passed: readonly Passed[];
}

/** Moments are noted before these, whose values are typed most; of a long program about so many. */
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

/**
 * Where a run is; null where a run of another program could not go on from, since something is under way that it would
 * change.
 */
function passing(machine: Machine): RunMoment | null {
  const { now, place, freePole, executed, turnGuide, millGuide } = machine;
  const isBetween = !turnGuide.chain && !millGuide.chain && !machine.freeRun && !machine.next && !machine.full;
  if (!isBetween || machine.hasTraced || machine.units.size > 1) return null;
  return {
    now,
    place,
    freePole,
    executed,
    parameters: new Map(machine.parameters),
    radii: new Map(machine.radii),
    definitions: new Set(machine.definitions),
    called: new Set(machine.called),
    known: machine.known.moment,
    log: machine.log.moment,
    here: [turnGuide.here, millGuide.here],
    asked: machine.shop.memory?.asked() ?? 0,
  };
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

/** What the former run passed before it looked at anything that is another now. */
function common(
  { machine, passed, beside }: Former,
  program: Program,
  shop: Shop,
  calls: Beside,
): { readonly passed: readonly Passed[]; readonly first: number | null } | null {
  if (!isSameShop(machine.shop, shop) || !areSame(beside, calls)) return null;
  const changed = changedBlocks(machine.program, program);
  if (!changed) return null;
  const looked = changed
    .flatMap((i) => [machine.visited[i] ?? 0, machine.foreseen[i] ?? 0])
    .filter((count) => count > 0);
  const first = Math.min(...looked);
  return { passed: passed.filter(({ moment }) => moment.executed < first), first: changed[0] ?? null };
}

/** Runs a program whose run before is known. `beside`: all that `shop.files` finds, as text. */
interface Runner {
  (program: Program, shop: Shop, beside: Beside): Run;
  /** The same, or null when `goesOn` has said no on the way: the next run of the same program goes on from there. */
  readonly part: (program: Program, shop: Shop, beside: Beside, goesOn: () => boolean) => Run | null;
}

const STOPPED = new Error("the rest of the program is run another time");

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
    const machine = new Machine(
      program,
      shop,
      former && last ? { machine: former.machine, at: last.moment } : undefined,
    );
    if (last) shop.memory?.again(last.moment.asked);
    const apart = Math.ceil(program.blocks.length / MOST_NOTED);
    const watch = (next: number) => {
      const kind = program.blocks[next]?.statement.kind;
      const isDue = kind !== undefined && NOTED.has(kind) && next >= (passed.at(-1)?.next ?? 0) + apart;
      if (!isDue && next !== same?.first) return;
      const moment = passing(machine);
      if (!moment || passed.at(-1)?.next === next) return;
      passed.push({ next, moment });
      if (!goesOn()) throw STOPPED;
    };
    let made: Run | null = null;
    try {
      made = runToEnd(machine, { from: last?.next ?? 0, watch });
    } catch (error) {
      if (error !== STOPPED) throw error;
    }
    former = { machine, beside, passed };
    return made;
  };
  const whole = (program: Program, shop: Shop, beside: Beside) =>
    part(program, shop, beside, () => true) ?? never("a run without an end", program);
  return Object.assign(whole, { part });
}
