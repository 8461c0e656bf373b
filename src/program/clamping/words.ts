import type { ClampingKind } from "../../kernel/area/clamping.ts";

/*
 * `; CLAMPING CHUCK OUTSIDE D60 LENGTH25 FACE-75 SIZE200 QUILL40 TIP-2 ANGLE60 LIMITZ-72 LIMITX100`: a comment for a
 * control, the clamping for those who know it. Lengths in the unit of the program, D, SIZE, QUILL and LIMITX as ⌀.
 */

/** Words of a clamping with a number, in the order in which they are written. */
export const CLAMPING_WORDS = ["D", "LENGTH", "FACE", "SIZE", "QUILL", "TIP", "ANGLE", "LIMITZ", "LIMITX"] as const;
export type ClampingWord = (typeof CLAMPING_WORDS)[number];

/** Words for each kind of clamping. */
export const KIND_WORDS: Readonly<Record<ClampingKind, string>> = {
  chuckOutside: "CHUCK OUTSIDE",
  chuckInside: "CHUCK INSIDE",
  softJaws: "SOFT JAWS",
  collet: "COLLET",
  centres: "BETWEEN CENTRES",
};

/** Required words of a clamping; between centres the tailstock is part of it. */
export const neededWords = (kind: ClampingKind): readonly ClampingWord[] =>
  kind === "centres" ? ["D", "FACE", "QUILL", "TIP"] : ["D", "LENGTH", "FACE", "SIZE"];

/** Default point angle of a centre, degrees. */
export const CENTRE_ANGLE = 60;

/** Words that accept any number; ANGLE is between 10 and 170, the others are above 0. */
export const ANY_NUMBER: ReadonlySet<ClampingWord> = new Set(["FACE", "TIP", "LIMITZ"]);
export const [LEAST_ANGLE, MOST_ANGLE] = [10, 170];

/** A clamping as typed: its kind, and the text of each word. */
export interface ClampingDraft {
  readonly kind: ClampingKind;
  readonly words: Readonly<Record<string, string>>;
}

/** Every kind. */
export const CLAMPING_KINDS = ["chuckOutside", "chuckInside", "softJaws", "collet", "centres"] as const;

/** Words that a kind does not have. */
const NONE_BETWEEN_CENTRES: ReadonlySet<string> = new Set(["LENGTH", "SIZE"]);

/** Words of a kind of clamping, in writing order. */
export const wordsOfKind = (kind: ClampingKind): readonly ClampingWord[] =>
  CLAMPING_WORDS.filter((word) => kind !== "centres" || !NONE_BETWEEN_CENTRES.has(word));

/** A clamping as comment text, without the `;`. */
export const clampingText = ({ kind, words }: ClampingDraft): string =>
  [
    "CLAMPING",
    KIND_WORDS[kind],
    ...wordsOfKind(kind).flatMap((word) => {
      const text = (words[word] ?? "").replace(/[\s;~]+/gu, "");
      return text === "" ? [] : [word + text];
    }),
  ].join(" ");
