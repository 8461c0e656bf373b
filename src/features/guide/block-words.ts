import type { GuideBlocksTexts } from "../../i18n/en/guide-blocks.ts";
import type { GuidePlacesTexts } from "../../i18n/en/guide-places.ts";
import type { BlockKind } from "../../app/fields/blocks/block-kind.ts";
import type { SetupPageId } from "./setup-variants.ts";

/** What is said about a word of a block. */
export interface WordTexts {
  readonly about: string;
  readonly mistakes: readonly string[];
}

/** Words that the set-up of a cycle has as well: what is said there holds here. */
const OF_SETUP: Readonly<Record<string, SetupPageId>> = {
  "blankCylinder.outside": "blank.outside",
  "blankCylinder.inside": "blank.bore",
  "blankCylinder.length": "blank.length",
  "blankCylinder.distance": "blank.allowance",
  "toolCall.tool": "tool",
  "spin.cuttingSpeed": "spindle.cuttingSpeed",
  "spin.speed": "spindle.speed",
  "spin.speedLimit": "spindle.limit",
};

/** Words of blocks that are given by name, and that one text speaks of. */
const COMMON: readonly (readonly [BlockKind, RegExp, string])[] = [
  ["cycle", /^Q\d/, "parameter"],
  ["free", /./, "free"],
];
const AXIS = /^[ABCUVW]$/;

const entry = <T>(of: Readonly<Record<string, T>>, key: string): T | null =>
  Object.hasOwn(of, key) ? (of[key] ?? null) : null;

/**
 * What is said about a word in a kind of block; null where there is nothing. `places`: the pages of the set-up, where
 * they are at hand.
 */
export function blockWordTexts(
  t: GuideBlocksTexts,
  kind: BlockKind,
  word: string,
  places?: GuidePlacesTexts,
): WordTexts | null {
  const setup = OF_SETUP[`${kind}.${word}`];
  if (setup) return places?.places[setup] ?? { about: "", mistakes: [] };
  const common = COMMON.find(([of, form]) => of === kind && form.test(word))?.[2];
  return entry(t.of, `${kind}.${word}`) ?? entry(t.of, word) ?? entry(t.of, AXIS.test(word) ? "axis" : (common ?? ""));
}

/** The rule of the control for a word, where it has one of its own; empty where it has none. */
export const blockRule = (t: GuideBlocksTexts, kind: BlockKind, word: string): string =>
  entry(t.rules, `${kind}.${word}`) ?? entry(t.rules, word) ?? "";

/** How a word is written in the program, by the id of its field; words that are not written have none. */
const LETTERS: Readonly<Record<string, string>> = {
  outside: "D",
  inside: "DI",
  distance: "DIST",
  "blankCylinder.length": "L",
  "toolDefinition.length": "L",
  length: "LEN",
  tool: "T",
  speed: "S",
  feed: "F",
  deltaLength: "DL",
  deltaRadius: "DR",
  toolRadius: "R",
  constantSurface: "VCONST",
  cuttingSpeed: "VC",
  speedLimit: "SMAX",
  radius: "R",
  turn: "DR",
  compensation: "RL/RR",
  functions: "M",
  polarRadius: "PR",
  polarAngle: "PA",
  centreAngle: "CCA",
  retract: "MB",
  chamfer: "CHF",
  repeat: "REP",
  label: "LBL",
};

/** How a word of a block is written in front of its value; empty where only the block says it. */
export const blockLetter = (kind: BlockKind, word: string): string =>
  LETTERS[`${kind}.${word}`] ?? LETTERS[word] ?? (/^[A-Z_]+\d*$/.test(word) ? word : "");
