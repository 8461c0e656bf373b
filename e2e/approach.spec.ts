import { accessible } from "./pages/look.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

test("a milled program shows its plane, and its approach is changed by prompt, by dragging, by another form", async ({ page }) => {
  const { editor, t } = await Turnwise.open(page);
  await editor.openExample("plate");
  await expect(page.getByRole("region", { name: t.approach.view })).toBeVisible();
  await editor.line("APPR LT").click();
  await editor.show("block");
  await expect(page.getByRole("img", { name: /PH at X−5 Y−5, PA at X−5 Y\+5/ })).toBeVisible();
  await page.getByRole("button", { name: /^LEN length/ }).click();
  await page.keyboard.type("15");
  await expect(page.getByRole("img", { name: /PH at X−5 Y−10/ })).toBeVisible();
  await expect(editor.line("APPR LT")).toContainText("LEN15");
  const grip = await page.locator('[data-handle="PH"]').boundingBox();
  if (!grip) throw new Error("no handle");
  const [x, y] = [grip.x + grip.width / 2, grip.y + grip.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x, y + 30, { steps: 5 });
  await page.mouse.up();
  await expect(editor.line("APPR LT")).not.toContainText("LEN15");
  await page.getByRole("button", { name: t.approach.otherForm }).click();
  await accessible(page);
  await page.getByRole("button", { name: /^APPR CT:/ }).click();
  await expect(editor.line("APPR CT")).toContainText("CCA90");
  await accessible(page);
});
