import { readFileSync } from "node:fs";
import { insert } from "../src/i18n/en/insert.ts";
import { expectAccessibleAndFits } from "./pages/layout-checks.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

const flange = readFileSync(new URL("../src/examples/flange.h", import.meta.url), "utf8");

test("operations of the flange are duplicated, moved, skipped and restored byte for byte", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { editor, t } = turnwise;
  const text = async () => (await editor.downloaded()).toString();
  await editor.openExample("flange");
  await expect(editor.total(t.editor.operations)).toHaveText("8");
  await editor.show("structure");
  await editor.operation(3).click();
  await expectAccessibleAndFits(page);

  await editor.operationTool("down").click();
  await expect(editor.operation(4)).toHaveAttribute("aria-expanded", "true");
  expect(await text()).not.toBe(flange);
  await expect(editor.total(t.editor.toolChanges)).toHaveText("8");
  await editor.operationTool("up").click();
  expect(await text()).toBe(flange);

  // Dragged by its grip, it moves to where it is dropped.
  await editor.dragOperation(3, 4);
  await expect(editor.total(t.editor.toolChanges)).toHaveText("8");
  await editor.dragOperation(4, 3);
  expect(await text()).toBe(flange);

  await editor.operationTool("duplicate").click();
  await expect(editor.total(t.editor.operations)).toHaveText("9");
  await editor.operationTool("remove").click();
  expect(await text()).toBe(flange);

  await editor.operation(2).click();
  await editor.operationTool("switchOff").click();
  await expect(editor.operation(2)).toContainText(t.operations.off);
  await expect(editor.total(t.editor.operations)).toHaveText("7");
  await turnwise.undo();
  expect(await text()).toBe(flange);
  await expect(editor.total(t.editor.operations)).toHaveText("8");
  await expect(editor.leaveOut).toHaveCount(0);
  await turnwise.redo();
  await expect(editor.total(t.editor.operations)).toHaveText("7");
  await editor.operationTool("switchOn").click();
  expect(await text()).toBe(flange);
});

test("a new program cancelled at its first operation is valid, and takes a thread by its name", async ({ page }) => {
  const { editor, t } = await Turnwise.open(page);
  await editor.create();
  await editor.show("structure");
  expect((await editor.downloaded()).toString()).toBe(
    "0 BEGIN PGM PROGRAM MM\n1 BLK FORM CYLINDER Z D80 L100 DIST+1\n2 FUNCTION MODE TURN\n3 M30\n4 END PGM PROGRAM MM\n",
  );
  await page.getByRole("button", { name: t.operations.insert, exact: true }).click();
  await expect(editor.inserting).toBeVisible();
  await page.keyboard.type("M10");
  await editor.inserting.getByRole("button", { name: insert.hand.tapOf("M10"), exact: true }).click();
  await editor.inserting.getByRole("button", { name: t.operations.put, exact: true }).click();
  await expect(editor.inserting).toBeHidden();
  await editor.show("structure");
  await expect(editor.operation(2)).toContainText(insert.hand.tapOf("M10").toUpperCase());
});
