import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

/** Most keys that a shoulder from the empty page may take beyond its values. */
const MOST_KEYS = 25;

test("a shoulder from the empty page by keyboard alone, with few keys beyond its values", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { dialog, effect, program, t } = turnwise;
  const { keyboard } = page;
  let keys = 0;
  const press = async (key: string, times = 1) => {
    for (let i = 0; i < times; i += 1) await keyboard.press(key);
    keys += times;
  };
  const asks = (q: string) => expect(dialog.question).toHaveText(dialog.promptOf(812, q));
  await turnwise.start.search.waitFor();
  for (const digit of "812") await press(digit);
  await expect(turnwise.start.button(812, false)).toBeVisible();
  await press("ArrowDown");
  await press("ArrowRight");
  await press("Enter");
  await expect(dialog.question).toHaveText(t.setup.blank.outside);
  await press("End");
  for (const [q, value] of [
    ["Q215", ""],
    ["Q460", ""],
    ["Q491", "61.3"],
    ["Q492", ""],
    ["Q493", "42"],
    ["Q494", "-35"],
  ] as const) {
    await asks(q);
    await keyboard.type(value);
    if (q === "Q494") await press("End");
    else await press("Enter");
  }
  await expect(dialog.active.getByRole("button", { name: /\d/ }).first()).toBeFocused();
  await press("Enter");
  await expect(dialog.question).toHaveText(t.dialog.done.title);
  await effect.proved();
  await expect(program.copyButton).toBeFocused();
  await press("Enter");
  const text = await program.clipboard();
  expect(text).toContain("BLK FORM CYLINDER Z D61.3 L65");
  expect(text.replace(/ +/g, " ")).toContain("Q494=-35 ");
  expect(keys).toBeLessThan(MOST_KEYS);
});

test("a proposed blank, one that the user has set, and a contour that is asked first", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { contour, dialog, effect, program, t } = turnwise;
  await turnwise.start.beginEmpty(852);
  await dialog.active.getByRole("button", { name: t.dialog.setup.toPrompts, exact: true }).click();
  for (const [q, value] of [
    ["Q491", "61.3"],
    ["Q492", "0"],
    ["Q493", "42.7"],
    ["Q494", "12"],
  ] as const)
    await dialog.set(q, value);
  await dialog.open("Q494");
  await expect(dialog.messages).toContainText("Z+12");
  await dialog.messages.getByRole("button", { name: t.dialog.takeNearest("-12"), exact: true }).click();
  await expect(dialog.value).toHaveValue("-12");
  await expect(dialog.messages.getByRole("button")).toHaveCount(0);
  await page.keyboard.press("End");
  await dialog.active.getByRole("button").first().click();
  await effect.proved();
  await expect(effect.cell("passes")).not.toHaveText("0");

  // With a blank that the user has set, a value that does not fit it is queried at its prompt.
  await page.getByRole("link", { name: t.page.home, exact: true }).click();
  await turnwise.start.beginEmpty(812);
  await expect(dialog.value).toBeFocused();
  await dialog.type("60");
  await page.keyboard.press("End");
  await dialog.set("Q491", "75.5");
  await dialog.open("Q491");
  await expect(dialog.messages).toContainText("⌀60");
  await dialog.messages.getByRole("button", { name: t.dialog.takeNearest("75.5"), exact: true }).click();
  await expect(program.blocks.filter({ hasText: "BLK FORM" })).toContainText("D75.5");
  await expect(dialog.messages.getByRole("button")).toHaveCount(0);

  // A free contour is asked first, and the dialog does not end without it.
  await page.getByRole("link", { name: t.page.home, exact: true }).click();
  await turnwise.start.beginEmpty(820);
  await expect(dialog.value).toBeFocused();
  await page.keyboard.press("End");
  await expect(dialog.question).toHaveText(t.dialog.contour.question);
  await dialog.open("Q215");
  await page.keyboard.press("End");
  await dialog.active.getByRole("button").first().click();
  await expect(dialog.question).toHaveText(t.findings.done.contour);
  await dialog.active.getByRole("button", { name: t.findings.done.toContour, exact: true }).click();
  await expect(contour.add).toBeVisible();
  await contour.add.click();
  await contour.x(1).fill("60");
  await contour.z(1).fill("-20");
  await contour.add.click();
  await contour.x(2).fill("20");
  await contour.z(2).fill("0");
  await page.getByRole("button", { name: t.dialog.contour.back, exact: true }).click();
  await expect(dialog.line("LBL")).toContainText("2");
  await dialog.open("Q506");
  await page.keyboard.press("End");
  await expect(dialog.question).toHaveText(t.dialog.done.title);
});
