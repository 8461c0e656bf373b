import type { Locator, Page } from "@playwright/test";

/** Most Tab stops that a screen may have. */
const MOST_STOPS = 120;

/** Reaches an element with the Tab key alone. */
export async function tabTo(page: Page, target: Locator, key: "Tab" | "Shift+Tab" = "Tab"): Promise<void> {
  for (let i = 0; i < MOST_STOPS; i += 1) {
    if (await target.evaluate((element) => element === document.activeElement)) return;
    await page.keyboard.press(key);
  }
  throw new Error(`The ${key} key does not reach ${target}.`);
}
