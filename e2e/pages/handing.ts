import { expect, type Locator } from "@playwright/test";
import type { HandedTexts } from "../../src/i18n/en/handed.ts";
import type { Context } from "./context.ts";
import { words } from "./words.ts";

/** Works that are handed on: the ways out, what a link or a file holds, and the tools that came with a work. */
export class Handing {
  readonly words: HandedTexts;
  constructor(private readonly context: Context) {
    this.words = words(context.language, "handed");
  }

  /** The dialog of the ways out. */
  get out(): Locator {
    return this.context.page.getByRole("dialog", { name: this.words.title, exact: true });
  }

  /** Opens the ways out, by the button below the program. */
  async handOn(): Promise<void> {
    await this.context.page.getByRole("button", { name: this.context.t.page.text.handOn, exact: true }).click();
  }

  /** The link of the open dialog, once it is made. */
  async link(): Promise<string> {
    const box = this.out.getByRole("textbox");
    await expect(box).toHaveValue(/#/, { timeout: 60_000 });
    return box.inputValue();
  }

  /** What a link or a file holds, before it is opened. */
  inside(name: string): Locator {
    return this.context.page.getByRole("dialog", { name: this.words.inside(name), exact: true });
  }

  /** Opens what a link or a file holds. */
  async open(): Promise<void> {
    await this.context.page.getByRole("dialog").getByRole("button", { name: this.words.open, exact: true }).click();
  }

  /** The line over a work that runs with tools of its own. */
  get line(): Locator {
    return this.context.page.getByRole("region", { name: this.words.ofWork, exact: true });
  }

  /** The tools that came with the open work. */
  get tools(): Locator {
    return this.context.page.getByRole("dialog", { name: this.words.ofWork, exact: true });
  }
}
