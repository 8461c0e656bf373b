import { texts } from "../src/i18n/index.ts";
import { LANGUAGES } from "../src/i18n/languages.ts";
import { provideTexts } from "../src/app/settings/loaded-texts.ts";

/** Component tests have all languages at hand; the page fetches the one it shows. */
for (const language of LANGUAGES) provideTexts(language, texts(language));
