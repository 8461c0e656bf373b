import { expectAccessibleAndFits, expectFineAtSizes } from "./pages/layout-checks.ts";
import { settledBox } from "./pages/picture.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

test.use({ reducedMotion: "no-preference" });

const SIZES = [
  [390, 844],
  [768, 1024],
  [1024, 768],
  [1440, 900],
  [2560, 1440],
] as const;

test("the start page is right at every size, on the first visit and with stored works", async ({ page }) => {
  const turnwise = await Turnwise.open(page, { heldClock: true });
  const { t, start } = turnwise;
  await expect(page.getByRole("img", { name: t.start.hero.name(10) })).toBeVisible();
  await expectFineAtSizes(page, "the first visit", SIZES);
  await start.beginWithExample(812);
  await turnwise.effect.proved();
  await page.getByRole("link", { name: t.page.home }).click();
  await expect(page.getByRole("region", { name: t.page.start.kept })).toBeVisible();
  await expectFineAtSizes(page, "the start with work", SIZES);
});

test("the lathe on the start page plays, pauses, and stands still with reduced motion", async ({ page }) => {
  const { t, lathe } = await Turnwise.open(page, { heldClock: true });
  const { hero } = t.start;
  const tool = page.locator(".hero .tool-carrier").first();
  const doing = page.locator(".hero-doing");
  await expect(tool).toHaveAttribute("style", /translate/);
  const [first, begun] = [await tool.getAttribute("style"), await doing.textContent()];
  await lathe.advance(2400);
  await expect(tool).not.toHaveAttribute("style", first ?? "");
  await expect(doing).not.toHaveText(begun ?? "");
  await page.getByRole("button", { name: hero.pause, exact: true }).click();
  const held = await tool.getAttribute("style");
  await lathe.advance(900);
  await expect(tool).toHaveAttribute("style", held ?? "");
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.reload();
  await expect(page.getByRole("button", { name: hero.play, exact: true })).toBeVisible();
  await expect(page.locator(".hero-still")).toBeVisible();
  await expect(tool).toHaveCount(0);
});

test("stored works come first, open, are deleted with an undo, and are found like examples and cycles", async ({
  page,
}) => {
  const { t, start, dialog } = await Turnwise.open(page);
  await start.beginWithExample(852);
  await expect(dialog.question).toBeVisible();
  await page.getByRole("link", { name: t.page.home }).click();
  const kept = page.getByRole("region", { name: t.page.start.kept });
  await expect(kept).toContainText(t.cycles.of[852].name);
  const cyclesOf = page.getByRole("region", { name: t.page.start.choose });
  const [top, cycles] = [await settledBox(kept), await settledBox(cyclesOf)];
  expect(top.y).toBeLessThan(cycles.y);
  const name = (await kept.locator("b.kept-name").first().textContent()) ?? "";
  await kept.getByRole("button", { name: t.page.start.forget(name) }).click();
  await expect(start.kept(name)).toHaveCount(0);
  await kept.getByRole("button", { name: t.page.undo }).click();
  await start.kept(name).click();
  await expect(dialog.question).toBeVisible();

  // One search finds an example, a cycle and a stored work.
  await page.getByRole("link", { name: t.page.home, exact: true }).click();
  await start.beginWithExample(812);
  await expect(dialog.question).toBeVisible();
  await page.getByRole("link", { name: t.page.home }).click();
  await start.search.fill("852");
  await expect(start.button(852, true)).toBeVisible();
  await start.search.fill("shaft ten");
  await expect(page.getByRole("button", { name: t.page.start.foundExample(t.page.examples.shaft) })).toBeVisible();
  await start.search.fill("shoulder8");
  await expect(page.getByRole("button", { name: t.page.start.foundWork("SHOULDER812") })).toBeVisible();
  await expectAccessibleAndFits(page);
  await page.keyboard.press("Enter");
  await expect(dialog.question).toBeVisible();
});
