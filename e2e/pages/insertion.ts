import { expect, type Locator } from "@playwright/test";
import { insert as words } from "../../src/i18n/en/insert.ts";
import type { Site } from "../../src/cycles/shape-request.ts";
import type { Context } from "./context.ts";

/** Answers to the prompts of an inserted operation: a text is typed, an empty one takes what is suggested or there. */
type Answers = readonly (readonly [q: string, text: string])[];

/** Builds a program from operations, by keyboard in English; each value, choice and confirmation is an entry. */
export class Insertion {
  entries = 0;

  constructor(private readonly context: Context) {}

  get dialog(): Locator {
    return this.context.page.getByRole("dialog", { name: this.context.t.operations.insert, exact: true });
  }

  private async press(key: string): Promise<void> {
    await this.context.page.keyboard.press(key);
    this.entries += 1;
  }

  /** Types a value and confirms it. */
  async enter(text: string): Promise<void> {
    await this.context.page.keyboard.type(text);
    await this.press("Enter");
  }

  /** Chooses site, cycle and, where only the drawing knows it, the start; the suitable tool is proposed. */
  async begin(cycle: number, { site = "outside", start = "" }: { site?: Site; start?: string } = {}): Promise<void> {
    const { page, t } = this.context;
    const search = this.dialog.getByRole("searchbox");
    await expect(search).toBeFocused();
    if (site === "inside") {
      await page.keyboard.press("Shift+Tab");
      await this.press("ArrowRight");
      await expect(this.dialog.getByRole("radio", { name: words.sites.inside, exact: true })).toBeChecked();
      await page.keyboard.press("Tab");
    }
    await this.enter(String(cycle));
    const field = this.dialog.getByRole("textbox", {
      name: start === "" ? t.operations.title : t.setup.start.z,
    });
    await expect(field).toBeFocused();
    await this.enter(start);
    await expect(this.dialog).toHaveCount(0);
  }

  /** Answers prompts from the first open one on. */
  async answer(answers: Answers): Promise<void> {
    const { page, t } = this.context;
    const active = page.getByRole("region", { name: t.dialog.active, exact: true });
    for (const [q, text] of answers) {
      await expect(active.locator(".prompt-q")).toHaveText(q);
      await this.enter(text);
    }
    await this.press("End");
    await expect(active.getByRole("heading")).toHaveText(t.dialog.done.title);
  }

  /** Goes on to the next operation from the end of the prompts. */
  async next(): Promise<void> {
    const { page, t } = this.context;
    await expect(page.getByRole("form").getByRole("button", { name: t.operations.insert, exact: true })).toBeFocused();
    await this.press("Enter");
  }
}
