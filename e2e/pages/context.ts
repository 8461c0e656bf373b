import type { Page } from "@playwright/test";
import type { TableTexts, Texts } from "../../src/i18n/index.ts";
import type { Language } from "../../src/i18n/languages.ts";

/** Shared by all page objects: the browser page and the texts of its screen language. */
export interface Context {
  readonly page: Page;
  readonly t: Texts & TableTexts;
  readonly language: Language;
}
