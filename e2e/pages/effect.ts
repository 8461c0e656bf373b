import type { Locator } from "@playwright/test";
import type { Context } from "./turnwise.ts";

type Cell = "passes" | "infeed" | "time" | "chip" | "residual" | "proof";

/** What the values do, updated while they are typed. */
export class Effect {
  constructor(private readonly context: Context) {}

  get strip(): Locator {
    return this.context.page.getByRole("region", { name: this.context.t.page.effect.title, exact: true });
  }

  /** The value of one cell, found by its name. */
  cell(cell: Cell): Locator {
    const name = this.context.page.getByRole("term").filter({ hasText: this.context.t.page.effect[cell] });
    return this.strip.locator("div").filter({ has: name }).getByRole("definition");
  }

  /** The button that leads to the list of problems; absent when there are none. */
  get problems(): Locator {
    return this.strip.getByRole("button");
  }
}
