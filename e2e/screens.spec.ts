import AxeBuilder from "@axe-core/playwright";
import { expect, test, type Page } from "@playwright/test";
import { Turnwise } from "./pages/turnwise.ts";

async function accessible(page: Page): Promise<void> {
  const { violations } = await new AxeBuilder({ page }).analyze();
  expect(violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.target.join(" ")).slice(0, 4).join(" | ")}`)).toEqual([]);
}

/** Nothing may stick out of the screen sideways. */
async function fits(page: Page): Promise<void> {
  const over = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  expect(over).toBeLessThanOrEqual(0);
}

for (const theme of ["light", "dark"] as const) {
  test(`every screen passes axe in ${theme}, and fits`, async ({ page }) => {
    const turnwise = await Turnwise.open(page, { theme });
    const { dialog, effect, settings, t } = turnwise;
    const look = async () => {
      await accessible(page);
      await fits(page);
    };
    await expect(turnwise.start.button(820, true)).toBeVisible();
    await look();
    await settings.open();
    await look();
    await page.keyboard.press("Escape");
    await turnwise.start.beginWithExample(820);
    await expect(effect.cell("proof")).toHaveText(t.page.effect.clean);
    await look();
    await dialog.open("Q463");
    await dialog.type("nothing");
    await expect(dialog.messages).not.toBeEmpty();
    await look();
    for (const section of ["setup", "contour", "problems", "program", "prompts"] as const) {
      await turnwise.show(section);
      await look();
    }
    await page.keyboard.press("Escape");
    await dialog.open("Q215");
    await look();
    await page.keyboard.press("End");
    await look();
  });
}
