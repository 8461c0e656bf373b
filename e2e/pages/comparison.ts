import type { Locator } from "@playwright/test";
import type { CompareTexts } from "../../src/i18n/en/compare.ts";
import type { Context } from "./context.ts";
import { Menus } from "./menus.ts";
import { words } from "./words.ts";

/** Compares the open program with another one, block by block in meaning. */
export class Comparison {
  private readonly words: CompareTexts;

  constructor(private readonly context: Context) {
    this.words = words(context.language, "compare");
  }

  get dialog(): Locator {
    return this.context.page.getByRole("dialog", { name: this.words.title, exact: true });
  }

  /** Opens the comparison, by the button below the program. */
  async open(): Promise<void> {
    await new Menus(this.context).choose("program", this.context.t.page.text.compare);
    await this.other.waitFor();
  }

  async close(): Promise<void> {
    await this.button(this.context.t.page.close).click();
  }

  /** The other program: an earlier state, or a stored work by its name. */
  get other(): Locator {
    return this.dialog.getByRole("combobox", { name: this.words.with, exact: true });
  }

  /** Compares with the work as it was opened. */
  async withOpened(): Promise<void> {
    await this.other.selectOption({ label: this.words.opened });
  }

  /** Compares with another kept work. */
  async withWork(name: string): Promise<void> {
    await this.other.selectOption({ label: name });
  }

  /** Compares with a file of the device. */
  async withFile(name: string, text: string): Promise<void> {
    const choosing = this.context.page.waitForEvent("filechooser");
    await this.button(this.words.file).click();
    await (await choosing).setFiles({ name, mimeType: "text/plain", buffer: Buffer.from(text) });
  }

  /** Compares with the program on the clipboard. */
  async withClipboard(): Promise<void> {
    await this.button(this.words.clipboard).click();
  }

  /** The number of differences by kind, or that there are none. */
  get summary(): Locator {
    return this.dialog.getByRole("region", { name: this.words.whole, exact: true }).getByRole("status");
  }

  /** Effect of the differences on the whole program: time, infeed, passes, residual material. */
  get consequences(): Locator {
    return this.dialog.getByRole("list", { name: this.words.whole, exact: true }).getByRole("listitem");
  }

  /** The differences; each leads to its block. */
  get differences(): Locator {
    return this.dialog.getByRole("group", { name: this.words.list, exact: true }).getByRole("button");
  }

  /** Shows differences in comments and spelling as well. */
  get writing(): Locator {
    return this.dialog.getByRole("checkbox", { name: this.words.showWritten });
  }

  private button(name: string): Locator {
    return this.dialog.getByRole("button", { name, exact: true });
  }
}
