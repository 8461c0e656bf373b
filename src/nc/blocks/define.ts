import type { BlockIssue } from "../issue.ts";
import type { BlockLine } from "../read-cycle.ts";
import type { Scan } from "../scan.ts";
import type { FeedWord, Label, Parameter, Value } from "../words.ts";
import type { Style } from "../style.ts";
import type { Said } from "./said.ts";

/** Which values of a word its page of the guide shows beside the usual one. */
export type Spread =
  /** The texts that are given. */
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
  "name" | "axis" | "milling" | "free" | "choice" | "together" | "compensation" | "functions" | "same";

/** What is typed into a field, and what the statement takes of it; null where nothing stands there. */
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

/** What a form and the guide know of a field. `Name` is the key of its text; a word of the program names itself. */
export interface FieldFacts<Name extends string = string> {
  /** The same for the same field, whatever the block holds. */
  readonly id: string;
  readonly name: Name | { readonly word: string };
  readonly unit?: string;
  /** Choices show their own words, or the text of their key; an empty one is "none". */
  readonly choices?: readonly string[];
  /** Longer text, as wide as the form. */
  readonly wide?: boolean;
  /** How it is written in front of its value, where that is not its id. */
  readonly letter?: string;
  readonly spread?: Spread;
  readonly unseen?: Unseen;
  /** The page of the set-up that speaks of it. */
  readonly setup?: string;
  /** The text of the guide that speaks of it where it has none of its own. */
  readonly about?: string;
}

/** A field that holds one value of a statement, or of a part of it. Neither function changes what it is given. */
export interface ValueField<
  S,
  E extends keyof Typed = keyof Typed,
  Name extends string = string,
> extends FieldFacts<Name> {
  readonly entry: E;
  get(s: S): Typed[E];
  /** The statement with the value; undefined where it does not take it. */
  put(s: S, value: Typed[E]): S | undefined;
  /** A switch beside the value, for incremental coordinates. */
  readonly incremental?: { read(s: S): boolean; write(s: S, on: boolean): S };
}

/** A field that holds the block as text, or the rest of it. */
export interface LineField<S, Name extends string = string> extends FieldFacts<Name> {
  readonly entry: "line";
  /** What is shown of the printed block. */
  shown(text: string): string;
  /** The text of the whole block. */
  line(s: S, typed: string): string;
  /** The block stays one of its kind. */
  readonly keeps: boolean;
}

export type Field<S, Name extends string = string> =
  { [E in keyof Typed]: ValueField<S, E, Name> }[keyof Typed] | LineField<S, Name>;

/** One thing of a statement: the property that holds it, how it is read, printed, compared and typed. */
export interface Word<Key extends string = string, T = unknown, Name extends string = string> {
  readonly key: Key;
  /** Takes the word where the reader stands; undefined where it does not stand there. */
  take(scan: Scan): T | undefined;
  /** The word with the blank in front of it; empty where nothing is written. */
  text(value: T, style: Style, statement: never): string;
  /** True for a word that its letters announce: it may stand anywhere behind those without. */
  readonly lettered: boolean;
  /** What holds where it is not written; without it the block cannot be read then. */
  readonly absent?: T;
  /** The letters that are reported where it is missing. */
  readonly needed?: string;
  /** Takes up a word that nothing else reads. */
  keep?(value: T, word: string): T;
  /** What a comparison of two blocks reads; a kind without such words is compared as text. */
  say?(value: T, said: Said): void;
  fields?(value: T, statement: never): readonly Field<T, Name>[];
  /** Never there: it holds the names of the fields for the compiler. */
  readonly names?: Name;
}

/** A word of any type. It leaves the names of fields open, so that each declaration keeps its own. */
export type AnyWord = Omit<Word, "fields" | "names"> & {
  fields?(value: unknown, statement: never): readonly unknown[];
};

/** What a kind of block is to the order of a program. */
export type Tag =
  /** Says nothing to the control. */
  | "note"
  /** States the blank. */
  | "blank"
  /** Stands before the first operation. */
  | "opening"
  /** Calls the cycle that is defined, or runs something else in its place. */
  | "calls"
  /** Changes the coordinates of all that comes behind it. */
  | "movesFrame"
  /** Names the contour that the next cycle is run with. */
  | "namesContour"
  /** May stand between what is called and the cycle that is called. */
  | "preparesCycle"
  /** May stand between a tool call and the first cut. */
  | "preparesTool"
  /** May stand before the tool call that begins a section. */
  | "leadsTool"
  /** Belongs to the tool that was called, not to its first cut. */
  | "ofTool"
  /** May stand behind the last cut of a tool. */
  | "leaves"
  /** No contour goes on behind it. */
  | "endsContour"
  /** May stand between an element and the rounding or chamfer on its end. */
  | "waits";

/** A small program of the guide. The line of the block begins with `> `; a text alone is an element of a contour. */
export type Sample = string | readonly string[];

/** Groups of the palette. */
export type Group = "frame" | "technology" | "path" | "contour" | "cycles" | "order" | "notes";

/** What a statement begins as may hang on a word of the language of NC text. */
export interface NcWords {
  /** In front of the labels of cycle 14. */
  readonly contourLabel: string;
}

type Flat<T> = { [K in keyof T]: T[K] } & {};
/** The statement that words hold together. */
export type StatementOfWords<K extends string, W extends readonly AnyWord[]> = Flat<
  { readonly kind: K } & {
    readonly [E in W[number] as E["key"]]: E extends { take(scan: Scan): infer T } ? Exclude<T, undefined> : never;
  }
>;

/** A block that is being read: its text behind its keyword, and all its lines. */
export interface BlockReading {
  readonly scan: Scan;
  /** What of it was taken as its beginning. */
  readonly head: string;
  readonly lines: readonly BlockLine[];
  /** Of further lines. */
  readonly issues: BlockIssue[];
}

/** What one name of a kind has of its own, or the kind where it has one name. */
export interface Named<S> {
  /** Where the palette offers it, and what it begins as; null where that has to be chosen first. */
  readonly offered?: { readonly group: Group; readonly begins: S | ((nc: NcWords) => S) | null };
  readonly sample?: Sample;
  /** Why its words have no live picture. */
  readonly unseen?: Unseen;
  /** Words that are shown in another sample, by the id of their field. */
  readonly samples?: Readonly<Record<string, Sample>>;
}

/** A kind of block: everything that is known of it. */
export interface BlockDefinition<
  K extends string = string,
  W extends readonly AnyWord[] = readonly Word[],
  N extends string = string,
  F extends string = string,
> extends Named<StatementOfWords<K, W>> {
  readonly kind: K;
  /** How it begins, as it is printed; other spellings behind it are read as well. */
  readonly keyword?: string | readonly string[];
  /** A pattern in place of the keywords, where they do not say it. */
  readonly begins?: string;
  /** Its words in the order in which they are printed, compared and asked for. */
  readonly words: W;
  /** What its beginning says of it already. */
  found?(reading: BlockReading): Partial<StatementOfWords<K, W>>;
  /** What is printed in front of its words, where that is not its keyword. */
  lead?(s: StatementOfWords<K, W>): string;
  /** Where its words alone do not say how it is read and printed. Null: it is none of this kind. */
  read?(reading: BlockReading): StatementOfWords<K, W> | null;
  print?(s: StatementOfWords<K, W>, style: Style): string | readonly string[];
  /** A kind that is written on several lines: read by itself, or as one line. */
  readonly lines?: "own" | "joined";
  /** What a form asks for, where that is not what its words ask for in their order. */
  fields?(s: StatementOfWords<K, W>): readonly Field<StatementOfWords<K, W>, F>[];
  /** Never there: it holds the names of those for the compiler. */
  readonly fieldNames?: F;
  /** Whether a statement is typed as text. */
  asText?(s: StatementOfWords<K, W>): boolean;
  /** Only blocks that give the same here are set against each other. */
  pairs?(s: StatementOfWords<K, W>): string;
  /** The same with what names it. */
  like?(s: StatementOfWords<K, W>): string;
  /** What is compared, where its words do not say it. `raw`: the text of the block. */
  say?(s: StatementOfWords<K, W>, said: Said, raw: string): void;
  readonly tags?: readonly Tag[];
  /** Where the list of parts shows it. */
  readonly part?: "operations" | "labels" | "notes";
  /** The names that its statements go by, where they are not the kind. */
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
