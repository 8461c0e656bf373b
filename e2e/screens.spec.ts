import type { Page } from "@playwright/test";
import { looksRight } from "./pages/look.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

/** The work of 820 with its printed example, proved. */
async function example(page: Page, theme: "light" | "dark"): Promise<Turnwise> {
  const turnwise = await Turnwise.open(page, { theme });
  await turnwise.start.beginWithExample(820);
  await turnwise.effect.proved();
  return turnwise;
}

/* One journey for each screen: looking at one takes axe seconds on a slow machine. */
for (const theme of ["light", "dark"] as const) {
  test(`the start passes axe in ${theme}, and fits`, async ({ page }) => {
    const turnwise = await Turnwise.open(page, { theme });
    await expect(turnwise.start.search).toBeVisible();
    await looksRight(page);
  });

  test(`the settings pass axe in ${theme}, and fit`, async ({ page }) => {
    const turnwise = await Turnwise.open(page, { theme });
    await turnwise.settings.open();
    await looksRight(page);
  });

  test(`the workplace passes axe in ${theme}, and fits`, async ({ page }) => {
    await example(page, theme);
    await looksRight(page);
  });

  test(`a value that is wrong passes axe in ${theme}, and fits`, async ({ page }) => {
    const { dialog } = await example(page, theme);
    await dialog.open("Q463");
    await dialog.type("nothing");
    await expect(dialog.messages).not.toBeEmpty();
    await looksRight(page);
  });

  for (const section of ["setup", "contour", "findings", "program", "prompts"] as const)
    test(`the panel "${section}" passes axe in ${theme}, and fits`, async ({ page }) => {
      const turnwise = await example(page, theme);
      await turnwise.show(section);
      await looksRight(page);
    });

  test(`the files of a work pass axe in ${theme}, and fit`, async ({ page }) => {
    const { editor } = await Turnwise.open(page, { theme });
    await editor.drop({ "MAIN.h": "BEGIN PGM MAIN MM\nCALL PGM CUT\n/CALL PGM AWAY\nM30\n", "cut.h": "BEGIN PGM CUT MM\nL X+1\n" });
    await editor.show("text");
    await expect(editor.leaveOut).toBeVisible();
    await expect(editor.files.getByText("AWAY.H")).toBeVisible();
    await looksRight(page);
  });

  test(`a choice passes axe in ${theme}, and fits`, async ({ page }) => {
    const { dialog } = await example(page, theme);
    await dialog.open("Q215");
    await looksRight(page);
  });

  test(`the end of the dialog passes axe in ${theme}, and fits`, async ({ page }) => {
    const { dialog, t } = await example(page, theme);
    await dialog.open("Q215");
    await page.keyboard.press("End");
    await expect(dialog.question).toHaveText(t.dialog.done.title);
    await looksRight(page);
  });
}
