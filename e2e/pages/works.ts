import type { Download, Locator } from "@playwright/test";
import type { DeviceTexts } from "../../src/i18n/en/device.ts";
import { counted } from "./pattern.ts";
import type { Context } from "./context.ts";
import { words } from "./words.ts";

/** The list of all works stored on the device. */
export class WorksList {
  private readonly words: DeviceTexts["works"];

  constructor(private readonly context: Context) {
    this.words = words(context.language, "device").works;
  }

  /** Opens the list from the start page. */
  async open(): Promise<void> {
    const { page, t } = this.context;
    await page.getByRole("link", { name: counted(t.page.start.allWorks) }).click();
    await this.search.waitFor();
  }

  /** Goes back to the start page. */
  async close(): Promise<void> {
    await this.button(this.words.back).click();
  }

  /** Searches the works by name or cycle. */
  get search(): Locator {
    return this.context.page.getByRole("searchbox", { name: this.words.search, exact: true });
  }

  /** Sorts the list. */
  async sort(order: "newest" | "name" | "kind" | "size"): Promise<void> {
    await this.context.page
      .getByRole("combobox", { name: this.words.sort, exact: true })
      .selectOption({ label: this.words.orders[order] });
  }

  /** The rows, in the order in which they are shown. */
  get rows(): Locator {
    return this.context.page.getByRole("list", { name: this.words.list, exact: true }).getByRole("listitem");
  }

  /** The button that opens a work. */
  work(name: string): Locator {
    return this.button(this.words.open(name));
  }

  /** Renames a work. */
  async rename(name: string, newName: string): Promise<void> {
    await this.button(this.words.rename(name)).click();
    const field = this.context.page.getByRole("textbox", { name: this.words.newName(name), exact: true });
    await field.fill(newName);
    await field.press("Enter");
    await this.work(newName).waitFor();
  }

  async duplicate(name: string): Promise<void> {
    await this.button(this.words.duplicate(name)).click();
  }

  async remove(name: string): Promise<void> {
    await this.button(this.words.remove(name)).click();
  }

  /** The undo button in the status of the last action. */
  get takeBack(): Locator {
    return this.context.page.getByRole("status").getByRole("button", { name: `${this.context.t.page.undo} – ` });
  }

  /** Selects a work for the actions on several works. */
  select(name: string): Locator {
    return this.context.page.getByRole("checkbox", { name: this.words.select(name), exact: true });
  }

  get selectAll(): Locator {
    return this.context.page.getByRole("checkbox", { name: this.words.selectAll, exact: true });
  }

  /** Saves the selected works as one file. */
  async saveSelected(): Promise<Download> {
    const waiting = this.context.page.waitForEvent("download");
    await this.button(this.words.saveSelected).click();
    return waiting;
  }

  async removeSelected(): Promise<void> {
    await this.button(this.words.removeSelected).click();
  }

  private button(name: string): Locator {
    return this.context.page.getByRole("button", { name, exact: true });
  }
}
