import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { chromium, type Browser, type BrowserContext, type Page } from "@playwright/test";
import { Turnwise } from "../../e2e/pages/turnwise.ts";
import { browserFlags, findBrowser } from "../browser.mjs";
import { middle, referenceWork } from "../reference.ts";
import { site } from "../serve.mjs";
import { watchDrawing } from "./in-page.ts";
import type { Screen } from "./screens.ts";

const EMPTY = "/empty.html";

/** Serves a built page, and an empty page for comparison. */
export async function serveBuilt(folder: string): Promise<{ readonly address: string; readonly close: () => void }> {
  const answer = site(folder);
  const server = createServer((request, response) => {
    if (request.url !== EMPTY) return void answer(request, response).catch(() => response.destroy());
    response.writeHead(200, { "Content-Type": "text/html; charset=utf-8" }).end("<!doctype html><title>empty</title>");
  });
  await new Promise<void>((done) => server.listen(0, "127.0.0.1", done));
  return { address: `http://127.0.0.1:${(server.address() as AddressInfo).port}/`, close: () => server.close() };
}

/** Chromium with the flags of the e2e tests. */
export function startBrowser(): Promise<Browser> {
  const executablePath = process.env["CHROMIUM_PATH"] ?? findBrowser();
  return chromium.launch({ args: browserFlags, ...(executablePath ? { executablePath } : {}) });
}

/** Returns a function that slows down the processor of a page; 1 is full speed. */
async function slowing(page: Page): Promise<(rate: number) => Promise<void>> {
  const session = await page.context().newCDPSession(page);
  return async (rate) => void (await session.send("Emulation.setCPUThrottlingRate", { rate }));
}

/** The page on a screen, and the empty page for comparison. */
export interface Bench {
  readonly context: BrowserContext;
  readonly page: Page;
  readonly turnwise: Turnwise;
  readonly empty: Page;
  /**
   * Slows down the page as the screen requires, or the empty page: a slowed page takes a core even in the background.
   */
  readonly slow: (which: "page" | "empty") => Promise<void>;
}

/** Timeout for a slow page on a busy machine, ms. */
const PATIENCE = 300_000;

/**
 * Opens the page and the empty page. `watched`: records what is drawn after a key, at a small cost; frames are counted
 * without it.
 */
export async function openBench(browser: Browser, address: string, screen: Screen, watched: boolean): Promise<Bench> {
  const { width, height, pixels, touch, slower } = screen;
  const context = await browser.newContext({
    baseURL: address,
    viewport: { width, height },
    deviceScaleFactor: pixels,
    hasTouch: touch,
    locale: "en-US",
    serviceWorkers: "block",
  });
  context.setDefaultTimeout(PATIENCE);
  const empty = await context.newPage();
  await empty.goto(EMPTY);
  const page = await context.newPage();
  if (watched) await page.addInitScript(watchDrawing);
  const turnwise = await Turnwise.open(page);
  const rates = { page: await slowing(page), empty: await slowing(empty) };
  return {
    context,
    page,
    turnwise,
    empty,
    async slow(which) {
      await rates[which === "page" ? "empty" : "page"](1);
      await rates[which](slower);
    },
  };
}

/** Duration of the reference loop in a page, ms: the median of three. */
export async function referenceIn(page: Page): Promise<number> {
  const times: number[] = [];
  // As text, because the page's content policy forbids making functions from text.
  const timed = `(() => { const work = ${String(
    referenceWork,
  )}; const began = performance.now(); work(); return performance.now() - began; })()`;
  for (let round = 0; round < 3; round += 1) times.push(await page.evaluate<number>(timed));
  return middle(times);
}
