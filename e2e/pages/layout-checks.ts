import type { Locator, Page } from "@playwright/test";
import { axeViolations, COLOUR_RULES } from "./axe.ts";
import { expect } from "./test.ts";

/** Horizontal overflow of the page, px. */
const horizontalOverflow = (page: Page): Promise<number> =>
  page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);

const softly = expect.configure({ soft: true });

/**
 * The page has no horizontal overflow once its layout has settled. Soft: the failure names the screen, and the test
 * continues.
 */
export const expectFits = (page: Page, screen: string): Promise<void> =>
  softly.poll(() => horizontalOverflow(page), { message: `width of ${screen}`, timeout: 5000 }).toBeLessThanOrEqual(0);

/** An element is inside the window as a whole, and nothing covers its middle. */
export const expectInView = (locator: Locator, what: string): Promise<void> =>
  expect
    .poll(
      () =>
        locator.evaluate((element) => {
          const { left, top, right, bottom } = element.getBoundingClientRect();
          const on = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
          const free = on !== null && (element.contains(on) || on.contains(element));
          return free && left >= 0 && top >= 0 && right <= innerWidth && bottom <= innerHeight;
        }),
      { message: what, timeout: 5000 },
    )
    .toBe(true);

/** The page breaks no axe rule. */
export const expectAccessible = async (page: Page): Promise<void> => expect(await axeViolations(page)).toEqual([]);

/** The page breaks no axe rule, and has no horizontal overflow. */
export async function expectAccessibleAndFits(page: Page): Promise<void> {
  await expectAccessible(page);
  expect(await horizontalOverflow(page)).toBeLessThanOrEqual(0);
}

/**
 * The same for one of several screens of a test. Soft: the failure names the screen, and the test continues.
 */
export async function expectFine(page: Page, screen: string): Promise<void> {
  expect.soft(await axeViolations(page), `axe on ${screen}`).toEqual([]);
  await expectFits(page, screen);
}

/** The same in light and dark. Leaves the page light. */
export async function expectFineInBothThemes(page: Page, screen: string): Promise<void> {
  await page.emulateMedia({ colorScheme: "dark" });
  expect.soft(await axeViolations(page, { only: COLOUR_RULES }), `colours of ${screen} in the dark`).toEqual([]);
  await page.emulateMedia({ colorScheme: "light" });
  await expectFine(page, screen);
}

/** The same in windows of several sizes, px. Dark colours do not depend on the size: they are checked in the first. */
export async function expectFineAtSizes(
  page: Page,
  screen: string,
  sizes: readonly (readonly [width: number, height: number])[],
): Promise<void> {
  for (const [i, [width, height]] of sizes.entries()) {
    await page.setViewportSize({ width, height });
    await (i === 0 ? expectFineInBothThemes : expectFine)(page, `${screen} at ${width} by ${height}`);
  }
}
