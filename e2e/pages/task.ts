import type { Locator } from "@playwright/test";
import type { CourseDrawingTexts } from "../../src/i18n/en/course-drawing.ts";
import type { CoursePathTexts } from "../../src/i18n/en/course-path.ts";
import type { CourseTaskTexts } from "../../src/i18n/en/course-task.ts";
import type { Context } from "./context.ts";
import { words } from "./words.ts";

/** The panel of a course task above its work: assignment, goals, check and result. */
export class TaskPanel {
  readonly words: CourseTaskTexts;
  private readonly drawn: CourseDrawingTexts;
  readonly pathWords: CoursePathTexts;
  constructor(private readonly context: Context) {
    this.drawn = words(context.language, "course-drawing");
    this.words = words(context.language, "course-task");
    this.pathWords = words(context.language, "course-path");
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

  /** The texts of the status, for `toHaveText`. A count of tries or open goals is given. */
  get states() {
    const { passed, passedFor, failed, stale, tries, checking } = this.words;
    return { passed, passedFor, failed, stale, tries, checking };
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

  /** What was learned; only after passing, in the unfolded assignment. */
  get learned(): Locator {
    return this.panel.locator(".task-learned");
  }

  /** Shows the workshop drawing in place of the lathe, or the lathe again. */
  get draw(): Locator {
    return this.button(this.words.drawing);
  }

  /** The drawing beside the work. */
  get drawing(): Locator {
    const [before = "", after = ""] = this.drawn.drawingOf("\n").split("\n");
    return this.context.page.getByRole("region", { name: new RegExp(`^${before}.*${after}$`) });
  }

  /** A size on the drawing, by the first characters of its text: its name says what makes it in the program. */
  size(characters: string): Locator {
    return this.drawing.getByRole("button", { name: characters });
  }

  /** After passing: the next step in the course. */
  get next(): Locator {
    return this.panel.locator(".task-next");
  }

  /** After passing: plays what was made, or skips to the end of it. */
  get made(): Locator {
    return this.panel.getByRole("button", {
      name: new RegExp(`^(${this.pathWords.made.skip}|${this.pathWords.made.again})$`),
    });
  }

  /** After passing an instructor's task. */
  get handIn(): Locator {
    return this.button(this.pathWords.made.handIn);
  }

  get toLesson(): Locator {
    return this.panel.getByRole("link", { name: this.words.toLesson, exact: true });
  }
}
