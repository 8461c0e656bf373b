import type { Locator } from "@playwright/test";
import type { Context } from "./context.ts";

/** The menus below the program text, and that of the header. */
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

  /** Presses a button of the header; on a phone it is an item of the header's menu. */
  async header(name: string): Promise<void> {
    const { page, t } = this.context;
    const button = (each: string) => page.getByRole("banner").getByRole("button", { name: each, exact: true });
    // A new size of the window changes the header in the frame that has it.
    const width = page.viewportSize()?.width;
    if (width !== undefined) await page.waitForFunction((w) => matchMedia(`(width: ${w}px)`).matches, width);
    const menu = button(t.helpMenu.menu);
    await menu.or(button(name)).click();
    if ((await menu.count()) > 0) await page.getByRole("menuitem", { name, exact: true }).click();
  }
}
