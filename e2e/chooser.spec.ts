import { expectAccessibleAndFits, expectFineInBothThemes } from "./pages/layout-checks.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

/** Smallest target for a gloved finger, px. */
const TARGET = 44;

test("cycles are found by arrow keys, by a word of another language, and among the recent ones", async ({ page }) => {
  const { start, dialog, t } = await Turnwise.open(page);
  await start.search.focus();
  await page.keyboard.press("ArrowDown");
  await expect(page.locator(".cycle-group-head").first()).toBeFocused();
  await page.keyboard.press("ArrowDown");
  await expect(page.locator(".cycle-take").first()).toBeFocused();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowLeft");
  await expect(page.locator(".cycle-take").first()).toBeFocused();
  await page.keyboard.press("8");
  await expect(start.search).toHaveValue("8");

  // Find a cycle by a word of another language, and again among the recent ones.
  await start.search.fill("epaulement");
  await expect(start.button(812, true)).toBeVisible();
  await start.search.fill("812");
  await page.keyboard.press("Enter");
  await expect(dialog.question).toHaveText(dialog.promptOf(812, "Q215"));
  await page.getByRole("link", { name: t.page.home }).click();
  await start.recent.getByRole("button", { name: /812/ }).click();
  await expect(dialog.question).toHaveText(dialog.promptOf(812, "Q215"));
});

test("on a phone the groups are folded, and a search passes axe", async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  const { start, t } = await Turnwise.open(page);
  await expect(start.button(812, true)).toHaveCount(0);
  await start.group(t.cycles.groups.longitudinal).click();
  await expect(start.button(812, true)).toBeVisible();
  await start.search.fill("8");
  await expect(start.button(852, true)).toBeVisible();
  await expectFineInBothThemes(page, "a search");
  for (const button of await page.getByRole("group", { name: t.chooser.cycles }).getByRole("button").all())
    expect((await button.boundingBox())?.height).toBeGreaterThanOrEqual(TARGET);
});

test("cycles are inserted into a program with the same chooser; one that is not simulated says so", async ({
  page,
}) => {
  const { start, editor, dialog, t } = await Turnwise.open(page);
  const says = page.getByRole("group", { name: t.chooser.cycles }).getByRole("status");
  const called = (number: number, name: string) => t.page.start.cycle(number, name);
  await start.search.fill("800");
  await expect(says).toHaveText(t.chooser.acts(called(800, t.cycles.of[800].name)));
  await expectAccessibleAndFits(page);
  await editor.create();
  await editor.line("M30").click();
  await editor.show("block");
  await editor.insert("cycle");
  await start.search.fill("880");
  await expect(says).toHaveText(t.chooser.kept(called(880, t.cycles.kept[880])));
  await expectAccessibleAndFits(page);
  await start.search.fill("800");
  await page.keyboard.press("Enter");
  await expect(dialog.question).toHaveText(dialog.promptOf(800, "Q497"));
  await expect(page.getByText(t.cycles.of[800].description[0] ?? "")).toBeVisible();
  await expectAccessibleAndFits(page);

  // A cycle is inserted into a program with the same chooser.
  await editor.line("M30").click();
  await editor.show("block");
  await editor.insert("cycle");
  await start.search.fill("852");
  await expectAccessibleAndFits(page);
  await page.keyboard.press("Enter");
  await expect(page.getByRole("form", { name: t.dialog.form })).toBeVisible();
  await expect(page.getByRole("heading", { name: t.cycles.of[852].name })).toBeVisible();
});
