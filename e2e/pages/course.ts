import { expect, type Locator } from "@playwright/test";
import type { CoursePathTexts } from "../../src/i18n/en/course-path.ts";
import type { CourseTexts } from "../../src/i18n/en/course.ts";
import type { Context } from "./context.ts";
import { words } from "./words.ts";

/** The course: the list of its lessons, and the open lesson. */
export class Course {
  readonly words: CourseTexts;
  readonly pathWords: CoursePathTexts;
  constructor(private readonly context: Context) {
    this.words = words(context.language, "course");
    this.pathWords = words(context.language, "course-path");
  }

  /** The link to the course on the start page. */
  get entrance(): Locator {
    return this.context.page
      .locator(".start-page")
      .getByRole("link", { name: new RegExp(`^${this.words.entrance.name} `) });
  }

  /** Opens the list of lessons from the start page. */
  async open(): Promise<void> {
    await this.entrance.click();
    await expect(this.lessons).toBeVisible();
  }

  /** The list of lessons, by chapters. */
  get lessons(): Locator {
    return this.context.page.getByRole("group", { name: this.words.lessons, exact: true });
  }

  /** A path through the course. */
  path(title: string): Locator {
    return this.context.page
      .getByRole("group", { name: this.pathWords.choose, exact: true })
      .getByRole("radio", { name: new RegExp(`^${title}`) });
  }

  /** Opens a chapter of the list, or closes it. */
  chapter(title: string): Locator {
    return this.lessons.locator("summary").filter({ hasText: title });
  }

  /** What was missed. */
  get review(): Locator {
    return this.context.page.locator(".course-review");
  }

  /** A lesson in the list, by its number. */
  lesson(number: number): Locator {
    return this.lessons.getByRole("link", { name: new RegExp(`^${this.words.lesson(String(number))}\\s?[:：]`) });
  }

  /** Opens a lesson by its number. */
  async openLesson(number: number): Promise<void> {
    await this.lesson(number).click();
    await expect(this.picture).toBeVisible();
  }

  /** The links to the pages of the open lesson and to its tasks. */
  get pages(): Locator {
    return this.context.page.getByRole("navigation", { name: this.words.pages, exact: true });
  }

  /** The link to a page, or to the tasks. */
  page(at: number | "tasks"): Locator {
    return this.pages.getByRole("link", {
      name: at === "tasks" ? this.words.tasks : this.words.page(String(at)),
      exact: true,
    });
  }

  /** The text of the open page. */
  text(at: number, of: number): Locator {
    return this.context.page.getByRole("region", { name: this.words.pageOf(String(at), String(of)), exact: true });
  }

  get picture(): Locator {
    return this.context.page.getByRole("region", { name: this.words.picture.name, exact: true });
  }

  get play(): Locator {
    return this.picture.getByRole("button", { name: this.words.picture.play, exact: true });
  }

  get pause(): Locator {
    return this.picture.getByRole("button", { name: this.words.picture.pause, exact: true });
  }

  /** The moment shown by the picture, in thousandths. */
  get moment(): Locator {
    return this.picture.getByRole("slider", { name: this.words.picture.scrub, exact: true });
  }

  /** The slider of a value, by its Q number. */
  slide(q: string): Locator {
    return this.context.page.getByRole("slider", { name: new RegExp(`^${q} `) });
  }

  /** A number that depends on the values of the page, by its name on the page. */
  fact(name: string): Locator {
    return this.picture
      .locator("dl > div")
      .filter({ has: this.context.page.getByText(name, { exact: true }) })
      .locator("dd");
  }

  /** The block of the printed program that the picture is at. */
  get runningBlock(): Locator {
    return this.context.page.locator(".lesson-block[data-running]");
  }

  /** The question of the open page. */
  get question(): Locator {
    return this.context.page.getByRole("region", { name: this.words.question.name, exact: true });
  }

  /** An answer of a choice. */
  answer(text: string): Locator {
    return this.question.getByRole("group").getByRole("button", { name: text, exact: true });
  }

  /** The result of the last answer, with its reason. */
  get reason(): Locator {
    return this.question.getByRole("status");
  }

  /** A block of the printed program, while the question asks for one. */
  block(text: string): Locator {
    return this.context.page.getByRole("button", { name: text, exact: true });
  }

  get next(): Locator {
    return this.context.page.getByRole("link", { name: this.words.next, exact: true });
  }

  get toTasks(): Locator {
    return this.context.page.getByRole("link", { name: this.words.toTasks, exact: true });
  }

  get previous(): Locator {
    return this.context.page.getByRole("link", { name: this.words.previous, exact: true });
  }

  /** The button that starts a task, on the page of the tasks. */
  task(title: string): Locator {
    return this.context.page.getByRole("button", { name: title });
  }

  get example(): Locator {
    return this.context.page.getByRole("button", { name: this.words.example, exact: true });
  }
}
