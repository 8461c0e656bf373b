import { withBlock } from "../../nc/edit.ts";
import { parse } from "../../nc/parse.ts";
import { statementLines } from "../../nc/print.ts";
import type { Block, Program } from "../../nc/program.ts";
import { styleAt } from "../../nc/read-style.ts";
import { withBlocks, withSkip } from "../../nc/replace.ts";
import type { Statement } from "../../nc/statement.ts";
import { noWords } from "../../nc/words.ts";
import { wordsOf } from "../blocks/flow.ts";
import { modalSettingsAfter, NO_MODAL_SETTINGS, type ModalSettings } from "./modal-settings.ts";
import {
  definesCycle,
  isNote,
  isOfFreeContour,
  KEPT_ON,
  namesContour,
  operationsOf,
  setsFeedUnit,
  wholeOf,
  type Operations,
  type ToolSection,
  type FixedReason,
} from "./operations.ts";
import { parametersOf, sharedParameter } from "./shared-parameters.ts";

/** Why an operation cannot move there: its fixed reason, or a parameter set and used by different operations. */
export interface Refusal {
  readonly refused: FixedReason | "parameter";
  /** Number, from 0, of the operation that is in the way. */
  readonly unit: number;
  readonly parameter?: string;
}

export const isRefused = (made: Program | Refusal): made is Refusal => "refused" in made;

const sameBlocks = (a: readonly Block[], b: readonly Block[]): boolean =>
  a.length === b.length &&
  a.every((block, i) => {
    const other = b[i];
    return other !== undefined && bare(block) === bare(other);
  });
const bare = ({ raw }: Block): string => raw.replace(/^([ \t]*(?:\/[ \t]*)?[Nn]?)\d+(?![\d.,])/, "$1");

/** Blocks of statements, in the style of a program; numbered where its blocks are. */
export function blocksOfStatements(
  program: Program,
  index: number,
  statements: readonly Statement[],
): readonly Block[] {
  const style = styleAt(program, Math.max(0, Math.min(index, program.blocks.length - 1)));
  const letter = program.blocks.some(({ raw }) => /^[ \t]*(?:\/[ \t]*)?N\d/i.test(raw)) ? "N" : "";
  const head = program.blocks.some(({ number }) => number !== null) ? `${letter}0 ` : "";
  return statements.flatMap(
    (s) =>
      parse((s.kind === "empty" ? "" : head) + statementLines(s, style).join(style.newLine) + style.newLine).blocks,
  );
}

/** Consecutive operations with one tool, with their common opening and closing blocks. */
interface Group {
  readonly section: ToolSection;
  readonly units: readonly number[];
  /** Another opening than that of its section. */
  readonly opening?: readonly Block[];
}

const cut = ({ blocks }: Program, { from, to }: { readonly from: number; readonly to: number }): readonly Block[] =>
  blocks.slice(from, to);

/** Statements that a group needs because a previous modal setting has changed. */
function missingSetting(blocks: readonly Block[], was: ModalSettings, now: ModalSettings): readonly Statement[] {
  const has = (is: (s: Statement) => boolean) => blocks.some(({ statement: s }) => is(s));
  const spin =
    was.spin && JSON.stringify(was.spin) !== JSON.stringify(now.spin) && !has((s) => s.kind === "spin")
      ? [was.spin]
      : [];
  const unit =
    was.feedUnit !== null &&
    was.feedUnit !== now.feedUnit &&
    !has((s) => setsFeedUnit(s) || (wordsOf(s)?.functions.some((m) => m === 136 || m === 137) ?? false))
      ? [functionsOf([was.feedUnit])]
      : [];
  return [...spin, ...unit];
}

const functionsOf = (functions: readonly number[]): Statement => ({
  kind: "functions",
  words: { ...noWords, functions },
});

/** Statements that an operation needs before its own blocks: its contour, and functions that were on. */
function missingBefore(blocks: readonly Block[], was: ModalSettings, now: ModalSettings): readonly Statement[] {
  const firstCycle = blocks.findIndex(({ statement: s }) => definesCycle(s));
  const free = blocks.some(({ statement: s }) => isOfFreeContour(s));
  const own = blocks.slice(0, Math.max(firstCycle, 0)).some(({ statement: s }) => namesContour(s));
  const contour = free && !own && JSON.stringify(was.contour) !== JSON.stringify(now.contour) ? was.contour : [];
  const lost = was.functions.flatMap((m, i) => {
    const group = KEPT_ON[i];
    const setsIt = blocks.some(
      ({ statement: s }) => wordsOf(s)?.functions.some((each) => group?.on.includes(each)) ?? false,
    );
    return m !== null && now.functions[i] !== m && !setsIt ? [m] : [];
  });
  const functions = [...new Set(lost)];
  return [...contour, ...(functions.length > 0 ? [functionsOf(functions)] : [])];
}

/** Removes functions that were added only for an earlier position of the operation. */
function withoutNeedless(blocks: readonly Block[], now: ModalSettings): readonly Block[] {
  const [first] = blocks;
  const s = first?.statement;
  if (s?.kind !== "functions" || s.words.functions.length === 0) return blocks;
  const inForce = s.words.functions.every((m) => now.functions.includes(m));
  return inForce && JSON.stringify(s) === JSON.stringify(functionsOf(s.words.functions)) ? blocks.slice(1) : blocks;
}

/** Something new between operations. */
interface Added {
  readonly added: readonly Block[];
}

/** Reassembles a program from reordered operations, some merged or split. */
function composed(
  program: Program,
  all: Operations,
  groups: readonly (Group | Added)[],
  joins: ReadonlySet<number>,
): Program {
  const before = states(program, all);
  const made: Block[] = [];
  let now = modalSettingsAfter(program.blocks.slice(0, all.from), NO_MODAL_SETTINGS);
  const put = (blocks: readonly Block[]) => {
    for (const block of blocks) made.push(block);
    now = modalSettingsAfter(blocks, now);
  };
  for (const group of groups) {
    if ("added" in group) {
      put(group.added);
      continue;
    }
    const { section, units, opening } = group;
    const own = opening ?? cut(program, section.opening);
    const parts = units.flatMap((unit) => cut(program, all.units[unit] ?? section.closing));
    const setting = missingSetting([...own, ...parts], before.sections.get(section) ?? NO_MODAL_SETTINGS, now);
    const tool = own.findIndex(({ statement: s }) => s.kind === "toolCall") + 1;
    put(own.slice(0, tool));
    put(blocksOfStatements(program, section.from, setting));
    put(own.slice(tool));
    for (const unit of units) {
      const blocks = cut(program, all.units[unit] ?? section.closing);
      const bared = joins.has(unit) ? withoutNeedless(blocks, now) : blocks;
      const missing = blocksOfStatements(
        program,
        section.from,
        missingBefore(bared, before.units.get(unit) ?? NO_MODAL_SETTINGS, now),
      );
      const words = bared.findIndex(({ statement: s }) => !isNote(s));
      put(missing.length > 0 ? [...bared.slice(0, words), ...missing, ...bared.slice(words)] : bared);
    }
    put(cut(program, section.closing));
  }
  return withBlocks(program, [...program.blocks.slice(0, all.from), ...made, ...program.blocks.slice(all.to)]);
}

/** Current modal settings at the start of each section and operation. */
function states({ blocks }: Program, all: Operations) {
  const sections = new Map<ToolSection, ModalSettings>();
  const units = new Map<number, ModalSettings>();
  let [now, at] = [NO_MODAL_SETTINGS, 0];
  const goTo = (to: number) => {
    now = modalSettingsAfter(blocks.slice(at, to), now);
    at = to;
    return now;
  };
  for (const section of all.sections) {
    sections.set(section, goTo(section.from));
    for (const unit of section.units) units.set(unit, goTo(all.units[unit]?.from ?? at));
  }
  return { sections, units };
}

/** Groups operations with one tool: neighbours of one section, or of two sections that have become equal. */
function grouped(
  program: Program,
  all: Operations,
  order: readonly number[],
): { readonly groups: readonly Group[]; readonly joins: ReadonlySet<number> } {
  const groups: { section: ToolSection; units: number[] }[] = [];
  const joins = new Set<number>();
  for (const unit of order) {
    const section = all.sections[all.units[unit]?.section ?? -1];
    if (!section) continue;
    const last = groups.at(-1);
    const neighbour = last?.units.at(-1);
    const isNew = neighbour !== undefined && neighbour + 1 !== unit;
    const same =
      last !== undefined &&
      (last.section === section ||
        (isNew &&
          section.opening.to > section.opening.from &&
          sameBlocks(cut(program, last.section.opening), cut(program, section.opening)) &&
          sameBlocks(cut(program, last.section.closing), cut(program, section.closing))));
    if (last && same) {
      last.units.push(unit);
      if (isNew) joins.add(unit);
    } else groups.push({ section, units: [unit] });
  }
  return { groups, joins };
}

/** Why an operation cannot be changed as a whole; null where it can. */
export function fixedRefusal({ units }: Operations, unit: number): Refusal | null {
  const tie = units[unit]?.fixedReason ?? null;
  return tie && { refused: tie, unit };
}

/** Moves an operation to another place. */
export function movedOperation(program: Program, unit: number, to: number): Program | Refusal {
  const all = operationsOf(program);
  const order = all.units.map((_, i) => i);
  if (unit === to || !all.units[unit] || !all.units[to]) return program;
  const own = cut(program, wholeOf(all, unit));
  for (let i = unit; i !== to; i += Math.sign(to - unit)) {
    const crossed = i + Math.sign(to - unit);
    const tie = fixedRefusal(all, i === unit ? unit : i) ?? fixedRefusal(all, crossed);
    if (tie) return tie;
    const parameter = sharedParameter(own, cut(program, wholeOf(all, crossed)));
    if (parameter !== null) return { refused: "parameter", unit: crossed, parameter };
  }
  order.splice(unit, 1);
  order.splice(to, 0, unit);
  const { groups, joins } = grouped(program, all, order);
  return composed(program, all, groups, joins);
}

/** Inserts blocks behind an operation, or before all; operations behind them with the same tool call it again. */
export function withAddedBehind(program: Program, unit: number | null, added: readonly Block[]): Program {
  const all = operationsOf(program);
  const behind = unit === null ? -1 : unit;
  const groups = all.sections.flatMap((section): readonly (Group | Added)[] => {
    const [before, rest] = [section.units.filter((i) => i <= behind), section.units.filter((i) => i > behind)];
    const part = (units: readonly number[]): readonly Group[] => (units.length > 0 ? [{ section, units }] : []);
    return before.length > 0 && rest[0] !== undefined
      ? [...part(before), { added }, ...part(rest)]
      : part(section.units);
  });
  const parted = groups.some((group) => "added" in group);
  const first = groups.findIndex((group) => "units" in group && (group.units[0] ?? 0) > behind);
  const at = first < 0 ? groups.length : first;
  return composed(program, all, parted ? groups : groups.toSpliced(at, 0, { added }), new Set());
}

/** Duplicates an operation behind itself, with the same tool. */
export function duplicatedOperation(program: Program, unit: number): Program | Refusal {
  const all = operationsOf(program);
  const tie = fixedRefusal(all, unit);
  const own = all.units[unit];
  if (tie || !own) return tie ?? program;
  const { blocks } = program;
  return withBlocks(program, [...blocks.slice(0, own.to), ...blocks.slice(own.from, own.to), ...blocks.slice(own.to)]);
}

/** Removes an operation; its tool call and retraction stay where another one needs them. */
export function withoutOperation(program: Program, unit: number): Program | Refusal {
  const all = operationsOf(program);
  const tie = fixedRefusal(all, unit);
  if (tie || !all.units[unit]) return tie ?? program;
  const order = all.units.map((_, i) => i).filter((i) => i !== unit);
  const groups = order.reduce<{ section: ToolSection; units: number[] }[]>((made, i) => {
    const section = all.sections[all.units[i]?.section ?? -1];
    const last = made.at(-1);
    if (section && last?.section === section) last.units.push(i);
    else if (section) made.push({ section, units: [i] });
    return made;
  }, []);
  return composed(program, all, groups, new Set());
}

/** Sets or removes the skip marks of an operation: settings that others need stay active. */
export function switchedOperation(program: Program, unit: number, on: boolean): Program | Refusal {
  const all = operationsOf(program);
  const tie = fixedRefusal(all, unit);
  const own = all.units[unit];
  if (tie || !own) return tie ?? program;
  const whole = wholeOf(all, unit);
  const isAlone = all.sections[own.section]?.units.length === 1;
  const { from, to } = isAlone ? whole : own;
  const later = program.blocks.slice(to, all.to);
  const needed = parametersOf(later).read;
  const stays = ({ statement: s }: Block) =>
    isNote(s) ||
    ((s.kind === "assign" || s.kind === "assignText") && needed.has(s.target.toUpperCase())) ||
    (!isAlone && wordsOf(s)?.functions.some((m) => KEPT_ON.some((kept) => kept.on.includes(m)))) ||
    (s.kind === "spin" && !later.some((b) => b.statement.kind === "spin")) ||
    setsFeedUnit(s) ||
    s.kind === "mode";
  const next = program.blocks.map((block, i) =>
    i < from || i >= to || (!on && stays(block)) ? block : withSkip(block, !on),
  );
  return withSkips(program, next);
}

const withSkips = (program: Program, blocks: readonly Block[]): Program =>
  blocks.every((block, i) => block === program.blocks[i]) ? program : { blocks };

/** Changes the tool of an operation; others that shared the tool keep theirs. */
export function retooledOperation(program: Program, unit: number, tool: number): Program | Refusal {
  const all = operationsOf(program);
  const own = all.units[unit];
  const section = own && all.sections[own.section];
  if (!own || own.toolCall === null || !section || own.fixedReason === "label")
    return { refused: own?.fixedReason ?? "tool", unit };
  const called = program.blocks[own.toolCall]?.statement;
  if (called?.kind !== "toolCall") return program;
  // Deltas belong to the measured tool.
  const statement: Statement = { ...called, tool, deltaLength: null, deltaRadius: null };
  const changed = withBlock(program, own.toolCall, statement);
  if (changed === program || section.units.length === 1) return changed;
  const other = cut(changed, section.opening);
  const groups = all.sections.flatMap((each): readonly Group[] => {
    if (each !== section) return [{ section: each, units: each.units }];
    const at = each.units.indexOf(unit);
    const [first, last] = [each.units.slice(0, at), each.units.slice(at + 1)];
    const part = (units: readonly number[]): readonly Group[] => (units.length > 0 ? [{ section: each, units }] : []);
    return [...part(first), { section: each, units: [unit], opening: other }, ...part(last)];
  });
  return composed(program, all, groups, new Set());
}
