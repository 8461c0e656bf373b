import type { PartProblem, PartProblemCode, PartProblemValues, PartSide } from "../planning/part/part-problem.ts";
import type { Language } from "./languages.ts";
import { formatNumber } from "./number.ts";

type Written<V> = { readonly [K in keyof V]: string };

/** The contours of a part, and a sentence for each problem; numbers arrive written, lengths in mm. */
export interface PartProblemTexts {
  readonly sides: Readonly<Record<PartSide, string>>;
  readonly placed: (place: string, sentence: string) => string;
  readonly sentences: {
    readonly [C in PartProblemCode]: (values: Written<PartProblemValues[C]>) => string;
  };
}

/**
 * A problem of a part as a sentence, with contour and row in front. `words`: the part `part` of the texts; `rowText`:
 * sentence of an issue of a contour row.
 */
export function partProblemText(
  language: Language,
  problem: PartProblem,
  words: PartProblemTexts,
  rowText: (issue: Extract<PartProblem, { code: "row" }>["issue"]) => string,
): string {
  const place = [problem.side && words.sides[problem.side], problem.row].filter(Boolean).join(" ");
  const sentence = sentenceOf(language, problem, words, rowText);
  return place === "" ? sentence : words.placed(place, sentence);
}

function sentenceOf(
  language: Language,
  problem: PartProblem,
  words: PartProblemTexts,
  rowText: Parameters<typeof partProblemText>[3],
): string {
  if (problem.code === "row") return rowText(problem.issue);
  const values = Object.fromEntries(
    Object.entries<string | number>(problem.values).map(([name, value]) => [
      name,
      typeof value === "number" ? formatNumber(language, value) : value,
    ]),
  );
  // The texts of a code take the values of that code.
  return (words.sentences[problem.code] as (values: Readonly<Record<string, string>>) => string)(values);
}
