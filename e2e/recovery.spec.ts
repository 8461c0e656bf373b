import { readFileSync } from "node:fs";
import { provedIn } from "./pages/effect.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

test("invalid input says what is wrong and which value works, and the picture stays", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { dialog, effect, lathe, t } = turnwise;
  await turnwise.start.beginWithExample(812);
  await effect.proved();
  const passes = await effect.cell("passes").textContent();

  await dialog.open("Q463");
  await dialog.type("3 mm");
  await expect(dialog.value).toHaveValue("3 mm");
  await expect(dialog.value).toHaveAttribute("aria-invalid", "true");
  await expect(dialog.messages).not.toBeEmpty();
  await expect(lathe.view).toContainText(t.lathe.outdated);
  await expect(effect.cell("passes")).toHaveText(passes ?? "");

  await dialog.type("2000");
  await expect(dialog.messages).toContainText("999.999");
  // The limit is shown, but the largest usual infeed is offered, as in a program: nobody would type the limit.
  await expect(dialog.messages.getByRole("button")).toHaveText(/ 5$/);
  await dialog.type("2.5");
  await expect(dialog.value).toHaveAttribute("aria-invalid", "false");

  await dialog.type("");
  await expect(dialog.messages).not.toBeEmpty();
  await page.keyboard.press("Escape");
  await expect(dialog.value).toHaveValue("3");
  await expect(effect.cell("passes")).toHaveText(passes ?? "");
  await expect(lathe.view).not.toContainText(t.lathe.outdated);
});

test("a half-typed block keeps the last valid picture, until it is completed or left", async ({ page }) => {
  const { editor, dialog, lathe, t } = await Turnwise.open(page);
  await editor.openFile("FLANGE.h", readFileSync("src/examples/flange.h"));
  const passes = editor.total(t.page.effect.passes),
    proved = editor.total(t.findings.verdict.title);
  await expect(passes).toHaveText(/^[1-9]\d$/);
  await expect(proved).toHaveText(provedIn(t));
  const all = (await passes.textContent()) ?? "";
  await editor.show("structure");
  await editor.operation(2).click();
  await editor.show("block");
  await dialog.open("Q463");
  for (const wrong of ["3 mm", "2000", "3*"]) {
    await dialog.value.fill(wrong);
    await expect(dialog.value).toHaveAttribute("aria-invalid", "true");
    await expect(lathe.view).toContainText(t.lathe.outdated);
    await expect(passes).toHaveText(all);
  }
  await dialog.value.fill("3");
  await expect(lathe.view).not.toContainText(t.lathe.outdated);
  await expect(passes).toHaveText(all);

  await editor.line("Q493=+62").click();
  // A long line has two rows: the second press goes to its beginning.
  for (let i = 0; i < 2; i += 1) await page.keyboard.press("Home");
  for (let i = 0; i < 6; i += 1) await page.keyboard.press("ArrowRight");
  // Deletes both digits at once: with one digit left the block would be valid, and drawn.
  for (let i = 0; i < 2; i += 1) await page.keyboard.press("Shift+ArrowRight");
  await page.keyboard.press("Delete");
  await expect(editor.line("Q493=+ ")).toBeVisible();
  await expect(lathe.view).toContainText(t.lathe.outdated);
  await expect(passes).toHaveText(all);
  await page.keyboard.type("61");
  await expect(lathe.view).not.toContainText(t.lathe.outdated);
  await page.keyboard.press("Backspace");
  await page.keyboard.press("Backspace");
  await expect(lathe.view).toContainText(t.lathe.outdated);
  await editor.line("TOOL CALL 1").first().click();
  await expect(lathe.view).not.toContainText(t.lathe.outdated);
  await expect(passes).not.toHaveText(all);
});

test("a half-typed word of an approach keeps the last valid picture too", async ({ page }) => {
  const { editor, dialog, t } = await Turnwise.open(page);
  await editor.openFile("PLATE.h", readFileSync("src/examples/plate.h"));
  await editor.line("APPR LT").click();
  await editor.show("block");
  await page.getByRole("button", { name: /^LEN / }).click();
  const outdated = page.getByText(t.lathe.outdated);
  await expect(outdated).toBeHidden();
  await dialog.value.fill("10*");
  await expect(outdated).toBeVisible();
  await dialog.value.fill("10");
  await expect(outdated).toBeHidden();
});

test("a start diameter equal to the end diameter is named at its prompt and in the list, and leads there", async ({
  page,
}) => {
  const turnwise = await Turnwise.open(page);
  const { dialog, findings, effect } = turnwise;
  await turnwise.start.beginWithExample(812);
  await dialog.set("Q493", "75");
  await effect.findings.click();
  await expect(findings.items.first()).toContainText(/Q49[13]/);
  await findings.items.first().getByRole("button").last().click();
  await expect(dialog.messages).not.toBeEmpty();
});

test("keys of the control: sign anywhere, NO ENT, END, undo and redo", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { dialog, t } = turnwise;
  await turnwise.start.beginWithExample(812);
  await dialog.open("Q494");
  await dialog.type("12-");
  await expect(dialog.value).toHaveValue("-12");
  await page.keyboard.press("-");
  await expect(dialog.value).toHaveValue("12");
  await page.keyboard.press("Escape");
  await dialog.open("Q500");
  await page.keyboard.press("Delete");
  await expect(dialog.line("Q500")).toContainText(t.dialog.noEntry);
  await expect(dialog.question).toHaveText(dialog.promptOf(812, "Q496"));
  await page.keyboard.press("End");
  await expect(dialog.question).toHaveText(t.dialog.done.title);
  await turnwise.undo();
  await expect(dialog.line("Q500")).toContainText("1.5");
  await turnwise.redo();
  await expect(dialog.line("Q500")).toContainText(t.dialog.noEntry);
});
