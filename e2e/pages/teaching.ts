import { expect, type Locator } from "@playwright/test";
import type { CourseTeachTexts } from "../../src/i18n/en/course-teach.ts";
import type { Context } from "./context.ts";
import { Menus } from "./menus.ts";
import { words } from "./words.ts";

/** The instructor's side: makes a task from the open program, shares it, reads results. */
export class Teaching {
  readonly words: CourseTeachTexts;
  constructor(private readonly context: Context) {
    this.words = words(context.language, "course-teach");
  }

  /** The form over the open program. */
  get form(): Locator {
    return this.context.page.getByRole("dialog", { name: this.words.title, exact: true });
  }

  /** Opens the form, and waits until the program has run. */
  async openForm(): Promise<void> {
    await new Menus(this.context).choose("export", this.context.t.page.text.makeTask);
    await expect(this.form.getByLabel(this.words.name, { exact: true })).toBeVisible();
  }

  /** Fills in the required texts. */
  async fillTexts(title: string, ask: string): Promise<void> {
    await this.form.getByLabel(this.words.name, { exact: true }).fill(title);
    await this.form.getByLabel(this.words.ask, { exact: true }).fill(ask);
    for (const [i, hint] of this.words.hints.entries())
      await this.form.getByLabel(hint, { exact: true }).fill(`${i + 1}. ${title}`);
  }

  /** The status: whether the answer passes. */
  get check(): Locator {
    return this.form.getByRole("region", { name: this.words.check, exact: true }).getByRole("status");
  }

  /** The link of a dialog. */
  link(dialog: Locator): Promise<string> {
    return dialog.getByRole("textbox", { name: new RegExp(`^${this.words.link} `) }).inputValue();
  }

  /** A received task, before it is kept. */
  incoming(title: string): Locator {
    return this.context.page.getByRole("dialog", { name: this.words.incoming.title(title), exact: true });
  }

  /** The tasks of an instructor, below the lessons. */
  get kept(): Locator {
    return this.context.page.getByRole("region", { name: this.words.own.title, exact: true });
  }

  /** The dialog that collects results to hand in. */
  get handIn(): Locator {
    return this.context.page.getByRole("dialog", { name: this.words.hand.title, exact: true });
  }

  /** Results received under a name. */
  results(name: string): Locator {
    return this.context.page.getByRole("dialog", { name: this.words.results.title(name), exact: true });
  }
}
