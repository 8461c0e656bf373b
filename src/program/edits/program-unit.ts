import { cycleByNumber } from "../../cycles/index.ts";
import type { Cycle } from "../../cycles/define.ts";
import { at, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { INCH } from "../../kernel/units.ts";
import type { Program } from "../../nc/program.ts";
import type { Statement } from "../../nc/statement.ts";
import type { CycleParameter, FeedWord, Value, Words } from "../../nc/words.ts";
import { drillQuantity } from "../blocks/drill-quantity.ts";
import { valueInProgram } from "../blocks/cycle-values.ts";
import type { Draft } from "../job/read-draft.ts";
import { anyNumber, readText, roundedTo } from "../values/field.ts";

/* Operations are planned in mm. This module converts them to the unit of the program that takes them, and back. */

/** True for a program whose numbers are inches. */
export const countsInches = ({ blocks }: Program): boolean =>
  blocks.some(({ statement }) => statement.kind === "begin" && statement.unit === "INCH");

/** Decimals of a length converted from inches, mm. */
const MM_DECIMALS = 6;
const LENGTH = { kind: "length" };
const inUnit = (mm: number, inches: boolean): number => valueInProgram(LENGTH, mm, inches);

/** A typed length in mm as it is typed for a program; other text, such as a Q parameter, stays. */
export function typedForProgram(mm: string, inches: boolean): string {
  const { value } = readText(anyNumber, mm);
  return inches && value !== null ? String(inUnit(value, inches)) : mm;
}

/** A length typed for a program as it is typed in mm. */
export function typedInMillimetres(text: string, inches: boolean): string {
  const { value } = readText(anyNumber, text);
  return inches && value !== null ? String(roundedTo(value * INCH, MM_DECIMALS)) : text;
}

/** Typed values of a cycle in mm, as they are typed for a program. */
export const draftForProgram = (cycle: Cycle, draft: Draft, inches: boolean): Draft =>
  inches
    ? Object.fromEntries(
        Object.entries(draft).map(([q, text]) => {
          const { value } = readText(anyNumber, text);
          return [q, value === null ? text : String(valueInProgram(cycle.params[q], value, inches))];
        }),
      )
    : draft;

/** A contour of a program in mm. */
export function contourInMillimetres(contour: readonly Segment[], inches: boolean): readonly Segment[] {
  if (!inches) return contour;
  const point = (p: Pt) => at(p.z * INCH, p.r * INCH);
  return contour.map((s) => {
    const ends = { from: point(s.from), to: point(s.to) };
    return s.kind === "arc" ? { ...s, ...ends, centre: point(s.centre) } : { ...s, ...ends };
  });
}

interface Converted {
  readonly length: <V extends Value | "max">(value: V) => V | number;
  readonly feed: (word: FeedWord) => FeedWord;
  readonly parameter: (cycle: number) => (p: CycleParameter) => CycleParameter;
}

function toInches(perRevolution: boolean): Converted {
  const of = (kind: { readonly kind: string } | undefined, mm: number) => valueInProgram(kind, mm, true, perRevolution);
  return {
    length: (value) => (typeof value === "number" ? of(LENGTH, value) : value),
    feed: (word) =>
      typeof word === "object" && typeof word.value === "number"
        ? { ...word, value: of({ kind: "feed" }, word.value) }
        : word,
    parameter: (cycle) => (p) => {
      const quantity = cycleByNumber(cycle)?.params[p.q] ?? drillQuantity(cycle, p.q);
      return typeof p.value === "number" ? { ...p, value: of(quantity, p.value) } : p;
    },
  };
}

function wordsIn(words: Words, { length, feed }: Converted): Words {
  const axes = words.axes.map((word) => ({ ...word, value: length(word.value) }));
  return {
    ...words,
    axes,
    ...(words.radius !== undefined && { radius: length(words.radius) }),
    ...(words.length !== undefined && { length: length(words.length) }),
    ...(words.retract !== undefined && { retract: length(words.retract) }),
    ...(words.feed !== undefined && { feed: feed(words.feed) }),
  };
}

/** The blocks of an operation in mm, in the unit of a program. */
export function statementsInUnit(
  statements: readonly Statement[],
  inches: boolean,
  perRevolution: boolean,
): readonly Statement[] {
  if (!inches) return statements;
  const converted = toInches(perRevolution);
  return statements.map((s): Statement => {
    if (s.kind === "path" || s.kind === "functions") return { ...s, words: wordsIn(s.words, converted) };
    return s.kind === "cycle" ? { ...s, parameters: s.parameters.map(converted.parameter(s.cycle)) } : s;
  });
}
