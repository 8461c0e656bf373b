import type { Locator } from "@playwright/test";
import type { Context } from "./turnwise.ts";

/** The list of all findings. */
export class Problems {
  constructor(private readonly context: Context) {}

  get panel(): Locator {
    return this.context.page.getByRole("tabpanel", { name: new RegExp(`^${this.context.t.page.problems}`) });
  }

  get items(): Locator {
    return this.panel.getByRole("listitem");
  }
}
