import { Monkey, WORLDS } from "./pages/monkey.ts";
import { expect, test } from "./pages/test.ts";

/*
 * Random presses over all screens, languages and sizes. `npm run monkey -- --presses=3000 --seed=7` runs longer ones;
 * a seed shows the same choices again as far as the page is as fast. What it finds becomes a journey or a unit test.
 */
const presses = Number(process.env["MONKEY_PRESSES"] ?? 48);
const seed = Number(process.env["MONKEY_SEED"] ?? 1);
/** Windows and languages of a run: all of them where there is time for it. */
const worlds = WORLDS.slice(0, Math.min(WORLDS.length, Math.ceil(presses / 12)));
/** Room for a press on a slow machine, ms. */
const PRESS = 6_000;
/** What a page may hold more at the end than in the middle of a run: by then it has fetched most of its parts. */
const MOST_GROWTH = { megabytes: 15, nodes: 8000 };

test(`${presses} random presses with seed ${seed} leave the page whole`, async ({ page }) => {
  test.setTimeout(test.info().timeout + presses * PRESS);
  const monkey = await Monkey.on(page, seed);
  const held = [];
  for (const [i, [language, size]] of worlds.entries()) {
    await monkey.enter(language, size);
    const count = Math.round((presses * (i + 1)) / worlds.length) - Math.round((presses * i) / worlds.length);
    for (let n = 0; n < count; n += 1) await monkey.press();
    held.push(await monkey.held());
  }
  if (presses > 500) console.log(JSON.stringify({ seed, held, findings: monkey.findings }, null, 1));
  expect(monkey.findings, `seed ${seed}`).toEqual([]);
  const [first, last] = [held[Math.floor(worlds.length / 2)], held.at(-1)];
  expect((last?.megabytes ?? 0) - (first?.megabytes ?? 0), `seed ${seed}`).toBeLessThan(MOST_GROWTH.megabytes);
  expect((last?.nodes ?? 0) - (first?.nodes ?? 0), `seed ${seed}`).toBeLessThan(MOST_GROWTH.nodes);
});
