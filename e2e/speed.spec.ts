import { editTimes, heap, quantile } from "./pages/measure.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

// As most users see the page, with what moves.
test.use({ reducedMotion: "no-preference" });

/*
 * Every changed value has to reach the picture. The times are printed, not judged: they depend on the machine more than
 * on the page (docs/performance.md has times of a quiet one). Only results that do not depend on the machine are
 * judged.
 */
test.describe.configure({ mode: "serial" });

/** Edits per measurement of time and of memory. */
const EDITS = Number(process.env["EDITS"] ?? 20);
const MANY = 200;
/** Edits until compiled code and caches have their size: the first 300 leave 3 MB, whatever comes after them. */
const WARM = 300;
/** Allowed growth of memory, bytes: 10 kB for each edit. */
const GROWTH = MANY * 10_000;

/** Oversizes that all differ, so that every one moves the path. */
const oversizes = (count: number, from = 0) =>
  Array.from({ length: count }, (_, i) => (0.1 + (i + from) / 1000).toFixed(3));

for (const cycle of [812, 820, 852]) {
  test(`a changed value of ${cycle} is a new picture`, async ({ page }) => {
    const turnwise = await Turnwise.open(page);
    await turnwise.start.beginWithExample(cycle);
    await turnwise.effect.proved();
    await turnwise.dialog.open("Q484");
    await editTimes(turnwise, oversizes(10));
    const times = await editTimes(turnwise, oversizes(EDITS, 10));
    const [median, late] = [quantile(times, 0.5), quantile(times, 0.95)];
    console.log(`update ${cycle} in Chromium: median ${median.toFixed(1)} ms, p95 ${late.toFixed(1)} ms`);
    expect(times).toHaveLength(EDITS);
  });
}

test(`memory does not grow over ${MANY} edits`, async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  await turnwise.start.beginWithExample(812);
  await turnwise.effect.proved();
  await turnwise.dialog.open("Q484");
  await editTimes(turnwise, oversizes(WARM));
  const before = await heap(page);
  await editTimes(turnwise, oversizes(MANY, WARM));
  const growth = (await heap(page)) - before;
  console.log(`${MANY} edits leave ${(growth / 1e6).toFixed(2)} MB of ${(before / 1e6).toFixed(1)} MB`);
  expect(growth).toBeLessThan(GROWTH);
});
