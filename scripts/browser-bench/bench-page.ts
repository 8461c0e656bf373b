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

/** Serves a built page, and beside it one that is empty. */
export async function serveBuilt(folder: string): Promise<{ readonly address: string; readonly close: () => void }> {
  const answer = site(folder);
  const server = createServer((request, response) => {
    if (request.url !== EMPTY) return void answer(request, response).catch(() => response.destroy());
    response.writeHead(200, { "Content-Type": "text/html; charset=utf-8" }).end("<!doctype html><title>empty</title>");
  });
  await new Promise<void>((done) => server.listen(0, "127.0.0.1", done));
  return { address: `http://127.0.0.1:${(server.address() as AddressInfo).port}/`, close: () => server.close() };
}

/** Chromium as the journeys start it. */
export function startBrowser(): Promise<Browser> {
  const executablePath = process.env["CHROMIUM_PATH"] ?? findBrowser();
  return chromium.launch({ args: browserFlags, ...(executablePath ? { executablePath } : {}) });
}

/** How to make the processor of a page slower; 1 is full speed. */
async function slowing(page: Page): Promise<(rate: number) => Promise<void>> {
  const session = await page.context().newCDPSession(page);
  return async (rate) => void (await session.send("Emulation.setCPUThrottlingRate", { rate }));
}

/** The page on a screen, and the empty one beside it. */
export interface Bench {
  readonly context: BrowserContext;
  readonly page: Page;
  readonly turnwise: Turnwise;
  readonly empty: Page;
  /**
   * Makes the page as slow as the screen says, or the empty one in its place: a slowed page takes a core, also behind
   * another.
   */
  readonly slow: (which: "page" | "empty") => Promise<void>;
}

/** Room for a slow page on a busy machine, ms. */
const PATIENCE = 300_000;

/**
 * Opens the page and the empty one. `watched`: it notes what is drawn after a key, which costs a little; frames are
 * counted without.
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

/** How long the reference loop takes in a page, ms: the middle one of three. */
export async function referenceIn(page: Page): Promise<number> {
  const times: number[] = [];
  // As text: the page may not make functions out of text itself.
  const timed = `(() => { const work = ${String(
    referenceWork,
  )}; const began = performance.now(); work(); return performance.now() - began; })()`;
  for (let round = 0; round < 3; round += 1) times.push(await page.evaluate<number>(timed));
  return middle(times);
}
