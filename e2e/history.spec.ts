import { expectAccessibleAndFits } from "./pages/layout-checks.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

test("Back and Forward walk through the places; undo goes on after a reload", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { t, start, dialog, editor, setup } = turnwise;
  const back = page.getByRole("button", { name: t.tools.backLong });
  await start.beginWithExample(812);
  await expect(dialog.question).toHaveText(dialog.promptOf(812, "Q215"));
  await turnwise.show("setup");
  await expect(setup.start("x")).toBeVisible();
  await page.getByRole("button", { name: t.page.tools.openLong }).click();
  await expect(page.getByRole("heading", { name: t.page.tools.title, level: 1 })).toBeVisible();
  await page.goBack();
  await expect(setup.start("x")).toBeVisible();
  await page.goBack();
  await expect(dialog.question).toHaveText(dialog.promptOf(812, "Q215"));
  await page.goBack();
  await expect(start.button(812, true)).toBeVisible();
  await page.goForward();
  await expect(dialog.question).toHaveText(dialog.promptOf(812, "Q215"));
  await page.goForward();
  await expect(setup.start("x")).toBeVisible();
  await page.goForward();
  await back.click();
  await expect(setup.start("x")).toBeVisible();
  await page.goBack();
  await expect(dialog.question).toHaveText(dialog.promptOf(812, "Q215"));
  await page.getByRole("link", { name: t.page.home }).click();
  await expect(start.button(812, true)).toBeVisible();

  // Undo goes on after a reload, in a cycle and in a program.
  await start.beginWithExample(812);
  await dialog.set("Q493", "51.5");
  await dialog.set("Q494", "-44");
  await dialog.open("Q463");
  await dialog.type("2.4");
  await page.reload();
  await expect(dialog.question).toHaveText(dialog.promptOf(812, "Q463"));
  await turnwise.undo();
  await expect(dialog.line("Q463")).toContainText("3");
  await turnwise.undo();
  await turnwise.undo();
  await expect(dialog.line("Q493")).not.toContainText("51.5");
  await turnwise.redo();
  await expect(dialog.line("Q493")).toContainText("51.5");
  await page.reload();
  await expect(dialog.line("Q493")).toContainText("51.5");
  await turnwise.undo();
  await expect(dialog.line("Q493")).not.toContainText("51.5");

  await page.getByRole("link", { name: t.page.home }).click();
  await page.getByRole("button", { name: t.page.programs.example(t.page.examples.flange) }).click();
  await editor.line("M136").click();
  await page.keyboard.press("End");
  await page.keyboard.type(" ; END");
  await expect(editor.line("M136")).toContainText("; END");
  await page.reload();
  await expect(editor.line("M136")).toContainText("; END");
  await turnwise.undo();
  await expect(editor.line("M136")).not.toContainText("; END");
});

test("every place can be reloaded at its address; that of a missing work says so", async ({ page }) => {
  const turnwise = await Turnwise.open(page, { heldClock: true });
  const { t, start, dialog, setup } = turnwise;
  const again = async (address: RegExp) => {
    await expect(page).toHaveURL(address);
    await page.reload();
    await expect(page).toHaveURL(address);
  };
  await again(/\?clock=manual#\/$/);
  await expect(start.button(812, true)).toBeVisible();
  await page.getByRole("button", { name: t.page.start.which, exact: true }).click();
  await again(/#\/which$/);
  await expect(page.getByRole("dialog", { name: /./ })).toBeVisible();
  await page.keyboard.press("Escape");
  await again(/#\/$/);
  await start.beginWithExample(820);
  await dialog.open("Q463");
  await again(/#\/work\/[\w-]+$/);
  await expect(dialog.question).toHaveText(dialog.promptOf(820, "Q463"));
  await turnwise.show("setup");
  await again(/#\/work\/[\w-]+\/setup$/);
  await expect(setup.start("x")).toBeVisible();
  await turnwise.show("contour");
  await again(/#\/work\/[\w-]+\/contour$/);
  await expect(turnwise.contour.table).toBeVisible();
  await page.getByRole("button", { name: t.page.tools.openLong }).click();
  await again(/#\/tools$/);
  await page.goto("./#/tools/5");
  await again(/#\/tools\/5$/);
  await expect(turnwise.tools.form).toBeVisible();
  await page.goto("./#/own");
  await again(/#\/own$/);
  await expect(page.getByRole("heading", { name: t.page.own.title, level: 1 })).toBeVisible();
  await page.goto("./#/");
  await page.getByRole("button", { name: t.page.programs.example(t.page.examples.flange) }).click();
  const findings = page.getByRole("tab", { name: new RegExp(`^${t.findings.title}`) });
  await findings.click();
  await again(/#\/work\/[\w-]+\/findings$/);
  await expect(findings).toHaveAttribute("aria-selected", "true");

  // The address of a missing work says so.
  await page.goto("./#/work/nowhere/contour");
  await expect(page.getByText(t.page.notice.workNotHere)).toBeVisible();
  await page.goto(".?clock=manual#/work/nowhere/contour");
  await expect(page.getByText(t.page.notice.workNotHere)).toBeVisible();
  await expect(start.button(812, true)).toBeVisible();
  await expectAccessibleAndFits(page);
});

