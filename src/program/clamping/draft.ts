import { CHUCK_SIZES, type ClampingKind } from "../../kernel/area/clamping.ts";
import { radius, toDiameter } from "../../kernel/units.ts";
import { withBlock, withInserted, withoutBlocks } from "../../nc/edit.ts";
import type { Program } from "../../nc/program.ts";
import type { Statement } from "../../nc/statement.ts";
import { anyNumber, type Field } from "../values/field.ts";
import { readClamping } from "./read-clamping.ts";
import {
  ANY_NUMBER,
  CLAMPING_WORDS,
  clampingText,
  LEAST_ANGLE,
  MOST_ANGLE,
  neededWords,
  type ClampingDraft,
  type ClampingWord,
} from "./words.ts";

const rangeOf = (word: ClampingWord): Field["range"] =>
  word === "ANGLE" ? [LEAST_ANGLE, MOST_ANGLE] : [ANY_NUMBER.has(word) ? -Infinity : Number.MIN_VALUE, Infinity];

/** The field of a word; `needed`: it may not stay empty. */
export const clampingField = (word: ClampingWord, needed: boolean): Field => ({
  ...anyNumber,
  id: `clamping.${word}`,
  range: rangeOf(word),
  optional: !needed,
});

/** Whether a word of a kind is required. */
export const isNeeded = (kind: ClampingKind, word: ClampingWord): boolean => neededWords(kind).includes(word);

/** Largest proposed share of a blank in the jaws, and its largest length, mm. */
const [GRIPPED, MOST_GRIPPED] = [0.25, 25];
/** Factor from the blank to the proposed chuck diameter. */
const LARGER = 1.3;

/** Default clamping: a blank gripped outside, at its rear end. `k`: mm in the unit of the program. */
export function proposedClamping(
  { left, right, high }: { readonly left: number; readonly right: number; readonly high: number },
  k = 1,
): ClampingDraft {
  const long = Math.min(MOST_GRIPPED, Math.floor((right - left) * GRIPPED) || (right - left) * GRIPPED);
  const across = toDiameter(radius(high)),
    least = across * LARGER;
  const size = CHUCK_SIZES.find((each) => each > least) ?? Math.ceil(least / 100) * 100;
  const text = (mm: number) => String(Number((mm / k).toFixed(4)));
  return {
    kind: "chuckOutside",
    words: { D: text(across), LENGTH: text(long), FACE: text(left + long), SIZE: text(size) },
  };
}

/** A clamping comment as typed text; null for other comments. */
function draftOf(comment: string): ClampingDraft | null {
  const read = readClamping(comment);
  if (!read) return null;
  const words = CLAMPING_WORDS.flatMap((word) =>
    read.values[word] === undefined ? [] : [[word, String(read.values[word])] as const],
  );
  return { kind: read.kind ?? "chuckOutside", words: Object.fromEntries(words) };
}

const commentOf = ({ statement: s, comment }: Program["blocks"][number]) =>
  (s.kind === "comment" ? s.text : comment) ?? "";

/** Clamping of a program, with its block; null without one. */
export function clampingIn({ blocks }: Program): { readonly index: number; readonly draft: ClampingDraft } | null {
  for (const [index, block] of blocks.entries()) {
    const draft = draftOf(commentOf(block));
    if (draft) return { index, draft };
  }
  return null;
}

const isBlank = ({ kind }: Statement) => kind.startsWith("blank");

/**
 * Sets or removes the clamping of a program: a comment of its own behind the blank, or in place of the existing one.
 */
export function withClamping(program: Program, draft: ClampingDraft | null): Program {
  const had = clampingIn(program);
  const statement: Statement | null = draft && { kind: "comment", text: ` ${clampingText(draft)}` };
  const own = had && program.blocks[had.index]?.statement.kind === "comment";
  if (had && own) return statement ? withBlock(program, had.index, statement) : withoutBlocks(program, had.index);
  if (!statement) return program;
  const behind = program.blocks.findLastIndex(({ statement: s }) => isBlank(s));
  const begin = program.blocks.findIndex(({ statement: s }) => s.kind === "begin");
  return withInserted(program, Math.max(behind, begin) + 1, statement);
}
