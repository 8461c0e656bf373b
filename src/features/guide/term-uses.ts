import { cuttingCycles } from "../../cycles/index.ts";
import type { GlossaryTexts, TermId } from "../../i18n/glossary-text.ts";
import type { GuidePlacesTexts } from "../../i18n/en/guide-places.ts";
import { SETUP_PAGES, type SetupPageId } from "./setup-variants.ts";
import { termParts } from "../../app/fields/said/term-parts.ts";
import { termsOf } from "./terms.ts";

/** A parameter whose page uses a term: the first cycle with it, and the name of its text. */
export interface UsingParameter {
  readonly cycle: number;
  readonly q: string;
  readonly text: string;
}

/** The parameters whose pages link to a term, each once: in the first cycle that has it. */
export function usingParameters(term: TermId): readonly UsingParameter[] {
  const all = cuttingCycles.flatMap(({ number, params }) =>
    Object.entries(params)
      .filter(([, param]) => termsOf(param).includes(term))
      .map(([q, { text }]) => ({ cycle: number, q, text })),
  );
  return all.filter(({ text }, i) => all.findIndex((other) => other.text === text) === i);
}

/** Whether one of several texts uses a term. */
export const usesTerm = (texts: readonly string[], term: TermId, glossary: GlossaryTexts): boolean =>
  termParts(texts, glossary).some((parts) => parts.some((part) => part.term === term));

/** The pages of the set-up that use a term. */
export const usingSetupPages = (
  term: TermId,
  { places }: Pick<GuidePlacesTexts, "places">,
  glossary: GlossaryTexts,
): readonly SetupPageId[] =>
  SETUP_PAGES.filter((id) => usesTerm([places[id].about, ...places[id].mistakes], term, glossary));
