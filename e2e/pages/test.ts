import { expect as plainExpect, test as plain, type Locator, type Page } from "@playwright/test";
import { LANGUAGES } from "../../src/i18n/languages.ts";
import { axeViolations, COLOUR_RULES, hasAxe } from "./axe.ts";
import { onBlocked } from "./policy.ts";
import { loadWords } from "./words.ts";

// Journeys change between languages and name controls in any of them.
await Promise.all(LANGUAGES.map(loadWords));

/** Assertions on an element that may still be missing. */
const ON_ELEMENTS = [
  "toBeFocused",
  "toBeVisible",
  "toContainText",
  "toHaveAccessibleName",
  "toHaveAttribute",
  "toHaveText",
  "toHaveValue",
] as const;

/**
 * As long as an element is missing, an assertion describes the whole page for its message, each time it looks: half of
 * what Playwright does in a page. Waiting for the element first describes nothing.
 */
export const expect = plainExpect.extend(
  Object.fromEntries(
    ON_ELEMENTS.map((name) => [
      name,
      async function (this: { readonly isNot: boolean }, element: Locator, ...rest: readonly unknown[]) {
        const { timeout } = (rest.at(-1) ?? {}) as { readonly timeout?: number };
        const state = name === "toBeVisible" ? "visible" : "attached";
        if (!this.isNot)
          await element
            .first()
            .waitFor({ state, ...(timeout !== undefined && { timeout }) })
            .catch(() => undefined);
        const assertions = this.isNot ? plainExpect(element).not : plainExpect(element);
        await Reflect.apply(assertions[name], assertions, rest);
        return { pass: !this.isNot, message: () => name };
      },
    ]),
  ) as Record<never, never>,
);

/** CPU slowdown of the page: `THROTTLE=4 npm run e2e` is like a small tablet. */
const rate = Number(process.env["THROTTLE"] ?? 1);

async function slowed(page: Page): Promise<void> {
  const session = await page.context().newCDPSession(page);
  await session.send("Emulation.setCPUThrottlingRate", { rate });
}

/** Whether the page is still there to be looked at: neither closed nor left. */
const isShown = (page: Page): boolean => !page.isClosed() && page.url().startsWith("http");

/**
 * Every spec file uses this `test`, so that all of them can run with a slowed CPU, and that the last screen of a journey
 * passes axe where the journey has not looked itself, and so that the content policy has blocked nothing. Colours are checked where nothing calculates.
 */
export const test = plain.extend({
  context: async ({ context }, use) => {
    if (rate > 1) context.on("page", (page) => void slowed(page).catch(() => undefined));
    await use(context);
  },
  page: async ({ page }, use, info) => {
    const blocked: string[] = [];
    await onBlocked(page, (what) => void blocked.push(what));
    await use(page);
    expect(blocked, "what the content policy has blocked").toEqual([]);
    if (info.status !== info.expectedStatus || !isShown(page) || (await hasAxe(page))) return;
    expect(await axeViolations(page, { but: COLOUR_RULES }), "axe on the last screen").toEqual([]);
  },
});
