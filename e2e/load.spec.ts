import { gzipSync } from "node:zlib";
import { expect, test } from "@playwright/test";
import { Turnwise } from "./pages/turnwise.ts";

/** Compressed JavaScript of the first load, kB of 1000 bytes. */
const LIMIT = 250;
/** From the request to a page that can be used, on a slow shared machine with others at work, ms. */
const INTERACTIVE = 3000;

test("the first load is small, quick, and asks no other host", async ({ page, baseURL }) => {
  const scripts: Promise<number>[] = [];
  const foreign: string[] = [];
  const complaints: string[] = [];
  page.on("console", (message) => message.type() === "error" && complaints.push(message.text()));
  page.on("pageerror", (error) => complaints.push(error.message));
  page.on("request", (request) => {
    if (!request.url().startsWith(baseURL ?? "") && !/^(data|blob):/.test(request.url())) foreign.push(request.url());
  });
  page.on("response", (response) => {
    if (/\.js(\?|$)/.test(response.url())) scripts.push(response.body().then((body) => gzipSync(body).length));
  });
  const began = performance.now();
  const turnwise = await Turnwise.open(page);
  await expect(turnwise.start.button(812, true)).toBeEnabled();
  const took = performance.now() - began;
  const size = (await Promise.all(scripts)).reduce((sum, bytes) => sum + bytes, 0) / 1000;
  await turnwise.start.beginWithExample(812);
  await expect(turnwise.effect.cell("proof")).toHaveText(turnwise.t.page.effect.clean);
  test.info().annotations.push({ type: "measured", description: `${size.toFixed(1)} kB, usable after ${took.toFixed(0)} ms` });
  expect(complaints).toEqual([]);
  expect(foreign).toEqual([]);
  expect(size).toBeGreaterThan(30);
  expect(size).toBeLessThan(LIMIT);
  expect(took).toBeLessThan(INTERACTIVE);
});
