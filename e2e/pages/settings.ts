import type { Download, Locator } from "@playwright/test";
import { SCREEN_LANGUAGES, type Language } from "../../src/i18n/languages.ts";
import type { Context } from "./context.ts";
import { Menus } from "./menus.ts";
import { words } from "./words.ts";

/** Language, appearance and motion, and the data stored on the device. */
export class SettingsPage {
  constructor(private readonly context: Context) {}

  get dialog(): Locator {
    return this.context.page.getByRole("dialog", { name: this.context.t.page.settings, exact: true });
  }

  /** Opens the dialog, and waits for it. */
  async open(): Promise<void> {
    await new Menus(this.context).header(this.context.t.page.settings);
    await this.dialog.waitFor();
  }

  /** Changes the screen language; from then on, all names on the page are in that language. */
  async chooseLanguage(language: Language): Promise<void> {
    await this.open();
    await this.dialog.getByRole("combobox", { name: this.context.t.page.screenLanguage, exact: true }).selectOption({
      label: SCREEN_LANGUAGES[language].name,
    });
    const { settings, close } = words(language, "workplace").page;
    const dialog = this.context.page.getByRole("dialog", { name: settings, exact: true });
    await dialog.getByRole("button", { name: close, exact: true }).click();
  }

  /** Makes all letters large, or the default size, with the dialog open. */
  async chooseLetters(size: "usual" | "presentation"): Promise<void> {
    await this.dialog.getByRole("combobox", { name: this.context.t.page.size, exact: true }).selectOption(size);
  }

  /** Machine data: the preset, the values, the file out and in. */
  get machine(): Locator {
    const { title } = words(this.context.language, "machine");
    return this.dialog.getByRole("region", { name: title, exact: true });
  }

  /** The button that saves a backup: all works, tools, own cycles, settings and course progress in one file. */
  get saveAll(): Locator {
    return this.dialog.getByRole("button", { name: this.device.exportLong, exact: true });
  }

  /** Saves a backup, with the dialog open. */
  async export(): Promise<Download> {
    const waiting = this.context.page.waitForEvent("download");
    await this.saveAll.click();
    return waiting;
  }

  /** Opens a backup, with the dialog open, up to the question what to restore. */
  async import(name: string, bytes: Uint8Array): Promise<void> {
    const choosing = this.context.page.waitForEvent("filechooser");
    await this.dialog.getByRole("button", { name: this.device.importLong, exact: true }).click();
    await (await choosing).setFiles({ name, mimeType: "application/zip", buffer: Buffer.from(bytes) });
  }

  private get device() {
    return words(this.context.language, "device").here;
  }
}
