import { editTimes, heap } from "./pages/measure.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

// As most users see the page, with what moves.
test.use({ reducedMotion: "no-preference" });

/* Every changed value has to reach the picture. How fast it does depends on the machine: the browser bench measures it. */

/** Edits whose memory is measured, twice; EDITS=number measures more. */
const EDITS = Number(process.env["EDITS"] ?? 50);
/** Edits until compiled code and caches have their size: the first 80 leave 5 MB, later ones 7 kB each. */
const WARM = 100;
/** Allowed growth of memory, bytes: 12 kB for each edit. */
const GROWTH = EDITS * 12_000;

/** Oversizes that all differ, so that every one moves the path. */
const oversizes = (count: number, from = 0) =>
  Array.from({ length: count }, (_, i) => (0.1 + (i + from) / 1000).toFixed(3));

test("each changed value is a new picture, and memory does not grow with them", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  await turnwise.start.beginWithExample(812);
  await turnwise.effect.proved();
  await turnwise.dialog.open("Q484");
  await editTimes(turnwise, oversizes(WARM));
  const sizes = [await heap(page)];
  for (const round of [0, 1]) {
    await editTimes(turnwise, oversizes(EDITS, WARM + round * EDITS));
    sizes.push(await heap(page));
  }
  console.log(`MB before and after ${EDITS} edits each: ${sizes.map((size) => (size / 1e6).toFixed(2)).join(", ")}`);
  const [first = 0, second = 0, third = 0] = sizes;
  // What is compiled late shows in one round, what is kept for each edit in both.
  expect(Math.min(second - first, third - second)).toBeLessThan(GROWTH);
});
