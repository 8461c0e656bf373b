import { mkdirSync, writeFileSync } from "node:fs";
import type { Browser, Page } from "@playwright/test";
import { encode } from "modern-gif";
import { frames } from "../e2e/pages/picture.ts";
import { Turnwise } from "../e2e/pages/turnwise.ts";
import { serveBuilt, startBrowser } from "./browser-bench/bench-page.ts";
import { seek } from "./browser-bench/measure-work.ts";
import { built } from "./built.ts";
import { SCREENSHOTS } from "./web-manifest.ts";

const FOLDER = "docs/pictures";
const SCREEN = { width: 1440, height: 900 };
const ANIMATION = { width: 1280, height: 800 };
/** A fixed clock and fixed names in each run: apart from smoothed edges, a picture changes only with the page. */
const HELD = { heldClock: "2026-11-27T09:00", seed: 8 };

/** The page for a new visitor. */
async function visit(
  browser: Browser,
  address: string,
  viewport: { readonly width: number; readonly height: number },
): Promise<Turnwise> {
  const context = await browser.newContext({ baseURL: address, viewport, locale: "en-US", serviceWorkers: "block" });
  return Turnwise.open(await context.newPage(), HELD);
}

/** Waits until the page is calculated and painted. */
async function rest({ page, lathe }: Turnwise): Promise<void> {
  await page.waitForFunction(() => document.querySelector(".working") === null);
  await page.waitForTimeout(600);
  await lathe.advance(400);
  await frames(page, 3);
}

/** Moves the tool to a fraction of the running time. */
async function moveTo(share: number, turnwise: Turnwise): Promise<void> {
  await seek({ turnwise }, share);
  await rest(turnwise);
}

/** The scene of each still picture, by file name. */
const STILLS: Readonly<Record<string, (turnwise: Turnwise) => Promise<void>>> = {
  async prompts(turnwise) {
    const { start, effect, dialog } = turnwise;
    await start.beginWithExample(812);
    await effect.proved();
    await dialog.open("Q463");
    await moveTo(0.42, turnwise);
  },
  async program(turnwise) {
    const { editor } = turnwise;
    await editor.openExample("shaft");
    await rest(turnwise);
    await editor.show("structure");
    await editor.operation(4).click();
    await moveTo(0.44, turnwise);
  },
  async course(turnwise) {
    const { course, lathe } = turnwise;
    await course.open();
    await course.openLesson(3);
    await course.page(2).click();
    await rest(turnwise);
    await lathe.advance(6000);
    await frames(turnwise.page, 3);
  },
  async solid(turnwise) {
    const { editor, lathe } = turnwise;
    await editor.openExample("shaft");
    await rest(turnwise);
    await lathe.shows("solid");
    await turnwise.page.waitForSelector(".solid-field > canvas");
    await moveTo(0.999, turnwise);
  },
};

/** Pictures for the manifest: a cycle on the lathe. */
const INSTALLED = "public/screenshots";
async function installed(turnwise: Turnwise): Promise<void> {
  const { start, effect } = turnwise;
  await start.beginWithExample(812);
  await effect.proved();
  await moveTo(0.42, turnwise);
}

/** A frame of an animation, with its duration, ms. */
interface Frame {
  readonly png: Buffer;
  readonly delay: number;
}

/** Types a value key by key, with the path following, and plays the program. */
async function film(turnwise: Turnwise): Promise<readonly Frame[]> {
  const { start, effect, dialog, lathe, page } = turnwise;
  const taken: { png: Buffer; delay: number }[] = [];
  const take = async (delay: number) => {
    const png = await page.screenshot({ animations: "allow", caret: "hide" });
    const last = taken.at(-1);
    if (last?.png.equals(png)) last.delay += delay;
    else taken.push({ png, delay });
  };
  const press = async (key: string, delay: number) => {
    await page.keyboard.press(key);
    await rest(turnwise);
    await take(delay);
  };
  await start.beginWithExample(812);
  await effect.proved();
  await dialog.open("Q463");
  await rest(turnwise);
  await take(1600);
  for (const [key, delay] of [
    ["ControlOrMeta+a", 0],
    ["1", 500],
    [".", 300],
    ["7", 1600],
    ["Enter", 900],
  ] as const)
    await press(key, delay);
  await lathe.speed.selectOption("10");
  await lathe.button("play").click();
  for (let at = 0; at < 120; at += 1) {
    await lathe.advance(100);
    await frames(page, 2);
    await take(100);
    if (await lathe.button("play").isVisible()) break;
  }
  await rest(turnwise);
  await take(2500);
  return taken;
}

/** The pixels of a picture, decoded by the browser. */
async function pixels(page: Page, png: Buffer): Promise<Uint8ClampedArray<ArrayBuffer>> {
  const decoded = await page.evaluate(async (base64) => {
    const response = await fetch(`data:image/png;base64,${base64}`);
    const bitmap = await createImageBitmap(await response.blob());
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const pen = canvas.getContext("2d");
    pen?.drawImage(bitmap, 0, 0);
    const { data } = pen?.getImageData(0, 0, bitmap.width, bitmap.height) ?? { data: new Uint8ClampedArray() };
    let text = "";
    for (let i = 0; i < data.length; i += 30_000) text += String.fromCharCode(...data.subarray(i, i + 30_000));
    return btoa(text);
  }, png.toString("base64"));
  return new Uint8ClampedArray(Buffer.from(decoded, "base64"));
}

/** `npm run pictures -- NAME …`: takes the pictures of the documents and of the manifest from the built page, all or those named. */
export async function main(names: readonly string[]): Promise<number> {
  const known = [...Object.keys(STILLS), ...Object.keys(SCREENSHOTS), "turnwise"];
  const strange = names.find((name) => !known.includes(name));
  if (strange !== undefined) throw new Error(`${strange} is none of: ${known.join(", ")}`);
  const isWanted = (name: string) => names.length === 0 || names.includes(name);
  mkdirSync(FOLDER, { recursive: true });
  const server = await serveBuilt(built());
  const browser = await startBrowser();
  try {
    for (const [name, show] of Object.entries(STILLS)) {
      if (!isWanted(name)) continue;
      const turnwise = await visit(browser, server.address, SCREEN);
      await show(turnwise);
      await turnwise.page.screenshot({ path: `${FOLDER}/${name}.png`, caret: "hide" });
      console.log(`${FOLDER}/${name}.png`);
      await turnwise.page.context().close();
    }
    for (const [form, size] of Object.entries(SCREENSHOTS)) {
      if (!isWanted(form)) continue;
      const turnwise = await visit(browser, server.address, size);
      await installed(turnwise);
      mkdirSync(INSTALLED, { recursive: true });
      await turnwise.page.screenshot({ path: `${INSTALLED}/${form}.jpg`, type: "jpeg", quality: 82, caret: "hide" });
      console.log(`${INSTALLED}/${form}.jpg`);
      await turnwise.page.context().close();
    }
    if (isWanted("turnwise")) {
      const taken = await film(await visit(browser, server.address, ANIMATION));
      const blank = await browser.newPage();
      const data: { data: Uint8ClampedArray<ArrayBuffer>; delay: number }[] = [];
      for (const { png, delay } of taken) data.push({ data: await pixels(blank, png), delay });
      const gif = await encode({ ...ANIMATION, frames: data, maxColors: 255 });
      writeFileSync(`${FOLDER}/turnwise.gif`, Buffer.from(gif));
      const seconds = taken.reduce((sum, { delay }) => sum + delay, 0) / 1000;
      console.log(
        `${FOLDER}/turnwise.gif: ${taken.length} frames, ${seconds} s, ${Math.round(gif.byteLength / 1024)} kB`,
      );
    }
    return 0;
  } finally {
    await browser.close();
    server.close();
  }
}
