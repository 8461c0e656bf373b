import { menuWordsOf } from "virtual:cycle-menu";
import type { Language } from "../../../i18n/languages.ts";
import type { MenuWords } from "../../../i18n/menu-words.ts";
import { loadTexts, type PartName, type PartTexts } from "../../../i18n/parts.ts";
import { never } from "../../../kernel/never.ts";
import { untilHere } from "../parts.ts";

/** Something that the page has in each language, and fetches in one when it is first needed there. */
export interface ByLanguage<T> {
  /** What was fetched or provided; undefined before. */
  readonly here: (language: Language) => T | undefined;
  readonly provide: (language: Language, value: T) => void;
  /** Fetches it once. Fails where it does not come; then the next call fetches again. */
  readonly fetch: (language: Language) => Promise<T>;
  /** The same as one promise for each language, which waits as long as it takes. */
  readonly wait: (language: Language) => Promise<T>;
  /** That promise, where somebody waits for it or has waited. */
  readonly waited: (language: Language) => Promise<T> | undefined;
}

/** What has come is used without another wait. */
export const atOnce = <T>(coming: Promise<T>): void =>
  void coming.then((value) => Object.assign(coming, { status: "fulfilled", value }));

/** Everything that was asked for so far, in any language. */
const asked = new Set<Pick<ByLanguage<unknown>, "here" | "fetch">>();

export function byLanguage<T>(load: (language: Language) => Promise<T>): ByLanguage<T> {
  const here = new Map<Language, T>();
  const coming = new Map<Language, Promise<T>>();
  const waited = new Map<Language, Promise<T>>();
  const self: ByLanguage<T> = {
    here: (language) => here.get(language),
    provide(language, value) {
      here.set(language, value);
      coming.set(language, Promise.resolve(value));
    },
    fetch(language) {
      asked.add(self);
      const known = coming.get(language);
      if (known) return known;
      const made = load(language).then((value) => {
        here.set(language, value);
        return value;
      });
      coming.set(language, made);
      made.catch(() => coming.delete(language));
      return made;
    },
    wait(language) {
      const made = waited.get(language) ?? untilHere(() => self.fetch(language));
      atOnce(made);
      waited.set(language, made);
      return made;
    },
    waited: (language) => waited.get(language),
  };
  return self;
}

/** Fetches in a language what the page has asked for in another, and what it asks for meanwhile. */
export async function fetchAsked(language: Language): Promise<void> {
  for (;;) {
    const lacked = [...asked].filter((each) => each.here(language) === undefined);
    if (lacked.length === 0) return;
    await Promise.all(lacked.map((each) => each.fetch(language)));
  }
}

/**
 * What a part says on the page: the first screen also has the names of the cycles, which the build takes out of the
 * other parts.
 */
export type Said<N extends PartName> = N extends "first"
  ? PartTexts<"first"> & { readonly menu: MenuWords }
  : PartTexts<N>;

const loaders: { readonly [N in PartName]?: (language: Language) => Promise<Said<N>> } = {
  async first(language) {
    const [first, menu] = await Promise.all([loadTexts(language, "first"), menuWordsOf(language)]);
    return { ...first, menu };
  },
};
const parts = new Map<PartName, ByLanguage<unknown>>();

/** A part of the texts. The one that most of the page is made of is "workplace". */
export function partOf<N extends PartName>(name: N): ByLanguage<Said<N>> {
  const part = parts.get(name) ?? byLanguage<unknown>(loaders[name] ?? ((language) => loadTexts(language, name)));
  parts.set(name, part);
  return part as ByLanguage<Said<N>>;
}

/** Fetches a part in a language; afterwards `texts` has it. */
export const fetchTexts = <N extends PartName = "workplace">(
  language: Language,
  name = "workplace" as N,
): Promise<Said<N>> => partOf(name).fetch(language);

/** A part in a language that has been fetched: the settings change their language only after that. */
export const texts = <N extends PartName = "workplace">(language: Language, name = "workplace" as N): Said<N> =>
  partOf(name).here(language) ?? never("a language before its texts", language, name);
