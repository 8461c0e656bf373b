import type { Texts } from "../../../i18n/index.ts";
import type { ApproachWord, WorkingPlane } from "../../../program/motion/approach-fields.ts";

/** Label, prompt and explanation of a word of APPR or DEP. Coordinates name their point: PA, or PN of a departure. */
export function approachWords(
  { ends, words }: Texts["approach"],
  word: ApproachWord,
  { departing, plane }: { readonly departing: boolean; readonly plane: WorkingPlane },
) {
  if (word !== "X" && word !== "Y" && (word !== "Z" || plane === "XY")) return words[word];
  const end = ends[departing ? "PN" : "PA"];
  return { ...end, prompt: end.prompt(word) };
}
