import { readFile } from "node:fs/promises";
import { secondSide as de } from "../src/i18n/de/second-side.ts";
import { secondSide as words } from "../src/i18n/en/second-side.ts";
import { expectAccessibleAndFits } from "./pages/layout-checks.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

test("the finished part is turned around and continues as a new program; after parting off, bar or part", async ({
  page,
}) => {
  const turnwise = await Turnwise.open(page);
  const { editor, effect, start, t } = turnwise;
  const dialog = page.getByRole("dialog", { name: words.title, exact: true });
  const open = dialog.getByRole("button", { name: words.open, exact: true });
  const ask = () => turnwise.menus.choose("program", t.page.text.turnRound);
  const allowance = dialog.getByRole("textbox", { name: words.allowance("mm"), exact: true });

  await start.beginWithExample(812);
  await effect.proved();
  await ask();
  await expect(dialog).toContainText("SHOULDER812_2");
  await expect(dialog).toContainText("⌀75 × 100 mm");
  await expectAccessibleAndFits(page);
  await allowance.fill("-1");
  await expect(open).toBeDisabled();
  await expect(dialog).toContainText(words.allowanceWrong("100 mm"));
  await allowance.fill("1.5");
  await open.click();
  await expect(editor.text).toContainText("BLK FORM ROTATION Z DIM_D LBL 1");
  await expect(editor.text).toContainText("Z+1.5");
  const next = page.url();

  // The first one stays as it was.
  await page.goBack();
  await expect(page).not.toHaveURL(next);
  await effect.proved();
  await page.goForward();
  await expect(editor.text).toContainText("BEGIN PGM SHOULDER812_2 MM");

  // Turned around again, it is the third clamping.
  await ask();
  await expect(dialog).toContainText("SHOULDER812_3");

  // After parting off, choose bar or part to turn around; the dialog fits a phone.
  await page.keyboard.press("Escape");
  await page.getByRole("link", { name: t.page.home, exact: true }).click();
  await page.setViewportSize({ width: 390, height: 664 });
  await editor.paste(await readFile("tests/shop/bush.h", "utf8"));
  await expect(page.getByText(t.findings.verdict.proved).first()).toBeVisible();
  await editor.show("text");
  await turnwise.menus.choose("program", t.page.text.turnRound);
  await expect(dialog.getByRole("radio", { name: words.off("⌀56 × 40 mm"), exact: true })).toBeChecked();
  await expectAccessibleAndFits(page);
  await dialog.getByRole("button", { name: words.open, exact: true }).click();
  await expect(editor.text).toContainText("BEGIN PGM BUSH_56_2 MM");
  await expectAccessibleAndFits(page);
});

test("a program with errors leaves no part to turn around, and the dialog says why", async ({ page }) => {
  const turnwise = await Turnwise.open(page, { language: "de" });
  const { editor, t } = turnwise;
  await editor.paste(
    "0 BEGIN PGM A MM\n1 BLK FORM CYLINDER Z D40 L60\n2 FUNCTION MODE TURN\n3 TOOL CALL 99\n4 M30\n5 END PGM A MM\n",
  );
  await turnwise.menus.choose("program", t.page.text.turnRound);
  const dialog = page.getByRole("dialog", { name: de.title, exact: true });
  await expect(dialog.getByRole("status")).toHaveText(de.lack.faults);
  await expect(dialog.getByRole("button", { name: de.open, exact: true })).toBeDisabled();
  await expectAccessibleAndFits(page);
});
