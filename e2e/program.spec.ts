import { readFile } from "node:fs/promises";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

test("two layouts, and labels in a language of their own", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { program } = turnwise;
  await turnwise.start.beginWithExample(820);
  await program.chooseLabels("fr");
  await program.chooseLayout("tnc640");
  const older = await program.copy();
  expect(older).toContain("CYCL DEF 820  TOURN. CONT. TRANSV.");
  expect(older).not.toContain("~");
  await program.chooseLabels("zh");
  await program.chooseLayout("tnc7");
  await expect.poll(async () => (await program.shown()).join("\n")).toContain("CYCL DEF 820 TURN CONTOUR TRANSV. ~");
  expect(await program.copy()).toContain("Q463=+3 ;MAX. CUTTING DEPTH ~");
});

test("the download is the text on the screen, under the program's name", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { program } = turnwise;
  await turnwise.start.beginWithExample(812);
  await page.getByRole("textbox", { name: turnwise.t.page.text.name }).fill("WELLE7");
  const download = await program.download();
  expect(download.suggestedFilename()).toBe("WELLE7.h");
  const text = await readFile(await download.path(), "utf8");
  expect(text).toContain("BEGIN PGM WELLE7 MM");
  await expect.poll(() => program.shown()).toEqual(text.trimEnd().split(/\r?\n/).map((line) => line.trimEnd()));
});

test("where the clipboard is refused the text is offered, selected", async ({ page }) => {
  await page.addInitScript(() => {
    Object.defineProperty(navigator, "clipboard", { value: { writeText: () => Promise.reject(new Error("refused")) } });
    document.execCommand = () => false;
  });
  const turnwise = await Turnwise.open(page);
  await turnwise.start.beginWithExample(812);
  await turnwise.program.copyButton.click();
  const dialog = page.getByRole("dialog", { name: turnwise.t.page.text.refusedTitle });
  await expect(dialog).toBeVisible();
  await expect(dialog.getByRole("textbox")).toHaveValue(/END PGM/);
  await expect(dialog.getByRole("textbox")).toBeFocused();
  await dialog.getByRole("button", { name: turnwise.t.page.close }).click();
  await expect(dialog).toBeHidden();
});
