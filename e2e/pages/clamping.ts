import { expect, type Locator } from "@playwright/test";
import type { ClampingTexts } from "../../src/i18n/en/clamping.ts";
import type { Context } from "./context.ts";
import { Menus } from "./menus.ts";
import { words } from "./words.ts";

type Word = keyof ClampingTexts["words"];

/** Clamping of the work: in the set-up of a cycle, or in the dialog of a program. */
export class ClampingPage {
  readonly words: ClampingTexts;
  constructor(private readonly context: Context) {
    this.words = words(context.language, "clamping");
  }

  /** The dialog of a program, opened by the button below it. */
  get dialog(): Locator {
    return this.context.page.getByRole("dialog", { name: this.context.t.page.text.clamping, exact: true });
  }

  async openDialog(): Promise<void> {
    await new Menus(this.context).choose("program", this.context.t.page.text.clamping);
    await expect(this.dialog).toBeVisible();
  }

  /** The button that starts with a proposed clamping. */
  get state(): Locator {
    return this.context.page.getByRole("button", { name: this.words.state, exact: true });
  }

  get kind(): Locator {
    return this.context.page.getByRole("combobox", { name: this.words.kind, exact: true });
  }

  get tailstock(): Locator {
    return this.context.page.getByRole("checkbox", { name: this.words.tailstock, exact: true });
  }

  /** The field of a word, for a chuck that grips outside. */
  field(word: Word): Locator {
    const name = word === "D" ? this.words.grips.chuckOutside : this.words.words[word];
    return this.context.page.getByRole("textbox", { name, exact: true });
  }
}
