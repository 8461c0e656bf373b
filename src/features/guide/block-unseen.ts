import type { GuideBlocksTexts } from "../../i18n/en/guide-blocks.ts";
import type { BlockKind } from "../../app/fields/blocks/block-kind.ts";

/** Why a word of a block has no live picture. */
export type UnseenReason = Exclude<keyof GuideBlocksTexts["why"], "yours">;

/** Words by the id of their field; where a kind of block has one of its own: kind and field. */
const WORDS: readonly (readonly [UnseenReason, readonly string[]])[] = [
  ["name", ["name", "label", "file", "text", "kinematics", "target"]],
  ["axis", ["Y", "A", "B", "C", "U", "V", "W"]],
  [
    "milling",
    [
      "deltaLength",
      "deltaRadius",
      "toolRadius",
      "toolCall.speed",
      "toolDefinition.tool",
      "toolDefinition.length",
      "rotation.ROT",
      "SCL",
    ],
  ],
  [
    "choice",
    ["unit", "toolAxis", "mode", "how", "blankSource", "system", "turnCorrection.plane", "CLSD", "groove.form"],
  ],
  ["together", ["C.X", "C.Z"]],
  ["compensation", ["compensation"]],
  ["functions", ["functions"]],
];

/** Why a word has no live picture where none is made of it. */
export const whyUnseen = (kind: BlockKind, word: string): UnseenReason => {
  if (kind === "free") return "free";
  const of = (name: string) => WORDS.find(([, words]) => words.includes(name))?.[0];
  return of(`${kind}.${word}`) ?? of(word) ?? "same";
};
