import type { BlockIssue } from "../issue.ts";
import type { BlockLine } from "../read-cycle.ts";
import type { Scan } from "../scan.ts";
import type { FeedWord, Label, Parameter, Value } from "../words.ts";
import type { Style } from "../style.ts";
import type { ComparedWords } from "./compared-words.ts";

/** The values of a word shown on its guide page, besides the usual one. */
export type Spread =
  /** The given texts. */
  | { readonly choices: readonly string[] }
  /** The usual value times each of these. */
  | { readonly times: readonly number[] }
  /** The usual value plus each of these. */
  | { readonly plus: readonly number[] }
  /** One word of the text in place of another, either way. */
  | { readonly swap: readonly [string, string] }
  /** Other tools like the usual one. */
  | { readonly tools: true };

/** Why a word has no live picture in the guide. */
export type Unseen =
  | "name"
  | "axis"
  | "milling"
  | "free"
  | "choice"
  | "together"
  | "compensation"
  | "functions"
  | "same";

/** The values of a field by entry kind; null where the field is empty. */
export interface Typed {
  readonly choice: string;
  readonly text: string;
  readonly value: Value | null;
  readonly feed: FeedWord | null;
  readonly tool: Label | Parameter | null;
  readonly functions: readonly number[];
  /** A retraction, which may go as far as the machine can. */
  readonly retract: Value | "max" | null;
  /** A value of a cycle. */
  readonly parameter: Value | "max" | "auto" | null;
}

/** Properties of a field for forms and guide. `Name`: key of its text; a word of the program is its own name. */
export interface FieldFacts<Name extends string = string> {
  /** Stable for the field, whatever the block contains. */
  readonly id: string;
  readonly name: Name | { readonly word: string };
  readonly unit?: string;
  /** Choices show their own words, or the text of their key; an empty one is "none". */
  readonly choices?: readonly string[];
  /** Longer text, as wide as the form. */
  readonly wide?: boolean;
  /** Letters in front of its value, where they differ from its id. */
  readonly letter?: string;
  readonly spread?: Spread;
  readonly noPicture?: Unseen;
  /** The set-up page about it. */
  readonly setup?: string;
  /** The guide text about it, where it has none of its own. */
  readonly about?: string;
}

/** A field for one value of a statement, or of a part of it. Neither function mutates its argument. */
export interface ValueField<
  S,
  E extends keyof Typed = keyof Typed,
  Name extends string = string,
> extends FieldFacts<Name> {
  readonly entry: E;
  get(s: S): Typed[E];
  /** The statement with the value; undefined where the value is not allowed. */
  put(s: S, value: Typed[E]): S | undefined;
  /** The switch for incremental coordinates. */
  readonly incremental?: { read(s: S): boolean; write(s: S, on: boolean): S };
}

/** A field that holds the block as text, or the rest of it. */
export interface LineField<S, Name extends string = string> extends FieldFacts<Name> {
  readonly entry: "line";
  /** The shown part of the printed block. */
  shown(text: string): string;
  /** The text of the whole block. */
  line(s: S, typed: string): string;
  /** The block stays one of its kind. */
  readonly keeps: boolean;
}

export type Field<S, Name extends string = string> =
  | { [E in keyof Typed]: ValueField<S, E, Name> }[keyof Typed]
  | LineField<S, Name>;

/** One property of a statement: how it is read, printed, compared and typed. */
export interface Word<Key extends string = string, T = unknown, Name extends string = string> {
  readonly key: Key;
  /** Takes the word at the reading position; undefined where it is absent. */
  take(scan: Scan): T | undefined;
  /** The word with the blank in front of it; empty where it is not written. */
  text(value: T, style: Style, statement: never): string;
  /** True for a word that starts with letters: its place after the words without letters is free. */
  readonly lettered: boolean;
  /** The value where the word is absent; without it such a block cannot be read. */
  readonly absent?: T;
  /** The letters reported as missing. */
  readonly needed?: string;
  /** Stores a word that nothing else reads. */
  keep?(value: T, word: string): T;
  /** Adds the word to a block comparison; a kind without such words is compared as text. */
  compareAs?(value: T, said: ComparedWords): void;
  fields?(value: T, statement: never): readonly Field<T, Name>[];
  /** Never set: carries the field names for the compiler. */
  readonly names?: Name;
}

/** A word of any type. Field names stay open, so that each declaration keeps its own. */
export type AnyWord = Omit<Word, "fields" | "names"> & {
  fields?(value: unknown, statement: never): readonly unknown[];
};

/** The role of a block kind in the order of a program. */
export type Tag =
  /** Has no effect on the control. */
  | "note"
  /** States the blank. */
  | "blank"
  /** Stands before the first operation. */
  | "opening"
  /** Calls the defined cycle, or runs something else in its place. */
  | "calls"
  /** Changes the coordinates of all following blocks. */
  | "movesFrame"
  /** Names the contour of the next cycle. */
  | "namesContour"
  /** May stand between the definition and the call of a cycle. */
  | "preparesCycle"
  /** May stand between a tool call and the first cut. */
  | "preparesTool"
  /** May stand before the tool call that begins a section. */
  | "leadsTool"
  /** Belongs to the tool that was called, not to its first cut. */
  | "ofTool"
  /** May follow the last cut of a tool. */
  | "leaves"
  /** Ends a contour. */
  | "endsContour"
  /** May stand between an element and the rounding or chamfer on its end. */
  | "waits";

/** A small program of the guide. The line of the block begins with `> `; a text alone is an element of a contour. */
export type Sample = string | readonly string[];

/** Groups of the palette. */
export type Group = "frame" | "technology" | "path" | "contour" | "cycles" | "order" | "notes";

/** Words of the NC text language for new statements. */
export interface NcWords {
  /** In front of the labels of cycle 14. */
  readonly contourLabel: string;
}

type Flat<T> = { [K in keyof T]: T[K] } & {};
/** The statement type made of its words. */
export type StatementOfWords<K extends string, W extends readonly AnyWord[]> = Flat<
  { readonly kind: K } & {
    readonly [E in W[number] as E["key"]]: E extends { take(scan: Scan): infer T } ? Exclude<T, undefined> : never;
  }
>;

/** A block being read: its text after the keyword, and all its lines. */
export interface BlockReading {
  readonly scan: Scan;
  /** The text matched as its beginning. */
  readonly head: string;
  readonly lines: readonly BlockLine[];
  /** Of further lines. */
  readonly issues: BlockIssue[];
}

/** Properties of one name of a kind, or of the kind where it has one name. */
export interface Named<S> {
  /** Its palette group, and its initial statement; null where that must be chosen first. */
  readonly offered?: { readonly group: Group; readonly begins: S | ((nc: NcWords) => S) | null };
  readonly sample?: Sample;
  /** Why its words have no live picture. */
  readonly noPicture?: Unseen;
  /** Samples for single words, by field id. */
  readonly samples?: Readonly<Record<string, Sample>>;
}

/** The complete declaration of a block kind. */
export interface BlockDefinition<
  K extends string = string,
  W extends readonly AnyWord[] = readonly Word[],
  N extends string = string,
  F extends string = string,
> extends Named<StatementOfWords<K, W>> {
  readonly kind: K;
  /** Its keyword as printed; further spellings are read as well. */
  readonly keyword?: string | readonly string[];
  /** A pattern of its beginning, where keywords are not enough. */
  readonly begins?: string;
  /** Its words in the order in which they are printed, compared and asked for. */
  readonly words: W;
  /** Properties given by its beginning. */
  found?(reading: BlockReading): Partial<StatementOfWords<K, W>>;
  /** Text printed before its words, if not its keyword. */
  lead?(s: StatementOfWords<K, W>): string;
  /** Custom reading and printing, where its words are not enough. Null: not of this kind. */
  read?(reading: BlockReading): StatementOfWords<K, W> | null;
  print?(s: StatementOfWords<K, W>, style: Style): string | readonly string[];
  /** A kind written on several lines: read by its own reader, or joined to one line. */
  readonly lines?: "own" | "joined";
  /** The fields of its form, if not those of its words in order. */
  fields?(s: StatementOfWords<K, W>): readonly Field<StatementOfWords<K, W>, F>[];
  /** Never set: carries their names for the compiler. */
  readonly fieldNames?: F;
  /** Whether a statement is edited as text. */
  isTypedAsText?(s: StatementOfWords<K, W>): boolean;
  /** Key of comparable blocks: only blocks with the same key are paired. */
  pairKey?(s: StatementOfWords<K, W>): string;
  /** The pairing key with the block's own name. */
  nameKey?(s: StatementOfWords<K, W>): string;
  /** Custom comparison, where its words are not enough. `raw`: the text of the block. */
  compareAs?(s: StatementOfWords<K, W>, said: ComparedWords, raw: string): void;
  readonly tags?: readonly Tag[];
  /** Where the list of parts shows it. */
  readonly part?: "operations" | "labels" | "notes";
  /** The names of its statements, if not the kind. */
  nameOf?(s: StatementOfWords<K, W>): N;
  readonly names?: { readonly [E in N]: Named<StatementOfWords<K, W>> };
}

/** Keeps the literal types of kind, words and names: the type of the statement follows from them. */
export const defineBlock = <
  const K extends string,
  const W extends readonly AnyWord[],
  const N extends string = K,
  const F extends string = never,
>(
  block: BlockDefinition<K, W, N, F>,
): BlockDefinition<K, W, N, F> => block;

/** A field of a part as a field of the whole. */
export function within<S, T, N extends string>(
  field: Field<T, N>,
  part: (s: S) => T,
  put: (s: S, value: T) => S,
): Field<S, N> {
  if (field.entry === "line") return { ...field, line: (s: S, typed) => field.line(part(s), typed) };
  const { incremental, ...facts } = field as ValueField<T, keyof Typed, N>;
  return {
    ...facts,
    get: (s: S) => facts.get(part(s)),
    put: (s: S, value: never) => {
      const next = facts.put(part(s), value);
      return next === undefined ? undefined : put(s, next);
    },
    ...(incremental && {
      incremental: {
        read: (s: S) => incremental.read(part(s)),
        write: (s: S, on: boolean) => put(s, incremental.write(part(s), on)),
      },
    }),
  } as Field<S, N>;
}
