import { readFile } from "node:fs/promises";
import type { Page } from "@playwright/test";
import { LANGUAGES, ncLanguageOf } from "../src/i18n/languages.ts";
import { formatNumber } from "../src/i18n/number.ts";
import { built } from "./pages/built.ts";
import { ambiguous, controls } from "./pages/controls.ts";
import { expect, test } from "./pages/test.ts";

/* Uses names only: the page objects that other test projects get, and nothing else of this project. */
const { Turnwise } = built;

for (const language of LANGUAGES) {
  test(`the way to a program in ${language}`, async ({ page }) => {
    const turnwise = await Turnwise.open(page, { language });
    const { dialog, effect, lathe, program } = turnwise;
    await expect(page.locator("html")).toHaveAttribute("lang", language);
    await turnwise.start.beginWithExample(812);
    await expect(dialog.question).toHaveText(dialog.promptOf(812, "Q215"));
    await dialog.set("Q463", formatNumber(language, 2.4));
    await effect.proved();
    await expect(lathe.picture).toBeVisible();
    expect.soft(ambiguous(await controls(page.locator("body")))).toEqual([]);
    await dialog.open("Q493");
    await dialog.type("x");
    await expect(dialog.messages).not.toBeEmpty();
    await page.keyboard.press("Escape");
    await program.chooseLabels(ncLanguageOf(language));
    expect(await program.copy()).toContain("Q463=+2.4 ");
    await expect(program.confirmation).toBeVisible();
    await page.reload();
    await expect(page.locator("html")).toHaveAttribute("lang", language);
    await expect(dialog.line("Q463")).toContainText(formatNumber(language, 2.4));
  });
}

test("with a manual clock and a seed two runs give the same addresses, dates and files, byte by byte", async ({
  browser,
  page: firstPage,
}) => {
  const run = async (page: Page) => {
    const turnwise = await Turnwise.open(page, { heldClock: "2026-11-21T08:05", seed: 7 });
    const { dialog, editor, effect, lathe, program, settings, start, t } = turnwise;
    const seen: string[] = [];
    await start.beginWithExample(812);
    await dialog.set("Q463", "2.4");
    await effect.proved();
    seen.push(page.url(), await readFile(await (await program.download()).path(), "utf8"));
    await page.getByRole("link", { name: t.page.home }).click();
    await lathe.advance(61_000);
    await editor.openExample("groove");
    seen.push(page.url(), (await editor.downloaded()).toString("latin1"));
    await page.getByRole("link", { name: t.page.home }).click();
    const kept = page.getByRole("region", { name: t.page.start.kept });
    await expect(kept).toContainText(/8:06/);
    seen.push(await kept.ariaSnapshot());
    await settings.open();
    const all = await settings.export();
    seen.push(all.suggestedFilename(), (await readFile(await all.path())).toString("latin1"));
    return seen;
  };
  const first = await run(firstPage);
  expect(first[0]).not.toBe(first[2]);
  expect(first[4]).toContain("Nov 21, 2026, 8:05");
  const context = await browser.newContext();
  expect(await run(await context.newPage())).toEqual(first);
  await context.close();
});
