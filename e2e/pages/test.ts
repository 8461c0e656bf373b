import { expect, test as plain, type Page } from "@playwright/test";

/** How many times slower the processor of the page is made: `THROTTLE=4 npm run e2e` is a small tablet. */
const rate = Number(process.env["THROTTLE"] ?? 1);

async function slowed(page: Page): Promise<void> {
  const session = await page.context().newCDPSession(page);
  await session.send("Emulation.setCPUThrottlingRate", { rate });
}

/** Every journey runs with this `test`, so that all of them can be run as on a slow machine. */
export const test = plain.extend({
  context: async ({ context }, use) => {
    if (rate > 1) context.on("page", (page) => void slowed(page).catch(() => undefined));
    await use(context);
  },
});

export { expect };
