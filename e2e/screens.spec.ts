import { onDevices } from "./pages/devices.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

/* Few tests with many screens each: checking a screen takes less time than reaching it. */

/* On a tablet these look as in a large window; start.spec.ts has the start in its sizes. */
onDevices(["desktop", "phone"], (expectFineHere) => {
  test("the start, the settings and the files of a work pass axe, and fit", async ({ page }) => {
    const turnwise = await Turnwise.open(page);
    const { editor, settings, start } = turnwise;
    await expect(start.search).toBeVisible();
    await expectFineHere(page, "the start");
    await settings.open();
    await expectFineHere(page, "the settings");
    await page.keyboard.press("Escape");
    await editor.drop({
      "MAIN.h": "BEGIN PGM MAIN MM\nCALL PGM CUT\n/CALL PGM AWAY\nM30\n",
      "cut.h": "BEGIN PGM CUT MM\nL X+1\n",
    });
    await editor.show("text");
    await expect(editor.leaveOut).toBeVisible();
    await expect(editor.files.getByText("AWAY.H")).toBeVisible();
    await expectFineHere(page, "the files of a work");
  });
});

onDevices(["desktop", "tablet", "phone"], (expectFineHere) => {
  test("the panels and prompts of a workplace pass axe, and fit", async ({ page }) => {
    const turnwise = await Turnwise.open(page);
    const { dialog, effect, start, t } = turnwise;
    await start.beginWithExample(820);
    await effect.proved();
    await expectFineHere(page, "the workplace");
    for (const section of ["setup", "contour", "findings", "program", "prompts"] as const) {
      await turnwise.show(section);
      await expectFineHere(page, `the panel "${section}"`);
    }
    await dialog.open("Q463");
    await dialog.type("nothing");
    await expect(dialog.messages).not.toBeEmpty();
    await expectFineHere(page, "a value that is wrong");
    await dialog.type("3");
    await dialog.open("Q215");
    await expectFineHere(page, "a choice");
    await page.keyboard.press("End");
    await expect(dialog.question).toHaveText(t.dialog.done.title);
    await expectFineHere(page, "the end of the dialog");
  });
});
