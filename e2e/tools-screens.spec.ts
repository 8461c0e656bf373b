import type { Page } from "@playwright/test";
import { looksRight } from "./pages/look.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

async function table(page: Page, theme: "light" | "dark") {
  const { tools } = await Turnwise.open(page, { theme });
  await tools.open();
  return tools;
}

/* One journey for each state of the table: looking at one takes axe seconds on a slow machine. */
for (const theme of ["light", "dark"] as const) {
  test(`the table passes axe in ${theme}, and fits`, async ({ page }) => {
    await table(page, theme);
    await looksRight(page);
  });

  test(`a tool that is wrong passes axe in ${theme}, and fits`, async ({ page }) => {
    const tools = await table(page, theme);
    await tools.cell("RS").fill("x");
    await tools.cell("P-ANGLE").fill("99");
    await looksRight(page);
  });

  test(`a new tool passes axe in ${theme}, and fits`, async ({ page }) => {
    const tools = await table(page, theme);
    await tools.add.click();
    await looksRight(page);
  });

  test(`milling tools pass axe in ${theme}, and fit`, async ({ page }) => {
    const tools = await table(page, theme);
    await tools.show("milling");
    await tools.add.click();
    await tools.cell("R").fill("8");
    await looksRight(page);
  });

  test(`the empty table passes axe in ${theme}, and fits`, async ({ page }) => {
    const tools = await table(page, theme);
    for (let n = await tools.table.getByRole("row").count(); n > 1; n -= 1) await tools.remove.click();
    await expect(tools.table).toHaveCount(0);
    await looksRight(page);
  });
}
