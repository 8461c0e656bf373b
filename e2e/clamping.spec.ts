import { readFile } from "node:fs/promises";
import { provedIn } from "./pages/effect.ts";
import { expectAccessibleAndFits, expectFineInBothThemes } from "./pages/layout-checks.ts";
import { pictureAt } from "./pages/picture.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

/** The message about a contact with the jaws. */
const CONTACT = "The tool collides with the jaws";

/** Classifies the pixel at a spot of the picture: Z, and X as a diameter. */
async function spot({ page, lathe, t }: Turnwise, z: number, x: number): Promise<string> {
  const at = await pictureAt(page, lathe.view.getByRole("group", { name: t.lathe.title, exact: true }), z, x);
  return (await page.screenshot({ clip: { x: at.x - 1, y: at.y - 1, width: 2, height: 2 } })).toString("base64");
}

test("clamping of a work: set, drawn to scale, collision at its block, corrected until verified, saved and printed", async ({
  page,
}) => {
  const turnwise = await Turnwise.open(page);
  const { clamping, dialog, effect, findings, lathe, program, sheet, t } = turnwise,
    c = clamping.words;
  await turnwise.start.beginWithExample(812);
  await effect.proved();
  await expect(lathe.view).toContainText(t.lathe.held.note);
  await turnwise.show("setup");
  await expect(page.getByText(c.unstated)).toBeVisible();
  await sheet.open();
  await expect(sheet.preview).toContainText(sheet.words.chuckNote);
  await sheet.close();

  await turnwise.show("setup");
  await clamping.state.click();
  await expect(clamping.kind).toHaveValue("chuckOutside");
  await expect(clamping.field("D")).toHaveValue("75");
  await expect(clamping.field("FACE")).toHaveValue("-75");
  await expect(program.panel).toContainText("; CLAMPING CHUCK OUTSIDE D75 LENGTH25 FACE-75 SIZE160");
  await effect.proved();
  await expect(lathe.view).not.toContainText(t.lathe.held.note);
  await expectFineInBothThemes(page, "set-up with a clamping");
  // To scale: the jaws begin at Z-75, beside the bar.
  const steel = await spot(turnwise, -82, 92);
  expect(await spot(turnwise, -76, 92)).toBe(steel);
  expect(await spot(turnwise, -74, 92)).not.toBe(steel);
  expect(await spot(turnwise, -64, 92)).not.toBe(steel);

  // The tailstock switch precedes its fields, and these precede the limits.
  await clamping.tailstock.check();
  const top = async (of: typeof clamping.tailstock) => (await of.boundingBox())?.y ?? 0;
  const tops = [await top(clamping.tailstock), await top(clamping.field("QUILL")), await top(clamping.field("LIMITZ"))];
  expect(tops).toEqual(tops.toSorted((a, b) => a - b));
  await clamping.tailstock.uncheck();

  // Jaws that reach over the turned length.
  await clamping.field("FACE").fill("-50");
  await clamping.field("LENGTH").fill("50");
  await expect(effect.cell("proof")).not.toHaveText(provedIn(t));
  await expect.poll(() => spot(turnwise, -64, 92)).toBe(steel);
  await turnwise.show("findings");
  const contact = findings.items.filter({ hasText: CONTACT });
  await expect(contact).toContainText("block 10");
  await expectAccessibleAndFits(page);
  await turnwise.show("prompts");
  await dialog.set("Q494", "-40");
  await effect.proved();
  await page.reload();
  await effect.proved();
  await expect(program.panel).toContainText("D75 LENGTH50 FACE-50 SIZE160");

  await sheet.open();
  await expect(sheet.preview).toContainText(`${c.kinds.chuckOutside}`);
  await expect(sheet.preview.getByText(`${c.words.FACE} −50`, { exact: true })).toBeVisible();
  await expect(sheet.preview.getByText(`${c.words.SIZE} 160`, { exact: true })).toBeVisible();
  await expect(sheet.preview).not.toContainText(sheet.words.chuckNote);
  await expectFineInBothThemes(page, "the setup sheet with a clamping");
});

test("the clamping of a program is a comment: written by its dialog, carried by a link, saved", async ({
  page,
  browser,
}) => {
  const turnwise = await Turnwise.open(page);
  const { clamping, editor, findings, lathe, t } = turnwise,
    c = clamping.words;
  const verdict = editor.total(t.findings.verdict.title);
  const bar = (await readFile("tests/cases/clamped-bar.h", "utf8")).replace("Q494=-80", "Q494=-50");
  await editor.paste(bar.replace(/; CLAMPING.*\n/, ""));
  await expect(verdict).toHaveText(provedIn(t));
  await clamping.openDialog();
  await expect(clamping.dialog).toContainText(c.unstated);
  await expectAccessibleAndFits(page);
  await clamping.state.click();
  await expect(clamping.field("FACE")).toHaveValue("-60");
  await expectFineInBothThemes(page, "the dialog of a clamping");
  await clamping.field("FACE").fill("-45");
  await page.keyboard.press("Escape");
  await expect(editor.text).toContainText("; CLAMPING CHUCK OUTSIDE D30 LENGTH20 FACE-45 SIZE160");
  await expect(verdict).not.toHaveText(provedIn(t));
  await editor.show("findings");
  await expect(findings.items.filter({ hasText: CONTACT })).toContainText("block 10");
  await expectAccessibleAndFits(page);

  await clamping.openDialog();
  await clamping.field("FACE").fill("-60");
  await page.keyboard.press("Escape");
  await expect(verdict).toHaveText(provedIn(t));
  await lathe.shows("solid");
  await expectAccessibleAndFits(page);
  await page.reload();
  await expect(editor.text).toContainText("; CLAMPING CHUCK OUTSIDE D30 LENGTH20 FACE-60 SIZE160");

  const link = await editor.sharedLink();
  const other = await browser.newContext({ hasTouch: true }),
    receiver = await other.newPage();
  await receiver.goto(link);
  const received = Turnwise.at(receiver);
  await received.sharing.open();
  await expect(received.editor.text).toContainText("; CLAMPING CHUCK OUTSIDE D30 LENGTH20 FACE-60 SIZE160");
  await received.clamping.openDialog();
  await expect(received.clamping.field("D")).toHaveValue("30");
  await receiver.setViewportSize({ width: 390, height: 664 });
  await received.editor.show("text");
  await received.clamping.openDialog();
  await expectAccessibleAndFits(receiver);
  // The keypad is open at the bottom; the next tap still reaches its target.
  await received.clamping.field("SIZE").tap();
  await expect(receiver.getByRole("group", { name: t.dialog.keypad, exact: true })).toBeVisible();
  await received.clamping.tailstock.tap();
  await expect(received.clamping.tailstock).toBeChecked();
  await other.close();
});
