import type { Locator } from "@playwright/test";
import type { CourseTaskTexts } from "../../src/i18n/en/course-task.ts";
import type { Context } from "./context.ts";
import { words } from "./words.ts";

/** The panel of a course task above its work: assignment, goals, check and result. */
export class TaskPanel {
  readonly words: CourseTaskTexts;
  constructor(private readonly context: Context) {
    this.words = words(context.language, "course-task");
  }

  /** The whole panel: beside the work, or in its place on a small screen. */
  get panel(): Locator {
    const { page } = this.context;
    const name = new RegExp(`^${this.words.region("")}`);
    return page.getByRole("region", { name }).or(page.getByRole("main", { name }));
  }

  /** The status of the task, in one line. */
  get status(): Locator {
    return this.panel.getByRole("status");
  }

  private button(name: string): Locator {
    return this.panel.getByRole("button", { name, exact: true });
  }

  get check(): Locator {
    return this.button(this.words.check);
  }

  /** Unfolds the assignment and the goals, or folds them. */
  get unfold(): Locator {
    return this.button(this.words.unfold);
  }

  get fold(): Locator {
    return this.button(this.words.fold);
  }

  /** The unfolded assignment. */
  get assignment(): Locator {
    return this.panel.getByRole("region", { name: this.words.unfold, exact: true });
  }

  /** A goal of the list, by part of its text. */
  goal(characters: string): Locator {
    return this.panel
      .getByRole("region", { name: this.words.goals, exact: true })
      .getByRole("listitem")
      .filter({ hasText: characters });
  }

  /** The marks, one at a time: a click shows the place. */
  get mark(): Locator {
    return this.panel.getByRole("button", { name: /^\d+: / });
  }

  get nextMark(): Locator {
    return this.button(this.words.next);
  }

  /** A field of the prediction. */
  field(name: "answer" | "x" | "z" | "block"): Locator {
    return this.panel.getByRole("textbox", { name: this.words.predict[name], exact: true });
  }

  /** One of several answers. */
  choice(text: string): Locator {
    return this.panel.getByRole("radio", { name: text });
  }

  get nextQuestion(): Locator {
    return this.button(this.words.predict.nextQuestion);
  }

  get run(): Locator {
    return this.button(this.words.predict.run);
  }

  get again(): Locator {
    return this.button(this.words.predict.again);
  }

  hint(stage: number): Locator {
    return this.button(this.words.showHint(stage, 3));
  }

  get solution(): Locator {
    return this.button(this.words.showSolution);
  }

  get toLesson(): Locator {
    return this.panel.getByRole("link", { name: this.words.toLesson, exact: true });
  }
}
