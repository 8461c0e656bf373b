import { expect, test } from "./pages/test.ts";
import { LANGUAGES } from "../src/i18n/languages.ts";
import { Turnwise } from "./pages/turnwise.ts";

for (const language of LANGUAGES) {
  test(`the way to a program in ${language}`, async ({ page }) => {
    const turnwise = await Turnwise.open(page, { language });
    const { dialog, effect, lathe, program } = turnwise;
    await expect(page.locator("html")).toHaveAttribute("lang", language);
    await turnwise.start.beginWithExample(812);
    await expect(dialog.question).toHaveText(dialog.promptOf(812, "Q215"));
    await dialog.set("Q463", language === "de" || language === "fr" ? "2,4" : "2.4");
    await effect.proved();
    await expect(lathe.picture).toBeVisible();
    await dialog.open("Q493");
    await dialog.type("x");
    await expect(dialog.messages).not.toBeEmpty();
    await page.keyboard.press("Escape");
    await program.chooseLabels(language);
    expect(await program.copy()).toContain("Q463=+2.4 ");
    await expect(program.confirmation).toBeVisible();
    await page.reload();
    await expect(page.locator("html")).toHaveAttribute("lang", language);
    await expect(dialog.line("Q463")).toContainText(language === "de" || language === "fr" ? "2,4" : "2.4");
  });
}
