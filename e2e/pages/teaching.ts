import { expect, type Locator } from "@playwright/test";
import type { CourseSetTexts } from "../../src/i18n/en/course-set.ts";
import type { CourseTeachTexts } from "../../src/i18n/en/course-teach.ts";
import type { Context } from "./context.ts";
import { Menus } from "./menus.ts";
import { words } from "./words.ts";

/** Tasks and sets of an instructor: making, handing out, working on them, handing in, and the table of results. */
export class Teaching {
  readonly words: CourseTeachTexts;
  readonly setWords: CourseSetTexts;
  constructor(private readonly context: Context) {
    this.words = words(context.language, "course-teach");
    this.setWords = words(context.language, "course-set");
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

  /** Makes an empty set, from the list of lessons, and opens its form. */
  async newSet(title: string): Promise<void> {
    await this.context.page.getByRole("button", { name: this.setWords.make, exact: true }).click();
    await this.setForm.getByLabel(this.words.name, { exact: true }).fill(title);
  }

  /** The form of a set. */
  get setForm(): Locator {
    return this.context.page.getByRole("dialog", { name: this.setWords.title, exact: true });
  }

  /** Adds a task to the set, by its title. */
  async addToSet(task: string): Promise<void> {
    await this.setForm.getByRole("combobox", { name: this.setWords.add }).selectOption({ label: task });
    await expect(this.setForm.getByRole("listitem").filter({ hasText: task })).toBeVisible();
  }

  /** Makes the set an exam; `minutes`: its time limit. */
  async makeExam(minutes: number): Promise<void> {
    await this.setForm.getByRole("radio", { name: this.setWords.modes.exam, exact: true }).check();
    await this.setForm.getByLabel(this.setWords.minutes, { exact: true }).fill(String(minutes));
  }

  /** A received set, before it is kept. */
  incomingSet(title: string): Locator {
    return this.context.page.getByRole("dialog", { name: this.setWords.incoming.title(title), exact: true });
  }

  /** The conditions of an exam, before it starts. */
  examStart(title: string): Locator {
    return this.context.page.getByRole("dialog", { name: this.setWords.exam.title(title), exact: true });
  }

  /** Reads the conditions of a received exam and starts it. */
  async startExam(title: string, learner: string, group = ""): Promise<void> {
    await this.incomingSet(title).getByRole("button", { name: this.setWords.incoming.keepExam, exact: true }).click();
    const start = this.examStart(title);
    await start.getByLabel(this.setWords.paper.name, { exact: true }).fill(learner);
    await start.getByLabel(this.setWords.group, { exact: true }).fill(group);
    await start.getByRole("button", { name: this.setWords.exam.start, exact: true }).click();
  }

  /** The line of the open set above its work: the place in it, the time left, and handing in. */
  get setBar(): Locator {
    return this.context.page.getByRole("region", { name: this.setWords.bar, exact: true });
  }

  /** The time left in an exam. */
  get timeLeft(): Locator {
    return this.setBar.getByRole("timer");
  }

  /** Goes to the next task of the open set. */
  async nextOfSet(title: string): Promise<void> {
    await this.setBar.getByRole("button", { name: this.setWords.after(title), exact: true }).click();
  }

  /** The results of several learners. */
  classOf(learners: number): Locator {
    return this.context.page.getByRole("dialog", {
      name: this.words.results.gathered(String(learners)),
      exact: true,
    });
  }
}
