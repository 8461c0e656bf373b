import { readFileSync } from "node:fs";
import type { Page } from "@playwright/test";
import { provedIn } from "./pages/effect.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

/*
 * The page draws the path in the frame of the keystroke; until the worker has verified it, the strip says "checking".
 */

/** From the next navigation on, blocks messages to the worker while `hold` returns true. */
async function holdable(page: Page): Promise<(hold: boolean) => Promise<void>> {
  await page.addInitScript(() => {
    const send: (this: Worker, ...sent: Parameters<Worker["postMessage"]>) => void = Worker.prototype.postMessage;
    const waiting: (() => void)[] = [];
    let held = false;
    Worker.prototype.postMessage = function (this: Worker, ...sent: unknown[]) {
      const go = () => send.apply(this, sent as Parameters<Worker["postMessage"]>);
      if (held) waiting.push(go);
      else go();
    };
    addEventListener("hold-worker", (event) => {
      held = (event as CustomEvent<boolean>).detail;
      if (!held) waiting.splice(0).forEach((go) => go());
    });
  });
  return (hold) => page.evaluate((detail) => void dispatchEvent(new CustomEvent("hold-worker", { detail })), hold);
}

/** The page plans by itself as soon as the planning part is loaded. */
const plans = (page: Page) =>
  page.waitForFunction(() =>
    performance.getEntriesByType("resource").some(({ name }) => /\/engine-[^/]+\.js$/.test(name)),
  );

test("a changed value moves the path at once, and an unverified result says that it is being checked", async ({
  page,
}) => {
  const hold = await holdable(page);
  const turnwise = await Turnwise.open(page);
  const { effect, dialog, lathe, t } = turnwise;
  await turnwise.start.beginWithExample(812);
  await effect.proved();
  await plans(page);
  await dialog.open("Q463");
  await dialog.value.fill("2");
  await effect.proved();
  await expect(effect.strip).toHaveAttribute("aria-busy", "false");
  const mark = effect.strip.getByRole("img", { name: t.lathe.checking });
  await expect(mark).toHaveCount(0);
  const drawn = () =>
    lathe.picture.locator(".lathe-paths path").evaluateAll((all) => all.map((path) => path.getAttribute("d")).join());
  const box = await effect.strip.boundingBox();
  let [passes, infeed]: readonly [string | null, number] = [null, 2.1];

  // On a busy machine a plan can take longer than the page waits for: retry.
  await expect(async () => {
    await hold(false);
    infeed -= 0.1;
    await dialog.value.fill(infeed.toFixed(1));
    await expect(effect.strip).toHaveAttribute("aria-busy", "false");
    passes = await effect.cell("passes").textContent();
    const path = await drawn();
    await hold(true);
    await dialog.value.fill("0.7");
    await expect.poll(drawn, { timeout: 2000 }).not.toBe(path);
  }).toPass();
  await expect(effect.cell("passes")).not.toHaveText(passes ?? "");
  await expect(effect.strip).toHaveAttribute("aria-busy", "true");
  await expect(mark).toBeVisible();
  await effect.proved();
  expect(await effect.strip.boundingBox()).toEqual(box);

  await hold(false);
  await expect(effect.strip).toHaveAttribute("aria-busy", "false");
  await expect(mark).toHaveCount(0);
  await effect.proved();
});

test.describe("at 1024x768", () => {
  test.use({ viewport: { width: 1024, height: 768 } });

  test("the picture keeps its size while the strip shows more or less", async ({ page }) => {
    const { editor, dialog, lathe, t } = await Turnwise.open(page);
    await editor.openFile("FLANGE.h", readFileSync("src/examples/flange.h"));
    await editor.show("structure");
    await editor.operation(2).click();
    await editor.show("block");
    await dialog.open("Q463");
    const strip = page.getByRole("region", { name: t.editor.total, exact: true });
    const sizes = async (value: string, says: RegExp) => {
      await dialog.value.fill(value);
      await expect(strip.locator(".proof dd")).toHaveText(says);
      await expect(strip).toHaveAttribute("aria-busy", "false");
      return (await lathe.picture.boundingBox())?.height;
    };
    expect(await sizes("0", /^\d+ /)).toBe(await sizes("2.5", provedIn(t)));
  });
});
