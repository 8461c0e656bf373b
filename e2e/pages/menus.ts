import type { Locator } from "@playwright/test";
import type { Context } from "./context.ts";

/** The menus below the program text. */
export class Menus {
  constructor(private readonly context: Context) {}

  /** The button of a menu; it has the focus again when what was chosen there is closed. */
  button(menu: "export" | "program"): Locator {
    const { page, t } = this.context;
    const name = menu === "export" ? t.page.text.exportMenu : t.page.program;
    return page.getByRole("button", { name, exact: true });
  }

  /** Opens a menu and chooses an item. */
  async choose(menu: "export" | "program", item: string | RegExp): Promise<void> {
    await this.button(menu).click();
    await this.context.page.getByRole("menuitem", { name: item, exact: true }).click();
  }
}
