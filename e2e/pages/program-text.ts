import { expect, type Download, type Locator } from "@playwright/test";
import type { NcLanguage } from "../../src/nc/nc-languages.ts";
import type { Context } from "./context.ts";
import { Menus } from "./menus.ts";

/** The program as the control writes it. */
export class ProgramText {
  constructor(private readonly context: Context) {}

  get panel(): Locator {
    return this.context.page.getByRole("region", { name: this.context.t.page.text.title, exact: true });
  }

  /** The blocks; a cycle with all its lines is one. */
  get blocks(): Locator {
    return this.panel.getByRole("list", { name: this.context.t.page.text.blocks, exact: true }).getByRole("listitem");
  }

  /** The block of the current move in the lathe view. */
  get runningBlock(): Locator {
    return this.panel.locator("[aria-current=step]");
  }

  /** The choice of the control and of the file format for export. */
  get fileNote(): Locator {
    return this.panel.locator(".program-file");
  }

  get copyButton(): Locator {
    return this.context.page.getByRole("button", { name: new RegExp(`^${this.context.t.page.text.copyLong}`) }).first();
  }

  /** The confirmation once the program is on the clipboard. */
  get confirmation(): Locator {
    return this.context.page
      .getByRole("status")
      .filter({ hasText: this.context.t.page.text.copiedLong(0).split("0")[0] ?? "" });
  }

  /** The text on the screen, line by line. */
  async shown(): Promise<string[]> {
    return (await this.panel.getByRole("code").allTextContents()).map((line) => line.trimEnd());
  }

  /** Clicks the button and returns the clipboard. All pages of a browser share it, so it is emptied first. */
  async copy(): Promise<string> {
    await this.context.page.evaluate(() => navigator.clipboard.writeText(""));
    await this.copyButton.click();
    return this.clipboard();
  }

  /** The clipboard, once it holds a program. */
  async clipboard(): Promise<string> {
    const read = () => this.context.page.evaluate(() => navigator.clipboard.readText());
    await expect.poll(read).toContain("END PGM");
    return read();
  }

  async download(): Promise<Download> {
    const waiting = this.context.page.waitForEvent("download");
    await new Menus(this.context).choose("export", new RegExp(this.context.t.page.text.download("").trim()));
    return waiting;
  }

  async chooseLayout(layout: "tnc640" | "tnc7" | "iso" | "manual"): Promise<void> {
    await this.panel.getByRole("combobox", { name: this.context.t.page.text.layout, exact: true }).selectOption(layout);
  }

  async chooseLabels(language: NcLanguage): Promise<void> {
    await this.panel
      .getByRole("combobox", { name: this.context.t.page.text.languageLong, exact: true })
      .selectOption(language);
  }
}
