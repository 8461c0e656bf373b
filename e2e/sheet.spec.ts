import { readFileSync } from "node:fs";
import { compare } from "../src/i18n/en/compare.ts";
import { expectAccessible, expectFineInBothThemes } from "./pages/layout-checks.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

test("the setup sheet of a program: contents, saved remarks, pages; of one in inches", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { editor, menus, sheet, t } = turnwise;
  await editor.openExample("flange");
  await expect(editor.total(t.editor.operations)).toHaveText("8");
  await sheet.open();
  const { preview, words } = sheet;
  await expect(preview.getByRole("heading", { level: 1, name: "FLANGE" })).toBeVisible();
  await expect(preview.getByRole("img", { name: words.drawingOf("FLANGE") })).toContainText("⌀62");
  await expect(preview).toContainText(words.scale(1, 2));
  await expect(preview.getByRole("row", { name: /GROOVE IN THE FACE.*T8.*X⌀51 Z\+2.*VC 140/ })).toBeVisible();
  await expect(preview.getByRole("row", { name: /CNMG-80-R08/ })).toContainText("M303");
  await expectFineInBothThemes(page, "the setup sheet");

  await sheet.remarks.fill("Soft jaws, bored to 100.2\nCheck 62 h6");
  await expect(preview).toContainText("Check 62 h6");
  await turnwise.undo();
  await expect(sheet.remarks).toHaveValue("");
  await turnwise.redo();
  await expect(sheet.remarks).toHaveValue(/Soft jaws/);
  await page.reload();
  await expect(sheet.remarks).toHaveValue("Soft jaws, bored to 100.2\nCheck 62 h6");

  await expect(preview.getByRole("row", { name: words.total })).toContainText("4 min");
  await sheet.paper.selectOption("a4");
  expect(await sheet.printed()).toEqual({ pages: 3, size: [595, 842] });
  await sheet.withProgram.uncheck();
  expect((await sheet.printed()).pages).toBe(1);
  await sheet.paper.selectOption("letter");
  expect((await sheet.printed()).size).toEqual([612, 792]);

  await page.emulateMedia({ media: "print" });
  await expect(preview).toBeVisible();
  await expect(sheet.remarks).toBeHidden();
  await expect(page.getByRole("button")).toHaveCount(0);
  await page.emulateMedia({ media: "screen" });
  await page.goBack();
  await expect(editor.total(t.editor.operations)).toHaveText("8");

  // The setup sheet of an inch program is in inches, its tools in mm; so are the effects in a comparison.
  await page.getByRole("link", { name: t.page.home, exact: true }).click();
  const text = readFileSync("tests/programs/shoulder-inch.h", "utf8");
  await editor.openFile("SHOULDER.h", Buffer.from(text));
  await sheet.open();
  await expect(preview).toContainText(words.inch);
  await expect(preview.getByRole("img", { name: words.drawingOf("SHOULDER_INCH") })).toContainText("⌀2.338");
  await expect(preview).toContainText("⌀2.9528 × 3.937");
  await expect(
    preview.getByRole("row", { name: /812.*T1.*X⌀2\.9528 Z\+0\.0787.*0\.0118 \/ 0\.0079 inch\/rev/ }),
  ).toBeVisible();
  await expect(preview.getByRole("row", { name: /CNMG-80-R08.*RS 0\.8/ })).toBeVisible();
  await sheet.close();

  await page.evaluate((copied) => navigator.clipboard.writeText(copied), text.replace("Q463=+0.1181", "Q463=+0.05"));
  await menus.choose("program", t.page.text.compare);
  const dialog = page.getByRole("dialog", { name: compare.title, exact: true });
  await dialog.getByRole("button", { name: compare.clipboard, exact: true }).click();
  await expect(
    dialog.getByText(new RegExp(String.raw`${compare.effects.infeed} 0\.0\d+ inch → 0\.\d+ inch`)).first(),
  ).toBeVisible();
});

test("the sheet of a cycle, in German on a phone; a program with errors is marked; the workplace prints its program", async ({
  page,
}) => {
  const turnwise = await Turnwise.open(page, { language: "de" });
  const { dialog, effect, sheet } = turnwise;
  await turnwise.start.beginWithExample(812);
  await effect.proved();
  const printed = await page.pdf({ preferCSSPageSize: true });
  expect(printed.byteLength).toBeGreaterThan(10_000);
  await sheet.open();
  await expect(sheet.preview).toContainText(sheet.words.stamp.good);
  await page.setViewportSize({ width: 390, height: 844 });
  await expectAccessible(page);
  expect(
    await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth),
  ).toBeLessThanOrEqual(0);
  await page.setViewportSize({ width: 1280, height: 800 });
  await sheet.withProgram.uncheck();
  expect((await sheet.printed()).pages).toBe(1);
  await sheet.close();
  await dialog.set("Q494", "+55");
  await sheet.open();
  await expect(sheet.preview.getByRole("heading", { name: sheet.words.stamp.faults })).toBeVisible();
});
