import { expectFineInBothThemes } from "./pages/layout-checks.ts";
import { expect, test } from "./pages/test.ts";
import { provedIn } from "./pages/effect.ts";
import { Turnwise } from "./pages/turnwise.ts";

const STRANGE =
  "1  BEGIN PGM ALT MM\r\n2 L  X+50 Z+2 FMAX ; nach vorn \xd8\r\n\r\n77 UNBEKANNT 5\r\n4 M30\r\n5 END PGM ALT MM";

test("a file keeps its bytes; blocks are inserted, moved and deleted by dialog; an unknown one hides nothing", async ({
  page,
}) => {
  const { editor, t } = await Turnwise.open(page);
  const bytes = Buffer.from(STRANGE, "latin1");
  await editor.openFile("ALT.H", bytes);
  expect(await editor.downloaded()).toEqual(bytes);
  await editor.line("X+50").click();
  await editor.show("block");
  await expect(editor.heading).toContainText("2");
  await editor.field("x").fill("52.5");
  expect(await editor.downloaded()).toEqual(Buffer.from(STRANGE.replace("X+50", "X+52.5"), "latin1"));

  // Blocks are inserted, duplicated, moved and deleted by dialog.
  await page.getByRole("link", { name: t.page.home, exact: true }).click();
  await editor.paste("0 BEGIN PGM A MM\n1 L X+10\n2 M30\n3 END PGM A MM\n");
  await editor.line("L X+10").click();
  await editor.show("block");
  await editor.insert("structure");
  await editor.field("text").fill("PART");
  await editor.tool("duplicate").click();
  await editor.tool("up").click();
  await editor.tool("up").click();
  expect((await editor.downloaded()).toString()).toBe(
    "0 BEGIN PGM A MM\n1 * - PART\n2 L X+10\n3 * - PART\n4 M30\n5 END PGM A MM\n",
  );
  await editor.tool("remove").click();
  expect((await editor.downloaded()).toString()).toBe(
    "0 BEGIN PGM A MM\n1 L X+10\n2 * - PART\n3 M30\n4 END PGM A MM\n",
  );

  // An unknown block is marked in the margin and hides nothing after it.
  await page.getByRole("link", { name: t.page.home, exact: true }).click();
  await editor.paste(
    "0 BEGIN PGM A MM\n1 STRANGE WORDS\n2 FUNCTION MODE TURN\n3 TOOL CALL 1\n4 L X+10 Z+2 F0.2\n5 M30\n6 END PGM A MM\n",
  );
  await editor.show("findings");
  const notUnderstood = t.messages.of.notUnderstood({ text: "STRANGE WORDS" }, { text: (x: string) => x } as never);
  await expect(
    page.getByText(t.messages.of.notProved({ what: "STRANGE WORDS" }, { text: (x: string) => x } as never)).first(),
  ).toBeVisible();
  await expect(page.locator(".cm-lint-marker").first()).toBeVisible();
  await page
    .getByRole("button", { name: t.findings.goTo(t.findings.inBlock("1")), exact: true })
    .first()
    .click();
  await expect(page.getByRole("form").getByText(notUnderstood)).toBeVisible();
});

test("the default program runs clean, its parts lead to their blocks, pass axe, and fit", async ({ page }) => {
  const { editor, t } = await Turnwise.open(page);
  await editor.openExample("flange");
  await expect(editor.total(t.findings.verdict.title)).toHaveText(provedIn(t));
  await expect(editor.total(t.editor.operations)).toHaveText("8");
  await expect(editor.total(t.editor.toolChanges)).toHaveText("6");
  await editor.show("structure");
  await expect(editor.operation(8)).toContainText(t.editor.noResidue);
  await editor.filter("all");
  await expect(editor.part("CYCL DEF 852")).toContainText(t.editor.noResidue);
  await editor.part("TOOL CALL 15").click();
  await editor.show("block");
  await expect(editor.field("tool")).toHaveValue("15");

  // The parts of the program editor pass axe, and fit.
  await expect(editor.total(t.findings.verdict.title)).not.toHaveText(t.page.effect.unknown);
  // The page's own styles outweigh those of CodeMirror, which has them in a sheet that comes later.
  await editor.show("text");
  await expect(page.locator(".cm-line").first()).not.toHaveCSS("text-indent", "0px");
  for (const section of ["text", "block", "structure", "findings"] as const) {
    await editor.show(section);
    await expectFineInBothThemes(page, `the part "${section}"`);
  }
});

test("typing and dialog make the same edit; programs and the tool table have histories of their own", async ({
  page,
}) => {
  const turnwise = await Turnwise.open(page);
  const { editor, dialog, tools, t } = turnwise;
  await editor.openExample("shoulder");
  await expect(editor.total(t.page.effect.passes)).toHaveText("5");
  await editor.line("Q463=").click();
  await editor.show("block");
  await dialog.open("Q463");
  await dialog.value.fill("2.4");
  await expect(editor.line("Q463=+2.4")).toBeVisible();
  await expect(editor.total(t.page.effect.passes)).toHaveText("6");
  await editor.line("CYCL CALL").click();
  await page.keyboard.press("End");
  await page.keyboard.type(" ;NOW");
  await expect(editor.line("CYCL CALL ;NOW")).toBeVisible();
  await turnwise.undo();
  await expect(editor.line(";NOW")).toHaveCount(0);
  await turnwise.undo();
  await expect(editor.line("Q463=+3")).toBeVisible();
  await expect(editor.total(t.page.effect.passes)).toHaveText("5");
  await turnwise.redo();
  await expect(editor.line("Q463=+2.4")).toBeVisible();

  // Each program and the tool table have a history of their own, and undo says what it takes back.
  await turnwise.undo();
  await expect(editor.line("Q463=+3")).toBeVisible();
  const undo = turnwise.historyButton("undo"),
    redo = turnwise.historyButton("redo");
  await editor.line("Q463=").click();
  await editor.show("block");
  await turnwise.dialog.open("Q463");
  await turnwise.dialog.value.fill("2.4");
  await expect(undo).toHaveAccessibleName(/Q463 3 → 2\.4$/);
  await editor.line("CYCL CALL").click();
  await page.keyboard.press("End");
  await page.keyboard.type(" ;LAST");
  await tools.open();
  await expect(undo).toBeDisabled();
  await tools.rowButton(3).click();
  await tools.cell("RS").fill("1.2");
  await expect(undo).toHaveAccessibleName(/3: RS 0\.4 → 1\.2$/);
  await tools.close();
  await page.getByRole("button", { name: t.page.newProgram }).click();
  await page
    .getByRole("dialog", { name: t.operations.newProgram })
    .getByRole("button", { name: t.operations.cancel })
    .click();
  await expect(editor.line("CYCL CALL ;LAST")).toBeVisible();
  await editor.create("top");
  await expect(editor.line("CYCL CALL")).toHaveCount(0);
  await expect(undo).toBeDisabled();
  await page.goBack();
  await expect(editor.line("CYCL CALL ;LAST")).toBeVisible();
  await turnwise.undo();
  await expect(editor.line("LAST")).toHaveCount(0);
  await turnwise.undo();
  await expect(editor.line("Q463=+3")).toBeVisible();
  await expect(undo).toBeDisabled();
  await expect(redo).toHaveAccessibleName(/Q463 3 → 2\.4$/);
  await tools.open();
  await expect(tools.cell("RS")).toHaveValue("1.2");
  await page.keyboard.press("Control+z");
  await expect(tools.cell("RS")).toHaveValue("0.4");
  await tools.close();
  await turnwise.redo();
  await expect(editor.line("Q463=+2.4")).toBeVisible();
});

test("a share link opens the same program, and a reload keeps what was typed", async ({ page, context }) => {
  const { editor } = await Turnwise.open(page);
  await editor.openExample("groove");
  const text = await editor.downloaded();
  const link = await editor.sharedLink();
  const other = Turnwise.at(await context.newPage());
  await other.page.goto(link);
  await other.sharing.open();
  await expect(other.editor.text).toBeVisible();
  expect(await other.editor.downloaded()).toEqual(text);
  await other.editor.line("M136").click();
  await other.page.keyboard.press("End");
  await other.page.keyboard.type(" ;KEPT");
  await other.page.reload();
  await expect(other.editor.line("M136 ;KEPT")).toBeVisible();
});
