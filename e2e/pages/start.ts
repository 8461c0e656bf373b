import type { Locator } from "@playwright/test";
import type { CycleNumber } from "../../src/cycles/index.ts";
import { promptIds } from "./prompt-ids.ts";
import type { Context } from "./context.ts";

/** The first screen: a row for every cycle, and stored works. */
export class Start {
  constructor(private readonly context: Context) {}

  /** Numbers of all cycles that can be chosen. */
  readonly cycles: readonly number[] = Object.keys(promptIds).map(Number);

  button(cycle: number, withExample: boolean): Locator {
    const { page, t } = this.context;
    const name = t.page.start.cycle(cycle, t.cycles.of[cycle as CycleNumber].name);
    return page.getByRole("button", {
      name: `${name}: ${withExample ? t.page.start.withExample : t.page.start.empty}`,
      exact: true,
    });
  }

  /** Searches the cycles by number, name or shop term; on the start page, examples and stored works too. */
  get search(): Locator {
    const { page, t } = this.context;
    const named = (name: string) => page.getByRole("searchbox", { name, exact: true });
    return named(t.page.start.search).or(named(t.chooser.search));
  }

  /** The recently used cycles. */
  get recent(): Locator {
    return this.context.page.getByRole("region", { name: this.context.t.chooser.recent, exact: true });
  }

  /** The head of a group, which folds its cycles. */
  group(name: string): Locator {
    return this.context.page.getByRole("region", { name, exact: true }).getByRole("heading").getByRole("button");
  }

  /** Starts by the row of a cycle; if the groups are folded, by searching for its number. */
  private async begin(cycle: number, withExample: boolean): Promise<void> {
    await this.search.waitFor();
    if (!(await this.button(cycle, withExample).isVisible())) await this.search.fill(String(cycle));
    await this.button(cycle, withExample).click();
  }

  async beginEmpty(cycle: number): Promise<void> {
    await this.begin(cycle, false);
  }

  async beginWithExample(cycle: number): Promise<void> {
    await this.begin(cycle, true);
  }

  /** The stored work of this name. */
  kept(name: string): Locator {
    const { page, t } = this.context;
    return page.getByRole("button", { name: t.page.start.continueWork(name), exact: true });
  }
}
