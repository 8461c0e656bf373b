import { which } from "../src/i18n/en/which.ts";
import { expectAccessibleAndFits } from "./pages/layout-checks.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

test("a shape described in a sentence lists the cycles that make it, and the best one starts a verified work", async ({
  page,
}) => {
  const turnwise = await Turnwise.open(page);
  const { effect, t } = turnwise;
  await page.getByRole("button", { name: t.page.start.which, exact: true }).click();
  const dialog = page.getByRole("dialog", { name: which.title });
  await dialog.getByRole("combobox", { name: which.site.label }).selectOption("face");
  await dialog.getByRole("combobox", { name: which.shape.label }).selectOption("groove");
  await dialog.getByRole("textbox", { name: which.measures.z2 }).fill("-9.37");
  const list = dialog.getByRole("list", { name: which.ways });
  await expect(list).toHaveAttribute("aria-busy", "false");
  await expect(list.getByText(which.best, { exact: true })).toBeVisible();
  await expectAccessibleAndFits(page);
  await list
    .getByRole("button", { name: /^Use: / })
    .first()
    .click();
  await expect(dialog).toBeHidden();
  await effect.proved();
});

test("the contour of an open work can be queried, from the lathe view, by keyboard", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { effect, t } = turnwise;
  await turnwise.start.beginWithExample(812);
  await effect.proved();
  await page.getByRole("button", { name: t.lathe.which, exact: true }).focus();
  await page.keyboard.press("Enter");
  const dialog = page.getByRole("dialog", { name: which.title });
  await dialog.getByRole("combobox", { name: which.stretch.last }).selectOption("0");
  await expect(dialog.getByRole("img", { name: /1 to 1/ })).toBeVisible();
  await expect(dialog.getByRole("list", { name: which.ways })).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(dialog).toBeHidden();
});
