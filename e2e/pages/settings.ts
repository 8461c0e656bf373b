import type { Locator } from "@playwright/test";
import { LANGUAGE_NAMES, type Language } from "../../src/i18n/languages.ts";
import { texts } from "../../src/i18n/index.ts";
import type { Context } from "./turnwise.ts";

/** Language, appearance and motion. */
export class SettingsPage {
  constructor(private readonly context: Context) {}

  get dialog(): Locator {
    return this.context.page.getByRole("dialog", { name: this.context.t.page.settings, exact: true });
  }

  /** Opens the dialog, and waits for it. */
  async open(): Promise<void> {
    await this.context.page.getByRole("button", { name: this.context.t.page.settings, exact: true }).click();
    await this.dialog.waitFor();
  }

  /** Changes the screen language; from then on every name on the page is one of that language. */
  async chooseLanguage(language: Language): Promise<void> {
    await this.open();
    await this.dialog.getByRole("combobox", { name: this.context.t.page.screenLanguage, exact: true }).selectOption({
      label: LANGUAGE_NAMES[language],
    });
    await this.context.page.getByRole("button", { name: texts(language).page.close, exact: true }).click();
  }
}
