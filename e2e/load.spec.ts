import { gzipSync } from "node:zlib";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

// As most users see the page, with what moves.
test.use({ reducedMotion: "no-preference" });

/**
 * Compressed JavaScript, kB of 1000 bytes: the first load, whose own limit the build is held to, and the lathe of the
 * start page, which comes before or after the first button by chance.
 */
const LIMIT = 165;
/** Of files of any kind. */
const MOST_REQUESTS = 25;

test("the first load is small, and asks no other host", async ({ page, baseURL }) => {
  const scripts: Promise<number>[] = [];
  const foreign: string[] = [];
  const complaints: string[] = [];
  let isFirst = true;
  let requests = 0;
  // What the browser prefetches when idle is no part of the first load.
  await page.addInitScript(() => {
    window.requestIdleCallback = () => 0;
  });
  page.on("console", (message) => message.type() === "error" && complaints.push(message.text()));
  page.on("pageerror", (error) => complaints.push(error.message));
  page.on("request", (request) => {
    if (!request.url().startsWith(baseURL ?? "") && !/^(data|blob):/.test(request.url())) foreign.push(request.url());
  });
  page.on("response", (response) => {
    if (isFirst) requests += 1;
    if (isFirst && /\.js(\?|$)/.test(response.url()))
      scripts.push(response.body().then((body) => gzipSync(body).length));
  });
  const turnwise = await Turnwise.open(page);
  await expect(turnwise.start.button(812, true)).toBeEnabled();
  const size = (await Promise.all(scripts)).reduce((sum, bytes) => sum + bytes, 0) / 1000;
  isFirst = false;
  await turnwise.start.beginWithExample(812);
  await turnwise.effect.proved();
  console.log(`first load: ${size.toFixed(1)} kB of scripts, ${requests} requests`);
  expect(complaints).toEqual([]);
  expect(foreign).toEqual([]);
  expect(size).toBeGreaterThan(30);
  expect(size).toBeLessThan(LIMIT);
  expect(requests).toBeLessThanOrEqual(MOST_REQUESTS);
});
