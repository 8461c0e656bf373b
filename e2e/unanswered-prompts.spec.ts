import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

test("a groove from empty prompts: after each value the picture shows what is known so far, with the typed numbers", async ({
  page,
}) => {
  const turnwise = await Turnwise.open(page);
  const { dialog, t } = turnwise;
  await turnwise.start.button(852, false).click();
  const lathe = turnwise.lathe.picture;
  const help = page.getByRole("img", { name: /852/ }).first();
  const known = async (...said: string[]) => {
    for (const each of said) await expect(lathe).toHaveAccessibleName(new RegExp(each.replace(/[.()]/g, "\\$&")));
  };
  const answer = async (text: string) => {
    await page.keyboard.type(text);
    await page.keyboard.press("Enter");
  };

  await known(t.lathe.known.nothing);
  await expect(help).toHaveAccessibleName(new RegExp(t.help.partial.replace(".", "\\.")));
  // The set-up is asked first; accept its proposals.
  await dialog.open("Q215");
  await expect(dialog.line("Q460")).toHaveAccessibleName(new RegExp(t.dialog.idle));

  await answer("0");
  await expect(dialog.question).toHaveText(dialog.promptOf(852, "Q491"));
  await expect(help.locator("text", { hasText: /^Q491$/ })).toBeVisible();
  await answer("61.37");
  await known("Q491 ⌀61.37");
  await expect(help.locator("text", { hasText: "⌀61.37" })).toBeVisible();
  await answer("0");
  await answer("42.11");
  await answer("-12.5");
  await known("Q491 ⌀61.37", "Q492 Z0", "Q493 ⌀42.11", "Q494 Z-12.5", t.lathe.known.sketch);

  for (const value of ["4", "0"]) await answer(value);
  await expect(dialog.question).toHaveText(dialog.promptOf(852, "Q500"));
  await answer("1.2");
  await answer("3");
  await answer("0");
  await expect(dialog.question).toHaveText(dialog.promptOf(852, "Q478"));
  await known(t.lathe.known.whole);
  await expect(help.locator("text", { hasText: "⌀75" })).toHaveCount(0);

  await dialog.set("Q493", "61.37");
  await expect(help).toHaveAccessibleName(new RegExp(t.help.stale.replace(".", "\\.")));
  await known("Q493 ⌀61.37");
});
