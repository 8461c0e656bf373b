import { commands } from "../src/i18n/en/commands.ts";
import { find } from "../src/i18n/en/find.ts";
import { keys } from "../src/i18n/en/keys.ts";
import { expectAccessibleAndFits } from "./pages/layout-checks.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

test("a program is searched, changed and gone through by keyboard", async ({ page }) => {
  const { editor } = await Turnwise.open(page);
  await editor.openExample("shaft");
  const bar = page.getByRole("search", { name: find.find });
  const count = bar.getByRole("status");

  await page.keyboard.press("Control+f");
  await expect(bar.getByRole("textbox", { name: find.find })).toBeFocused();
  await page.keyboard.type("l x+92");
  // A screen reader hears the line as well.
  const found = (n: number) => new RegExp(`^${find.position(n, 3)}: \\d+ L X\\+92`);
  await expect(count).toHaveText(found(1));
  for (let i = 0; i < 3; i += 1) await page.keyboard.press("F3");
  await expect(count).toHaveText(found(1));
  await page.keyboard.press("Shift+F3");
  await expect(count).toHaveText(found(3));
  await expectAccessibleAndFits(page);
  await page.keyboard.press("Escape");
  await expect(editor.text).toBeFocused();

  await page.keyboard.press("Control+h");
  await expect(bar.getByRole("textbox", { name: find.find })).toBeFocused();
  await bar.getByRole("textbox", { name: find.with }).fill("L X+93");
  await bar.getByRole("button", { name: find.replaceAll }).press("Enter");
  await expect(count).toHaveText(find.replaced(3));
  await expect(editor.line("L X+93")).toHaveCount(1);
  await page.keyboard.press("Control+z");
  await expect(editor.line("L X+93")).toHaveCount(0);
  await page.keyboard.press("Escape");

  await page.keyboard.press("Control+g");
  await expect(page.getByRole("combobox", { name: find.goToLong })).toBeFocused();
  await page.keyboard.type("lbl 1");
  await expectAccessibleAndFits(page);
  await page.keyboard.press("Enter");
  await expect(editor.text).toBeFocused();
  await expect(page.locator(".nc-open")).toContainText("LBL 1");

  await page.keyboard.press("Control+k");
  const palette = page.getByRole("dialog", { name: commands.title });
  await expect(palette.getByRole("combobox")).toBeFocused();
  await page.keyboard.type("collapse all");
  await expectAccessibleAndFits(page);
  await page.keyboard.press("Enter");
  await expect(palette).toHaveCount(0);
  await expect(page.locator(".nc-folded").first()).toBeVisible();
  await page.keyboard.press("Control+k");
  await expect(palette.getByRole("option").first()).toContainText(keys.does.text.foldAll);
});
