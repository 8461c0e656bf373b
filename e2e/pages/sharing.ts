import { expect, type Locator } from "@playwright/test";
import type { HandedTexts } from "../../src/i18n/en/handed.ts";
import type { Context } from "./context.ts";
import { Menus } from "./menus.ts";
import { words } from "./words.ts";

/** Sharing works: the share dialog, the contents of a link or file, and the tools that came with a work. */
export class Sharing {
  readonly words: HandedTexts;
  constructor(private readonly context: Context) {
    this.words = words(context.language, "handed");
  }

  /** The share dialog. */
  get shareDialog(): Locator {
    return this.context.page.getByRole("dialog", { name: this.words.title, exact: true });
  }

  /** Opens the share dialog, with the button below the program. */
  async openDialog(): Promise<void> {
    await new Menus(this.context).choose("export", this.context.t.page.text.handOn);
  }

  /** The link in the dialog, once it is ready. */
  async link(): Promise<string> {
    const box = this.shareDialog.getByRole("textbox");
    await expect(box).toHaveValue(/#/, { timeout: 60_000 });
    return box.inputValue();
  }

  /** The contents of a received link or file, before it is opened. */
  incoming(name: string): Locator {
    return this.context.page.getByRole("dialog", { name: this.words.inside(name), exact: true });
  }

  /** Opens the received link or file. */
  async open(): Promise<void> {
    await this.context.page.getByRole("dialog").getByRole("button", { name: this.words.open, exact: true }).click();
  }

  /** The line above a work that runs with other tools than the device has. */
  get toolsLine(): Locator {
    return this.context.page.getByRole("region", { name: this.words.ofWork, exact: true });
  }

  /** The tools that came with the open work. */
  get tools(): Locator {
    return this.context.page.getByRole("dialog", { name: this.words.ofWork, exact: true });
  }
}
