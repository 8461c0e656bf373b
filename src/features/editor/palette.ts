import { firstValues } from "../../cycles/first-values.ts";
import type { Cycle } from "../../cycles/define.ts";
import { ncLabels } from "../../i18n/nc-labels.ts";
import { ncLanguageOf, type Language } from "../../i18n/languages.ts";
import { statementLine } from "../../app/fields/blocks/block-fields.ts";
import type { Group } from "../../nc/blocks/define.ts";
import type { Grammar } from "../../nc/blocks/grammar.ts";
import { klartext } from "../../nc/blocks/klartext.ts";
import type { BlockKind } from "../../nc/blocks/names.ts";
import type { Statement } from "../../nc/statement.ts";

/** A block that can be inserted: its kind, and its initial statement. */
export interface Offered<S = Statement> {
  readonly group: Group;
  readonly kind: BlockKind;
  /** Null if the kind alone is not enough: the cycle is chosen next. */
  readonly make: ((language: Language) => S) | null;
}

/** A cycle of the catalogue with the values of its printed example and labels in a language. */
export function cycleStatement(cycle: Cycle, language: Language): Statement {
  const labels = ncLabels(ncLanguageOf(language));
  const values = firstValues(cycle);
  return {
    kind: "cycle",
    cycle: cycle.number,
    name: labels.cycleName(cycle.number),
    parameters: Object.entries(cycle.params).map(([q, p]) => ({
      q,
      value: values[q] ?? p.example,
      label: labels.label(p.text),
    })),
  };
}

/** What a grammar offers, in the order of its kinds. */
export const paletteOf = <S extends { readonly kind: string }>({ named }: Grammar<S>): readonly Offered<S>[] =>
  named.flatMap(([name, { offered }]) => {
    if (!offered) return [];
    const { group, begins } = offered;
    const make = (language: Language): S =>
      typeof begins === "function"
        ? begins({ contourLabel: ncLabels(ncLanguageOf(language)).contour.label })
        : (begins as S);
    return [{ group, kind: name as BlockKind, make: begins === null ? null : make }];
  });

/** How many words of a block name its kind, by the first of them; one otherwise. */
const NAMING_WORDS: Readonly<Record<string, number>> = {
  FUNCTION: 3,
  BLK: 3,
  TOOL: 2,
  CYCL: 2,
  CALL: 2,
  SEL: 2,
  BEGIN: 2,
  END: 2,
};

/** The word of the program that a block begins with: `L`, `TOOL CALL`, `FUNCTION TURNDATA SPIN`. */
export function ncWordOf({ make }: Offered, language: Language): string {
  // Only a cycle is made in a second step.
  if (!make) return "CYCL DEF";
  const [first = "", ...more] = statementLine(make(language)).split(" ");
  const naming = more.slice(0, (NAMING_WORDS[first] ?? 1) - 1).flatMap((word) => /^[A-Z]{2,}/.exec(word)?.[0] ?? []);
  return [first.replace(/(?<!\d)\d+$/, ""), ...naming].join(" ");
}

/** The name of a kind without its word of the program in brackets. */
export const plainName = (name: string): string => name.replace(/(?<!\s)\s*[(（][^()（）]*[)）]$/, "");

/** Every kind of block that can be inserted. */
export const palette = paletteOf(klartext);
