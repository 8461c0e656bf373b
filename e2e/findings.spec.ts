import { expectAccessibleAndFits } from "./pages/layout-checks.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

/**
 * A program whose only cycle is called in milling mode, with a tool that leaves residual material in a sharp corner.
 */
const MILLING = `0 BEGIN PGM FAULT MM
1 BLK FORM CYLINDER Z D61.3 L80 DIST+0
2 FUNCTION MODE MILL
3 TOOL CALL 1
4 FUNCTION TURNDATA SPIN VCONST:ON VC:180 SMAX2500
5 M136
6 L X+90 Z+40 R0 FMAX
7 CYCL DEF 812 SHOULDER, LONG. EXT. ~
Q215=+0 ~
Q460=+2.1 ~
Q491=+61.3 ~
Q492=+0 ~
Q493=+47.7 ~
Q494=-31.9 ~
Q495=+0 ~
Q501=+0 ~
Q502=+0 ~
Q500=+0 ~
Q496=+0 ~
Q503=+0 ~
Q504=+0 ~
Q463=+2.3 ~
Q478=+0.27 ~
Q483=+0.4 ~
Q484=+0.2 ~
Q505=+0.19 ~
Q506=+0
8 L X+61.3 Y+0 Z+2 FMAX M303
9 CYCL CALL
10 L Z+40 FMAX
11 M30
12 END PGM FAULT MM
`;

/** A cycle missing from the catalogue: it is kept, and everything after it is unverified. */
const KEPT = `0 BEGIN PGM KEPT MM
1 BLK FORM CYLINDER Z D60 L80 DIST+0
2 FUNCTION MODE TURN
3 TOOL CALL 1
4 L X+65 Z+2 FMAX
5 CYCL DEF 892 CHECK UNBALANCE~
Q450=+0
6 CYCL CALL
7 M30
8 END PGM KEPT MM
`;

test("what is unproved, and what has errors: said, asked before it leaves, repaired from the list", async ({
  page,
}) => {
  const { editor, findings, menus, sharing, t } = await Turnwise.open(page);
  await editor.paste(KEPT);
  const proof = editor.total(t.findings.verdict.title);
  await expect(proof).toContainText(t.findings.verdict.unproved);
  await expect(proof).toContainText("892");
  await expect(proof).not.toContainText(t.findings.verdict.proved);
  await editor.show("findings");
  await expect(findings.panel).toContainText(t.findings.verdict.unproved);
  await expect(findings.panel).toContainText("6");
  await expect(page.getByText(t.findings.verdict.proved)).toHaveCount(0);

  // A program with errors leaves only on confirmation; once the missing block is inserted from the list, nothing is asked.
  await page.getByRole("link", { name: t.page.home, exact: true }).click();
  await editor.paste(MILLING);
  await expect(editor.total(t.findings.verdict.title)).toContainText(t.findings.verdict.faults(1));
  const copy = page.getByRole("button", { name: new RegExp(`^${t.page.text.copyLong}`) });
  await page.evaluate(() => navigator.clipboard.writeText("as it was"));
  await copy.click();
  await expect(findings.question).toContainText("FUNCTION MODE TURN");
  await expectAccessibleAndFits(page);
  await findings.answer("cancel").click();
  await expect(findings.question).toBeHidden();
  expect(await page.evaluate(() => navigator.clipboard.readText())).toBe("as it was");
  await sharing.openDialog();
  await expect(findings.question).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(sharing.shareDialog).toBeHidden();
  await menus.choose("export", t.page.text.download("FAULT.h"));
  const download = page.waitForEvent("download");
  await findings.answer("download").click();
  expect((await download).suggestedFilename()).toBe("FAULT.h");
  await editor.text.click();
  await page.keyboard.press("ControlOrMeta+a");
  await page.keyboard.press("ControlOrMeta+c");
  await findings.answer("copy").click();
  await expect.poll(() => page.evaluate(() => navigator.clipboard.readText())).toContain("END PGM FAULT");
  await expect(page.getByRole("status").filter({ hasText: t.findings.leaving.withFaults(1) })).toBeVisible();
  await editor.show("findings");
  await expect(findings.items.first()).toContainText(t.findings.severities.error);
  await findings.button(t.findings.insert("FUNCTION MODE TURN")).click();
  await expect(editor.line("FUNCTION MODE TURN")).toBeVisible();
  await expect(findings.panel).not.toContainText(t.findings.severities.error);
  expect((await editor.downloaded()).toString()).toContain("FUNCTION MODE TURN");
});

test("residual material leads to its place and to a tool; a missing contour to the contour", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { contour, dialog, effect, findings, lathe, program, t } = turnwise;
  await turnwise.start.beginWithExample(812);
  await effect.proved();
  await dialog.set("Q500", "0");
  await expect(effect.findings).toContainText(t.findings.count(1));
  await effect.findings.click();
  await expect(findings.tab).toContainText("1");
  await expect(findings.items).toHaveCount(1);
  await findings.mark("A").click();
  await expect(lathe.mark("A")).toHaveAttribute("aria-pressed", "true");
  await expect(lathe.picture).toHaveAccessibleName(new RegExp(t.lathe.atEnd));
  await findings.button(t.findings.residue.ask).click();
  const take = findings.panel
    .getByRole("button", { name: new RegExp(`^${t.setup.tool.take(0).split("0")[0]}`) })
    .first();
  const tool = /\d+/.exec((await take.textContent()) ?? "")?.[0] ?? "";
  await take.click();
  await expect(program.blocks.filter({ hasText: `TOOL CALL ${tool}` })).toBeVisible();

  // With a missing contour the dialog does not report all prompts answered, and leads to the contour.
  await page.getByRole("link", { name: t.page.home, exact: true }).click();
  await turnwise.start.beginWithExample(820);
  await effect.proved();
  await turnwise.show("contour");
  await expect(contour.kind(1)).toBeVisible();
  const elements = page.getByRole("combobox", { name: new RegExp(`^${t.contour.kindOf(0).replace("0", "\\d+")}$`) });
  for (let left = (await elements.count()) - 1; left >= 0; left -= 1) {
    await contour.kind(1).press("ControlOrMeta+Delete");
    await expect(elements).toHaveCount(left);
  }
  await turnwise.show("prompts");
  await dialog.open("Q463");
  await page.keyboard.press("End");
  await expect(dialog.question).toHaveText(t.findings.done.contour);
  await expectAccessibleAndFits(page);
  await dialog.active.getByRole("button", { name: t.findings.done.toContour, exact: true }).click();
  await expect(contour.add).toBeVisible();
});
