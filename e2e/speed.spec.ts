import { expect, test } from "@playwright/test";
import { editTimes, heap, quantile } from "./pages/measure.ts";
import { Turnwise } from "./pages/turnwise.ts";

test.describe.configure({ mode: "serial" });

/** Far above what is measured (docs/performance.md): this machine may have other work at the same time. */
const SLOWEST = 100;
/** Growth that 1,000 edits may leave behind: the steps of undo, and what the browser keeps, bytes. */
const GROWTH = 8_000_000;

/** Oversizes, each another one: every one moves the path. */
const oversizes = (count: number, from = 0) => Array.from({ length: count }, (_, i) => (0.1 + ((i + from) % 300) / 1000).toFixed(3));

for (const cycle of [812, 820, 852]) {
  test(`a changed value of ${cycle} is a new picture at once`, async ({ page }) => {
    const turnwise = await Turnwise.open(page);
    await turnwise.start.beginWithExample(cycle);
    await expect(turnwise.effect.cell("proof")).toHaveText(turnwise.t.page.effect.clean);
    await turnwise.dialog.open("Q484");
    await editTimes(turnwise, oversizes(15));
    const times = await editTimes(turnwise, oversizes(60, 15));
    const [median, late] = [quantile(times, 0.5), quantile(times, 0.95)];
    test.info().annotations.push({ type: "measured", description: `update ${cycle}: median ${median.toFixed(1)} ms, p95 ${late.toFixed(1)} ms` });
    console.log(`update ${cycle} in Chromium: median ${median.toFixed(1)} ms, p95 ${late.toFixed(1)} ms`);
    expect(median).toBeLessThan(SLOWEST);
  });
}

test("memory does not grow over 1,000 edits", async ({ page }) => {
  test.setTimeout(180_000);
  const turnwise = await Turnwise.open(page);
  await turnwise.start.beginWithExample(812);
  await expect(turnwise.effect.cell("proof")).toHaveText(turnwise.t.page.effect.clean);
  await turnwise.dialog.open("Q484");
  await editTimes(turnwise, oversizes(200));
  const before = await heap(page);
  await editTimes(turnwise, oversizes(1000, 200));
  const growth = (await heap(page)) - before;
  console.log(`1,000 edits leave ${(growth / 1e6).toFixed(2)} MB of ${(before / 1e6).toFixed(1)} MB`);
  expect(growth).toBeLessThan(GROWTH);
});
