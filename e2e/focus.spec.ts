import { readFileSync } from "node:fs";
import type { Locator, Page } from "@playwright/test";
import { which } from "../src/i18n/en/which.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

/** Presses a control with a key and expects the focus on some element of the page afterwards. */
async function press(target: Locator, key = "Enter"): Promise<void> {
  await target.focus();
  await target.page().keyboard.press(key);
  await expectFocus(target.page());
}

/** The focus is on an element, not on the page, also after a component has placed it. */
async function expectFocus(page: Page): Promise<void> {
  await page.evaluate(() => new Promise((resolve) => requestIdleCallback(resolve, { timeout: 500 })));
  await expect
    .poll(() => page.evaluate(() => document.activeElement !== document.body && document.activeElement !== null))
    .toBe(true);
}

test("no dialog of the workplace loses the keyboard", async ({ page }) => {
  const { start, effect, menus } = await Turnwise.open(page);
  await start.beginWithExample(812);
  await effect.proved();
  const shown = page.getByRole("dialog").or(page.getByRole("alertdialog"));
  /** The opened dialog has the focus, and gives it back to its opener when it is closed. */
  const expectReturnTo = async (opener: Locator) => {
    await expect(shown.locator(":focus").first()).toBeVisible();
    await page.keyboard.press("Escape");
    await expect(shown).toHaveCount(0);
    await expect(opener).toBeFocused();
  };
  const openers = page.locator("button[aria-haspopup=dialog]:visible");
  for (let i = 0; i < (await openers.count()); i += 1) {
    await press(openers.nth(i));
    await expectReturnTo(openers.nth(i));
  }
  const items = page.getByRole("menu").locator("[aria-haspopup=dialog]");
  let opened = 0;
  for (const menu of ["export", "program"] as const) {
    const button = menus.button(menu);
    await press(button);
    const count = await items.count();
    await page.keyboard.press("Escape");
    await expect(button).toBeFocused();
    for (let i = 0; i < count; i += 1) {
      await press(button);
      await press(items.nth(i));
      await expectReturnTo(button);
      opened += 1;
    }
  }
  expect(opened).toBeGreaterThan(5);
});

test("what is added, drawn or undone has the keyboard", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { dialog, contour, editor, t } = turnwise;
  await turnwise.start.beginEmpty(810);
  await expect(dialog.value).toBeFocused();
  await page.keyboard.press("End");
  await expectFocus(page);
  await page.keyboard.press("Enter");
  await expect(contour.add).toBeFocused();
  await page.keyboard.press("Enter");
  await expect(contour.x(1)).toBeFocused();
  for (let i = 0; i < 3; i += 1) await press(turnwise.historyButton("undo"));

  await page.goto("./#/");
  await turnwise.start.beginWithExample(812);
  await turnwise.effect.proved();
  for (let i = 0; i < 2; i += 1) {
    await press(page.getByRole("button", { name: t.lathe.which, exact: true }));
    const asked = page.getByRole("dialog", { name: which.title });
    await asked.getByRole("combobox", { name: which.stock.label }).selectOption("now");
    const add = asked.getByRole("button", { name: /^Add to the program/ }).first();
    await expect(add).toBeEnabled();
    await press(add);
    await expect(asked).toHaveCount(0);
    await expectFocus(page);
  }
  await expect(page.getByRole("form", { name: t.dialog.form }).locator(":focus")).toBeVisible();
  await expect(editor.total(t.editor.operations)).toHaveText("3");
});

test("an exercise keeps the keyboard from the prediction to the check", async ({ page }) => {
  const { task, course, dialog } = await Turnwise.open(page);
  const titleOf = (id: string): string =>
    JSON.parse(readFileSync(new URL(`../src/course/tasks/${id}.json`, import.meta.url), "utf8")).words.en.title;
  const begin = async (id: string) => {
    await page.goto("./#/course/first-shoulder/tasks");
    await press(course.task(titleOf(id)));
    await expect(task.assignment).toBeVisible();
  };
  await begin("l03-how-many-passes");
  await press(task.fold);
  await task.field("answer").fill("19");
  await page.keyboard.press("Enter");
  await task.field("answer").fill("2.1");
  await press(task.run);
  await expect(task.again).toBeVisible();
  await expectFocus(page);
  await press(task.again);
  await expect(task.run.or(task.nextQuestion)).toBeVisible();
  await expectFocus(page);
  await begin("l03-first-shoulder");
  await expect(dialog.value).toBeFocused();
  await press(task.fold);
  await press(task.check);
  await expect(task.status.getByRole("button")).toBeFocused();
  await page.keyboard.press("Enter");
  await expect(dialog.value).toBeFocused();
});

test("blocks, tools, own cycles and lessons keep the keyboard", async ({ page }) => {
  const { course, editor, effect, own, start, t, tools } = await Turnwise.open(page);
  const form = page.getByRole("form").locator(":focus");
  await start.beginWithExample(812);
  await effect.proved();
  const last = page.getByRole("button", { name: t.lathe.last, exact: true });
  await press(last);
  await expect(last).toBeFocused();
  await page.goto("./#/");
  await editor.openExample("flange");
  await editor.show("structure");
  await press(editor.operation(3));
  for (const name of ["duplicate", "down", "remove"] as const) await press(editor.operationTool(name));
  await editor.line("M136").click();
  await editor.show("block");
  for (const kind of ["L", "label"] as const) {
    await press(editor.tool("insertLong"));
    await expectFocus(page);
    await press(
      page.getByRole("group", { name: t.editor.palette }).getByRole("button", { name: t.editor.kinds[kind] }).first(),
    );
    await expect(form).toBeVisible();
  }
  await page.goto("./#/tools");
  for (const each of [tools.add, tools.duplicate, tools.remove]) await press(each);
  await page.goto("./#/own");
  await press(own.add);
  await page.goto("./#/course/first-shoulder");
  await expect(course.next).toBeVisible();
  for (let i = 0; i < 7; i += 1) if (await course.next.isVisible()) await press(course.next);
});
