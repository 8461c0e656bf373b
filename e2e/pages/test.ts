import { expect, test as plain, type Page } from "@playwright/test";
import { LANGUAGES } from "../../src/i18n/languages.ts";
import { loadWords } from "./words.ts";

// Journeys change between languages and name controls in any of them.
await Promise.all(LANGUAGES.map(loadWords));

/** CPU slowdown of the page: `THROTTLE=4 npm run e2e` is like a small tablet. */
const rate = Number(process.env["THROTTLE"] ?? 1);

async function slowed(page: Page): Promise<void> {
  const session = await page.context().newCDPSession(page);
  await session.send("Emulation.setCPUThrottlingRate", { rate });
}

/** Every spec file uses this `test`, so that all of them can run with a slowed CPU. */
export const test = plain.extend({
  context: async ({ context }, use) => {
    if (rate > 1) context.on("page", (page) => void slowed(page).catch(() => undefined));
    await use(context);
  },
});

export { expect };
