import { use, useDeferredValue, useEffect, useState } from "react";
import type { Language } from "../../../i18n/languages.ts";
import { untilHere } from "../parts.ts";
import { useSettings } from "./settings.ts";

/** Texts of one part of the page, which come with it. */
export interface LaterTexts<T> {
  /** The texts of the screen language. What uses them is not shown before; after a switch the old ones stay until the new ones are here. */
  readonly useThem: () => T;
  /** The same; null until they are here, where something of the part is shown without them. */
  readonly useThemSoon: () => T | null;
  /** Puts the texts of a language in place. */
  readonly provide: (language: Language, texts: T) => void;
}

/**
 * What has come is used without another wait. A component that has waited is rendered once more and must ask the same promise again:
 * React goes on with its further hooks there, and fails over them otherwise.
 */
export const atOnce = <T>(coming: Promise<T>): void => void coming.then((value) => Object.assign(coming, { status: "fulfilled", value }));

/** Hooks for texts that are fetched once in each language when they are first needed; what does not come is fetched again. */
export function laterTexts<T extends object>(load: (language: Language) => Promise<T>): LaterTexts<T> {
  const here = new Map<Language, T>();
  const coming = new Map<Language, Promise<T>>();
  const provide = (language: Language, texts: T) => void here.set(language, texts);
  const fetched = (language: Language): Promise<T> => {
    const made = coming.get(language) ?? untilHere(() => load(language)).then((texts) => {
      provide(language, texts);
      return texts;
    });
    atOnce(made);
    coming.set(language, made);
    return made;
  };
  return {
    provide,
    useThem() {
      const language = useDeferredValue(useSettings((s) => s.language));
      const asked = coming.get(language);
      return asked ? use(asked) : here.get(language) ?? use(fetched(language));
    },
    useThemSoon() {
      const language = useSettings((s) => s.language);
      const [texts, say] = useState<T | null>(() => here.get(language) ?? null);
      useEffect(() => {
        let gone = false;
        void fetched(language).then((loaded) => {
          if (!gone) say(loaded);
        });
        return () => {
          gone = true;
        };
      }, [language]);
      return texts;
    },
  };
}
