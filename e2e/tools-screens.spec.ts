import AxeBuilder from "@axe-core/playwright";
import { expect, test, type Page } from "@playwright/test";
import { Turnwise } from "./pages/turnwise.ts";

async function look(page: Page): Promise<void> {
  const { violations } = await new AxeBuilder({ page }).analyze();
  expect(violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.target.join(" ")).slice(0, 4).join(" | ")}`)).toEqual([]);
  expect(await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth)).toBeLessThanOrEqual(0);
}

for (const theme of ["light", "dark"] as const) {
  test(`the table passes axe in ${theme}, and fits, also when it is wrong or empty`, async ({ page }) => {
    test.slow();
    const { tools } = await Turnwise.open(page, { theme });
    await tools.open();
    await look(page);
    await tools.cell("RS").fill("x");
    await tools.cell("P-ANGLE").fill("99");
    await look(page);
    await tools.add.click();
    await look(page);
    await tools.show("milling");
    await tools.add.click();
    await tools.cell("R").fill("8");
    await look(page);
    await tools.show("turning");
    for (let n = await tools.table.getByRole("row").count(); n > 1; n -= 1) await tools.remove.click();
    await expect(tools.table).toHaveCount(0);
    await look(page);
  });
}
