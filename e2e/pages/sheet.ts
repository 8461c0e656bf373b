import { expect, type Locator } from "@playwright/test";
import type { SheetTexts } from "../../src/i18n/en/sheet.ts";
import type { Context } from "./context.ts";
import { Menus } from "./menus.ts";
import { words } from "./words.ts";

/** The setup sheet of the open work. */
export class SetupSheetPage {
  readonly words: SheetTexts;
  constructor(private readonly context: Context) {
    this.words = words(context.language, "sheet");
  }

  /** Opens it by the button below the program. */
  async open(): Promise<void> {
    await new Menus(this.context).choose("export", this.context.t.page.text.setupSheet);
    await expect(this.preview).toBeVisible();
  }

  async close(): Promise<void> {
    await this.context.page.getByRole("button", { name: this.words.close, exact: true }).click();
  }

  /** The sheet as it will be printed. */
  get preview(): Locator {
    return this.context.page.getByRole("article", { name: this.words.preview, exact: true });
  }

  get remarks(): Locator {
    return this.context.page.getByRole("textbox", { name: this.words.remarks, exact: true });
  }

  get paper(): Locator {
    return this.context.page.getByRole("combobox", { name: this.words.paper, exact: true });
  }

  get withProgram(): Locator {
    return this.context.page.getByRole("checkbox", { name: this.words.withProgram, exact: true });
  }

  /** Prints the page: number of pages, and the size of the first one, points. */
  async printed(): Promise<{ readonly pages: number; readonly size: readonly number[] }> {
    const pdf = (await this.context.page.pdf({ preferCSSPageSize: true })).toString("latin1");
    const size =
      /\/MediaBox\s*\[\s*([\d.\s]+)\]/
        .exec(pdf)?.[1]
        ?.trim()
        .split(/\s+/)
        .slice(2)
        .map((n) => Math.round(Number(n))) ?? [];
    return { pages: [...pdf.matchAll(/\/Type\s*\/Page\b(?!s)/g)].length, size };
  }
}
