import type { Page } from "@playwright/test";
import { tabTo } from "./pages/keyboard.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

test.use({ reducedMotion: "no-preference" });

const press = async (page: Page, ...keys: readonly string[]) => {
  for (const key of keys) await page.keyboard.press(key);
};

test("a toolbar is one Tab stop; tabs and radio groups by arrows, a choice by its digit", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { lathe } = turnwise;
  await turnwise.start.beginWithExample(820);
  await turnwise.effect.proved();
  await expect(lathe.running).toContainText(turnwise.t.lathe.outside);
  const at = await lathe.running.innerText();

  await lathe.section.focus();
  await press(page, "ArrowRight", "ArrowRight", "ArrowRight");
  await expect(lathe.button("xDown")).toBeFocused();
  await press(page, ...Array.from({ length: 6 }, () => "ArrowRight"), "ArrowLeft");
  await expect(lathe.button("zoomIn")).toBeFocused();
  await press(page, "Tab", "Shift+Tab");
  await expect(lathe.button("zoomIn")).toBeFocused();

  await lathe.button("play").focus();
  await press(page, "ArrowRight", "ArrowRight", "ArrowRight");
  await expect(lathe.speed).toBeFocused();
  await expect(lathe.running).toHaveText(at, { useInnerText: true });

  await turnwise.show("contour");
  await turnwise.contour.add.focus();
  await press(page, "ArrowRight");
  await expect(turnwise.contour.add).not.toBeFocused();
  await press(page, "ArrowLeft");
  await expect(turnwise.contour.add).toBeFocused();

  const tab = page.getByRole("tab");
  await tabTo(page, page.getByRole("tab", { selected: true }), "Shift+Tab");
  for (const [key, at] of [
    ["End", -1],
    ["Home", 0],
    ["ArrowRight", 1],
    ["ArrowLeft", 0],
  ] as const) {
    await press(page, key);
    const reached = at < 0 ? tab.last() : tab.nth(at);
    await expect(reached).toBeFocused();
    await expect(reached).toHaveAttribute("aria-selected", "true");
  }

  const { dialog, setup } = turnwise;
  await turnwise.show("prompts");
  await dialog.open("Q215");
  await expect(dialog.choice(0)).toBeFocused();
  await press(page, "ArrowRight");
  await expect(dialog.choice(1)).toBeChecked();
  await press(page, "3");
  await expect(dialog.choice(3)).toBeChecked();
  await expect(dialog.choice(3)).toBeFocused();
  await press(page, "ArrowDown");
  await expect(dialog.question).toHaveText(dialog.promptOf(820, "Q460"));

  await turnwise.show("setup");
  await setup.spindleMode("surface").focus();
  await press(page, "ArrowDown");
  await expect(setup.spindleMode("constant")).toBeChecked();
  await expect(setup.spindleMode("constant")).toBeFocused();
  await setup.tool(15).focus();
  await press(page, "ArrowUp");
  await expect(setup.tool(14)).toBeChecked();
});
