import type { NcLanguage } from "../nc/nc-languages.ts";
import { de } from "./nc/de.ts";
import { en } from "./nc/en.ts";
import { fr } from "./nc/fr.ts";
import type { NcWord, NcWords } from "./nc-words.ts";

/** A control set to Chinese prints English words (printed on a TNC7 page). */
const all: Readonly<Record<NcLanguage, NcWords>> = { en, de, fr, zh: en };

/** False for a language in which the control prints another language's words. */
export const hasOwnWords = (language: NcLanguage): boolean => language === "en" || all[language] !== en;

/** The words that a printer of NC text needs. No sentences. */
export interface NcLabels {
  /** Name after the number in the CYCL DEF line; empty for a cycle without a name. */
  cycleName(cycle: number): string;
  /** Label after the semicolon, by the text key of the parameter in the catalogue; empty for an unknown key. */
  label(text: string): string;
  /** Cycle 14: `CYCL DEF 14.0 ${title}`, `CYCL DEF 14.1 ${label}2`. */
  readonly contour: { readonly title: string; readonly label: string };
}

const wordIn = (words: object, key: string | number): NcWord | undefined =>
  Object.hasOwn(words, key) ? (words as Readonly<Record<string, NcWord>>)[key] : undefined;

/** The labels of NC text for a language setting of the control. */
export function ncLabels(language: NcLanguage): NcLabels {
  const words = all[language];
  return {
    cycleName: (cycle) => wordIn(words.cycles, cycle)?.text ?? "",
    label: (text) => wordIn(words.params, text)?.text ?? "",
    contour: words.contour,
  };
}

/** The words with their evidence, for the notice "not printed in the pages we have". */
export const ncWords = (language: NcLanguage): NcWords => all[language];
