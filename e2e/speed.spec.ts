import { editTimes, heap } from "./pages/measure.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

// As most users see the page, with what moves.
test.use({ reducedMotion: "no-preference" });

/* Every changed value has to reach the picture. How fast it does depends on the machine: the browser bench measures it. */

/** Edits whose memory is measured; EDITS=number measures more. */
const EDITS = Number(process.env["EDITS"] ?? 100);
/** Edits until compiled code and caches have their size: the first 80 leave 5 MB, later ones 7 kB each. */
const WARM = 120;
/** Allowed growth of memory, bytes: 10 kB for each edit. */
const GROWTH = EDITS * 10_000;

/** Oversizes that all differ, so that every one moves the path. */
const oversizes = (count: number, from = 0) =>
  Array.from({ length: count }, (_, i) => (0.1 + (i + from) / 1000).toFixed(3));

test("each changed value is a new picture, and memory does not grow with them", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  await turnwise.start.beginWithExample(812);
  await turnwise.effect.proved();
  await turnwise.dialog.open("Q484");
  await editTimes(turnwise, oversizes(WARM));
  const before = await heap(page);
  await editTimes(turnwise, oversizes(EDITS, WARM));
  const growth = (await heap(page)) - before;
  console.log(`${EDITS} edits leave ${(growth / 1e6).toFixed(2)} MB of ${(before / 1e6).toFixed(1)} MB`);
  expect(growth).toBeLessThan(GROWTH);
});
