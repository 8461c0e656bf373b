import AxeBuilder from "@axe-core/playwright";
import type { Page } from "@playwright/test";
import { expect } from "./test.ts";

/** Rules about colours: the only ones that can tell the two appearances apart. */
const OF_COLOURS = ["color-contrast", "link-in-text-block"];

/** Waits for what moves or changes its colours and comes to an end: half-way it is neither. */
const atRest = (page: Page): Promise<void> =>
  page.evaluate(async () => {
    const ending = document
      .getAnimations()
      .filter(
        ({ effect, playState }) => playState === "running" && effect?.getComputedTiming().iterations !== Infinity,
      );
    await Promise.allSettled(ending.map(({ finished }) => finished));
  });

/** The rules of axe that the page breaks, all of them or some, named with the elements that break them. */
async function broken(page: Page, rules?: string[]): Promise<readonly string[]> {
  await atRest(page);
  // In the page itself, brought there once and telling only what is wrong, it takes a fifth of the time.
  const isThere = await page.evaluate(() => "axe" in window);
  const axe = new AxeBuilder(isThere ? { page, axeSource: "0;" } : { page })
    .setLegacyMode()
    .options({ resultTypes: ["violations"] });
  const { violations } = await (rules ? axe.withRules(rules) : axe).analyze();
  return violations.map(
    (v) =>
      `${v.id}: ${v.nodes
        .map((n) => n.target.join(" "))
        .slice(0, 4)
        .join(" | ")}`,
  );
}

/** How far the page sticks out sideways, px. */
const excess = (page: Page): Promise<number> =>
  page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);

const softly = expect.configure({ soft: true });

/**
 * Nothing sticks out of the screen sideways, when the page has arranged itself; of one of several screens its name is
 * told, and the journey goes on.
 */
export const fits = (page: Page, screen: string): Promise<void> =>
  softly.poll(() => excess(page), { message: `width of ${screen}`, timeout: 5000 }).toBeLessThanOrEqual(0);

/** No violation of the rules of axe. */
export const accessible = async (page: Page): Promise<void> => expect(await broken(page)).toEqual([]);

/** The screen passes axe, and nothing sticks out of it sideways. */
export async function looksRight(page: Page): Promise<void> {
  await accessible(page);
  expect(await excess(page)).toBeLessThanOrEqual(0);
}

/**
 * The same in the light and in the dark appearance, for one of several screens of a journey: what is wrong with it is
 * told by its name, and the journey goes on. Leaves the page light.
 */
export async function looksRightInBoth(page: Page, screen: string): Promise<void> {
  await page.emulateMedia({ colorScheme: "dark" });
  expect.soft(await broken(page, OF_COLOURS), `colours of ${screen} in the dark`).toEqual([]);
  await page.emulateMedia({ colorScheme: "light" });
  expect.soft(await broken(page), `axe on ${screen}`).toEqual([]);
  await fits(page, screen);
}
