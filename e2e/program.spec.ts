import { readFile } from "node:fs/promises";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";
import { expectAccessibleAndFits } from "./pages/layout-checks.ts";
import { output } from "../src/i18n/en/output.ts";

const UNTIED =
  "0 BEGIN PGM OLD MM\n1 BLK FORM CYLINDER Z D75 L100\n2 CYCL DEF 811  X\nQ215=+0 ;A\nQ460=+2 ;B\n3 M30\n4 END PGM OLD MM\n";

test("files of both controls, labels in a language of their own, and the text if the clipboard is refused", async ({
  page,
}) => {
  const turnwise = await Turnwise.open(page);
  const { program } = turnwise;
  await turnwise.start.beginWithExample(820);
  await program.chooseLabels("fr");
  await expect(program.fileNote).toContainText(turnwise.t.page.text.files.tnc640);
  expect(await program.copy()).toContain("CYCL DEF 820  TOURN. CONT. TRANSV. ~");
  await expect(program.confirmation).toContainText(turnwise.t.page.text.files.tnc640);
  await program.chooseLabels("zh");
  await program.chooseLayout("tnc7");
  await expect.poll(async () => (await program.shown()).join("\n")).toContain("CYCL DEF 820 TURN CONTOUR TRANSV. ~");
  await expect(program.fileNote).toContainText(turnwise.t.page.text.files.tnc7);
  expect(await program.copy()).toContain("Q463=+3 ;MAX. CUTTING DEPTH ~");

  // If the clipboard is refused, the text is offered, selected.
  await page.evaluate(() => {
    Object.defineProperty(navigator, "clipboard", { value: { writeText: () => Promise.reject(new Error("refused")) } });
    document.execCommand = () => false;
  });
  await program.copyButton.click();
  const dialog = page.getByRole("dialog", { name: turnwise.t.page.text.refusedTitle });
  await expect(dialog).toBeVisible();
  await expect(dialog.getByRole("textbox")).toHaveValue(/END PGM/);
  await expect(dialog.getByRole("textbox")).toBeFocused();
  await dialog.getByRole("button", { name: turnwise.t.page.close }).click();
  await expect(dialog).toBeHidden();
});

test("the printed form is a view; the download is the text on the screen; DIN/ISO runs the same", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { editor, program, sheet, t } = turnwise;
  await turnwise.start.beginWithExample(812);
  await program.chooseLayout("manual");
  await expect.poll(async () => (await program.shown()).join("\n")).not.toContain("~");
  await expect(program.fileNote).toContainText(t.page.text.manualView);
  expect(await program.copy()).toContain("CYCL DEF 812  SHOULDER, LONG. EXT. ~");
  expect(await readFile(await (await program.download()).path(), "utf8")).toContain("Q215=+0 ;MACHINING OPERATION ~");
  await expectAccessibleAndFits(page);
  // Selecting and copying the whole program gives the file, too.
  await page.evaluate(() => navigator.clipboard.writeText(""));
  await program.blocks.first().click();
  await page.evaluate(() => getSelection()?.selectAllChildren(document.querySelector(".program-text") as Element));
  await page.keyboard.press("ControlOrMeta+c");
  expect(await program.clipboard()).toContain("CYCL DEF 812  SHOULDER, LONG. EXT. ~");
  await page.getByRole("button", { name: t.page.text.showFile, exact: true }).click();
  await expect.poll(async () => (await program.shown()).join("\n")).toContain("~");

  // The download is the text on the screen, under the program's name.
  await page.getByRole("textbox", { name: t.page.text.name }).fill("WELLE7");
  const named = await program.download();
  expect(named.suggestedFilename()).toBe("WELLE7.h");
  const shown = await readFile(await named.path(), "utf8");
  expect(shown).toContain("BEGIN PGM WELLE7 MM");
  await expect
    .poll(() => program.shown())
    .toEqual(
      shown
        .trimEnd()
        .split(/\r?\n/)
        .map((line) => line.trimEnd()),
    );

  // DIN/ISO: shown, copied and downloaded alike; reopened, it runs the same.
  await program.chooseLayout("iso");
  await expect.poll(async () => (await program.shown()).join("\n")).toContain("G812 Q215=+0");
  await expect(program.fileNote).toContainText(t.page.text.isoUnverified);
  await expectAccessibleAndFits(page);
  const download = await program.download();
  expect(download.suggestedFilename()).toBe("WELLE7.i");
  const text = await readFile(await download.path(), "utf8");
  expect(text).toMatch(/^%WELLE7 G71 \*\n/);
  await expect.poll(() => program.shown()).toEqual(text.trimEnd().split("\n"));
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  await expect(page.locator(".printed-program")).toHaveText(text);
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
  await sheet.open();
  await expect(sheet.preview).toContainText("G812 Q215=+0");
  await sheet.close();
  await page.getByRole("link", { name: t.page.home }).click();
  await editor.pasteOnPage(text);
  await expect(page.locator(".panel-structure :focus, .panel-structure:focus")).toHaveCount(1);
  await expect(page.getByText(t.page.notice.isoRead)).toBeVisible();
  await expect(editor.total(t.findings.verdict.title)).toContainText(t.findings.verdict.proved);
  const again = page.waitForEvent("download");
  await turnwise.menus.choose("export", t.page.text.asIso);
  expect(await readFile(await (await again).path(), "utf8")).toBe(text);

  // A program in the printed form of the manual is reported as no NC file, and one click adds its ~.
  await page.getByRole("link", { name: t.page.home, exact: true }).click();
  await editor.paste(UNTIED);
  await expect(program.fileNote).toContainText(t.page.text.untied);
  await expectAccessibleAndFits(page);
  await program.fileNote.getByRole("button", { name: t.page.text.tie, exact: true }).click();
  await expect(program.fileNote).toContainText(t.page.text.files.tnc640);
  expect(await program.copy()).toContain("CYCL DEF 811  X ~\nQ215=+0 ;A ~\nQ460=+2 ;B\n");
});

test("machine functions, line ends and name stay with the work", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { program, t } = turnwise;
  await turnwise.start.beginWithExample(811);
  await turnwise.menus.choose("program", t.page.text.output);
  const dialog = page.getByRole("dialog", { name: output.title, exact: true });
  await dialog.getByRole("combobox", { name: output.preset, exact: true }).selectOption("transfer");
  await dialog.getByRole("textbox", { name: output.spindleOn, exact: true }).fill("403");
  await expect(dialog.getByRole("combobox", { name: output.preset, exact: true })).toHaveValue("own");
  await dialog.getByRole("textbox", { name: output.spindleOn, exact: true }).fill("4030");
  await expect(dialog.getByText(output.functionWrong)).toBeVisible();
  await dialog.getByRole("combobox", { name: output.retract, exact: true }).selectOption("limit");
  await expectAccessibleAndFits(page);
  await dialog.getByRole("button", { name: output.makeDefault, exact: true }).click();
  await dialog.getByRole("button", { name: t.page.close, exact: true }).click();
  const text = await program.copy();
  expect(text.startsWith("BEGIN PGM SHOULDER811 MM\r\n")).toBe(true);
  expect(text).toMatch(/FMAX {2}M403\r\nCYCL CALL\r\nM140 MB MAX\r\nM5\r\nM30\r\n/);
  // Pointing selects a block even in a file without numbers.
  await program.blocks.last().getByRole("code").click();
  await page.reload();
  await expect.poll(async () => (await program.shown()).join("\n")).toContain("M403");
  await page.getByRole("link", { name: t.page.home }).click();
  await turnwise.start.beginWithExample(821);
  await expect.poll(async () => (await program.shown()).join("\n")).toContain("M140 MB MAX");
});
