import { configure } from "@testing-library/dom";
import { texts } from "../src/i18n/index.ts";
import { LANGUAGES } from "../src/i18n/languages.ts";
import { menuWords } from "../src/i18n/menu-words.ts";
import "../src/shell/slots.ts";
import { partOf } from "../src/app/base/settings/loaded-texts.ts";

/** Timeout for something that never appears: on a slow machine a component may take long to render, ms. */
configure({ asyncUtilTimeout: 60_000 });

/** Component tests have all languages loaded; the page fetches only the one it shows. */
for (const language of LANGUAGES) {
  const all = texts(language);
  partOf("workplace").provide(language, all);
  partOf("tables").provide(language, all);
  partOf("first").provide(language, { ...all, menu: menuWords(language) });
}
