import { menuWordsOf } from "virtual:cycle-menu";
import type { Language } from "../../../i18n/languages.ts";
import type { MenuWords } from "../../../i18n/menu-words.ts";
import { loadTexts, type PartName, type PartTexts } from "../../../i18n/parts.ts";
import { never } from "../../../kernel/never.ts";
import { retryImport } from "../parts.ts";

/** A value for each language, fetched when it is first needed in that language. */
export interface ByLanguage<T> {
  /** The value if it is loaded, else undefined. */
  readonly cached: (language: Language) => T | undefined;
  readonly provide: (language: Language, value: T) => void;
  /** Fetches it once. After a failure the next call fetches again. */
  readonly fetch: (language: Language) => Promise<T>;
  /** The same as one promise per language, which retries as long as it takes. */
  readonly fetchWithRetry: (language: Language) => Promise<T>;
  /** That promise, if `wait` was called. */
  readonly pending: (language: Language) => Promise<T> | undefined;
}

/** Marks a fulfilled promise so that React's `use` reads it without suspending. */
export const markFulfilled = <T>(coming: Promise<T>): void =>
  void coming.then((value) => Object.assign(coming, { status: "fulfilled", value }));

/** Everything requested so far, in any language. */
const asked = new Set<Pick<ByLanguage<unknown>, "cached" | "fetch">>();

export function byLanguage<T>(load: (language: Language) => Promise<T>): ByLanguage<T> {
  const here = new Map<Language, T>();
  const coming = new Map<Language, Promise<T>>();
  const waited = new Map<Language, Promise<T>>();
  const self: ByLanguage<T> = {
    cached: (language) => here.get(language),
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
    fetchWithRetry(language) {
      const made = waited.get(language) ?? retryImport(() => self.fetch(language));
      markFulfilled(made);
      waited.set(language, made);
      return made;
    },
    pending: (language) => waited.get(language),
  };
  return self;
}

/** Fetches in a new language all that the page uses, and what it requests meanwhile. */
export async function fetchRequested(language: Language): Promise<void> {
  for (;;) {
    const lacked = [...asked].filter((each) => each.cached(language) === undefined);
    if (lacked.length === 0) return;
    await Promise.all(lacked.map((each) => each.fetch(language)));
  }
}

/**
 * The texts of a part. The first screen also has the names of the cycles, which the build takes out of the other parts.
 */
export type PartContents<N extends PartName> = N extends "first"
  ? PartTexts<"first"> & { readonly menu: MenuWords }
  : PartTexts<N>;

const loaders: { readonly [N in PartName]?: (language: Language) => Promise<PartContents<N>> } = {
  async first(language) {
    const [first, menu] = await Promise.all([loadTexts(language, "first"), menuWordsOf(language)]);
    return { ...first, menu };
  },
};
const parts = new Map<PartName, ByLanguage<unknown>>();

/** A part of the texts. Most of the page is in "workplace". */
export function partOf<N extends PartName>(name: N): ByLanguage<PartContents<N>> {
  const part = parts.get(name) ?? byLanguage<unknown>(loaders[name] ?? ((language) => loadTexts(language, name)));
  parts.set(name, part);
  return part as ByLanguage<PartContents<N>>;
}

/** Fetches a part in a language; afterwards `texts` has it. */
export const fetchTexts = <N extends PartName = "workplace">(
  language: Language,
  name = "workplace" as N,
): Promise<PartContents<N>> => partOf(name).fetch(language);

/** A part in a language that is loaded: the settings change the language only after that. */
export const texts = <N extends PartName = "workplace">(language: Language, name = "workplace" as N): PartContents<N> =>
  partOf(name).cached(language) ?? never("a language before its texts", language, name);
