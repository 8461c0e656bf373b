import { readFile } from "node:fs/promises";
import { betterWays as ways } from "../src/i18n/en/better-ways.ts";
import { compare as words } from "../src/i18n/en/compare.ts";
import { expectFineAtSizes, expectFineInBothThemes } from "./pages/layout-checks.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

test("a changed infeed is listed with its effect, by keyboard, and leads to its block", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { editor, t } = turnwise;
  await editor.openExample("flange");
  await expect(editor.total(t.page.effect.passes)).toHaveText("25");
  await editor.show("text");
  await turnwise.menus.choose("program", t.page.text.compare);
  const dialog = page.getByRole("dialog", { name: words.title, exact: true });
  await dialog.getByRole("combobox", { name: words.with }).selectOption(words.opened);
  await expect(dialog.getByRole("status")).toHaveText(words.same);
  await page.keyboard.press("Escape");
  await expect(turnwise.menus.button("program")).toBeFocused();

  // Paste another state of the same program: two other values and another title.
  const text = await readFile("src/examples/flange.h", "utf8");
  const other = text
    .replace("Q463=+3 ;", "Q463=+4 ;")
    .replace("TOOL CALL 3", "TOOL CALL 5")
    .replace("FACING", "FACE FIRST");
  await page.evaluate((copied) => navigator.clipboard.writeText(copied), other);
  await turnwise.menus.choose("program", t.page.text.compare);
  await dialog.getByRole("button", { name: words.clipboard, exact: true }).click();
  await expect(dialog.getByRole("status")).toContainText(`${words.values(2)}; ${words.time("")}`);
  const rows = dialog.getByRole("group", { name: words.list }).getByRole("button");
  await expect(rows).toHaveCount(2);
  await expect(rows.first()).toContainText("4 → 3");
  await expect(dialog.getByText(`${words.effects.passes} 5 → 7`)).toBeVisible();
  await dialog.getByRole("checkbox", { name: words.showWritten }).check();
  await expect(rows).toHaveCount(3);
  await expect(rows.first()).toContainText("FACE FIRST");
  await dialog.getByRole("button", { name: words.next, exact: true }).press("Enter");
  await expect(rows.first()).toBeFocused();
  await page.keyboard.press("ArrowDown");
  await expect(rows.nth(1)).toBeFocused();
  await expectFineAtSizes(page, "the comparison", [
    [1280, 844],
    [768, 844],
    [390, 844],
  ]);
  await dialog.getByRole("button", { name: words.copy, exact: true }).click();
  const copied = () => page.evaluate(() => navigator.clipboard.readText());
  await expect.poll(copied).toContain("Q463 Max. infeed 4 → 3");
  expect(await copied()).toContain("    - Q463=+4");

  await page.setViewportSize({ width: 1280, height: 800 });
  await rows.nth(1).click();
  await expect(dialog).toHaveCount(0);
  await expect(editor.text).toBeFocused();
  await expect(editor.line("CYCL DEF 812")).toBeInViewport();
});

test("improvements are found, compared, used one by one, and undone; a cycle work is compared too", async ({
  page,
}) => {
  const turnwise = await Turnwise.open(page);
  const { editor, t } = turnwise;
  await editor.openExample("flange");
  await editor.show("findings");
  const changes = editor.total(t.editor.toolChanges);
  await expect(changes).toHaveText("6");
  await page.getByRole("button", { name: t.findings.betterWays, exact: true }).press("Enter");
  const dialog = page.getByRole("dialog", { name: ways.title, exact: true });
  const status = dialog.getByRole("status").first();
  const found = new RegExp(ways.found(7, 0).replace(/\d+/g, String.raw`\d+`));
  await expect(status).toHaveText(found, { timeout: 20_000 });
  const rows = dialog.getByRole("list", { name: ways.list, exact: true }).getByRole("listitem");
  const gain = ways.gains.toolGone("15");
  // A pair of improvements may stand above the single one.
  const first = rows.filter({ has: page.getByText(gain, { exact: true }) });
  await expect(first).toHaveCount(1);
  const count = await rows.count();
  await first.getByRole("button", { expanded: false }).press("Enter");
  await expect(first.getByRole("group", { name: words.list }).getByRole("button")).toContainText("TOOL CALL 1");
  await expectFineInBothThemes(page, "improvements");

  await first.getByRole("button", { name: ways.useLong(gain), exact: true }).press("Enter");
  await expect(dialog.getByText(ways.used(gain))).toBeVisible();
  await expect(changes).toHaveText("5");
  await expect(status).toHaveText(found, { timeout: 20_000 });
  await expect(dialog.getByText(gain, { exact: true })).toHaveCount(0);
  await dialog.getByRole("button", { name: ways.undo, exact: true }).press("Enter");
  await expect(changes).toHaveText("6");
  await expect(rows).toHaveCount(count, { timeout: 20_000 });
  await page.keyboard.press("Escape");
  await expect(page.getByRole("button", { name: t.findings.betterWays, exact: true })).toBeFocused();

  // A cycle work is compared with an earlier one by its NC program.
  await page.getByRole("link", { name: t.page.home, exact: true }).click();
  await turnwise.start.beginWithExample(812);
  await turnwise.dialog.set("Q463", "2.4");
  await turnwise.show("program");
  await turnwise.menus.choose("program", t.page.text.compare);
  const compared = page.getByRole("dialog", { name: words.title, exact: true });
  await expect(compared.getByRole("status")).toContainText(words.values(1));
  const row = compared.getByRole("group", { name: words.list }).getByRole("button");
  await expect(row).toContainText("3 → 2.4");
  await row.click();
  await expect(compared).toHaveCount(0);
});
