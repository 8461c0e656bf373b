import { cpus } from "node:os";
import type { Browser } from "@playwright/test";
import { openBench, serveBuilt, startBrowser, type Bench } from "./browser-bench/bench-page.ts";
import {
  measureBox,
  measureKeys,
  measureLooking,
  measureOrbit,
  measurePlaying,
  measureSpace,
  type FrameResult,
  type KeyResult,
  type ScreenResults,
} from "./browser-bench/measure-work.ts";
import { readOptions, type BenchOptions, type CaseName } from "./browser-bench/options.ts";
import type { Screen } from "./browser-bench/screens.ts";
import { writeIntoPage } from "./performance-page.ts";
import { frameTable, keyTable } from "./browser-bench/tables.ts";
import type { MeasuredWork } from "./browser-bench/works.ts";
import { built } from "./built.ts";

function measureCase(
  bench: Bench,
  work: MeasuredWork,
  name: Exclude<CaseName, "key">,
  options: BenchOptions,
): Promise<FrameResult> {
  switch (name) {
    case "1x":
      return measurePlaying(bench, work, 1, options);
    case "10x":
      return measurePlaying(bench, work, 10, options);
    case "3d":
      return measureSpace(bench, work, 10, options);
    case "orbit":
      return measureOrbit(bench, work, options);
    case "pan":
    case "zoom":
      return measureLooking(bench, work, name, options);
  }
}

/** The calculation is finished when the timeline is enabled and no progress is shown. */
async function openWork({ page, turnwise }: Bench, work: MeasuredWork): Promise<void> {
  await work.open(turnwise);
  await page.waitForFunction(
    () => document.querySelector<HTMLInputElement>(".lathe-timeline input")?.disabled === false,
  );
  await page.waitForFunction(() => document.querySelector(".working") === null);
  await page.waitForTimeout(1500);
}

/** Announces a measurement before its result, so that a long run that ends early has shown something. */
const begin = (what: string) => void process.stderr.write(what);
const say = (result: string) => void process.stderr.write(`${result}\n`);

async function measureScreen(
  browser: Browser,
  address: string,
  screen: Screen,
  options: BenchOptions,
): Promise<ScreenResults> {
  const frames: Record<string, FrameResult> = {},
    keys: Record<string, KeyResult> = {};
  let box: FrameResult | null = null;
  for (const work of options.works) {
    const counted = options.cases.filter((name) => name !== "key");
    if (counted.length > 0) {
      const bench = await openBench(browser, address, screen, false);
      await openWork(bench, work);
      box ??= await measureBox(bench, options);
      for (const name of counted) {
        begin(`${screen.name}: ${work.name} ${name} … `);
        const { share, perSecond, empty, worst, long } = (frames[`${work.name} ${name}`] = await measureCase(
          bench,
          work,
          name,
          options,
        ));
        say(
          `${Math.round(share * 100)} % (${perSecond.toFixed(1)} of ${empty.toFixed(1)} a second, worst ${worst.toFixed(
            0,
          )} ms, ${long} long tasks)`,
        );
      }
      await bench.context.close();
    }
    if (options.cases.includes("key")) {
      begin(`${screen.name}: ${work.name} key … `);
      const bench = await openBench(browser, address, screen, true);
      await openWork(bench, work);
      const { digit, path, picture, long } = (keys[work.name] = await measureKeys(bench, work, options));
      say(
        `digit ${digit.median.toFixed(0)} ms, path ${path.median.toFixed(0)} ms, stock ${picture.median.toFixed(0)} ms, ${long} long tasks`,
      );
      await bench.context.close();
    }
  }
  return { screen, box, frames, keys };
}

/**
 * `npm run bench:browser`: frame rates of the built page in Chromium on several screens, compared with an empty page,
 * and times from a key to the drawing. All of it takes half an hour. One case takes seconds:
 *
 *     npm run --silent bench:browser -- --quick --screen="1440x900 slow" --work=flange --case=10x
 *
 * `--screen`, `--work` and `--case` take names or parts of them, separated by commas; `--rounds`, `--seconds` and
 * `--keys` set the amount, `--quick` a small one; `--built=FOLDER` measures another build; `--json` prints one object
 * instead of the Markdown tables; `--write` also updates docs/performance.md.
 */
export async function main(args: readonly string[]): Promise<number> {
  const options = readOptions(args);
  const server = await serveBuilt(options.built ?? built());
  const browser = await startBrowser();
  try {
    const results: ScreenResults[] = [];
    for (const screen of options.screens) results.push(await measureScreen(browser, server.address, screen, options));
    const about = { processor: cpus()[0]?.model ?? "", cores: cpus().length, chromium: browser.version() };
    const lines = [
      `${about.processor}, ${about.cores} cores, Chromium ${about.chromium}:`,
      ...frameTable(results),
      ...keyTable(results),
    ];
    if (options.isWritten) writeIntoPage("bench:browser", lines);
    console.log(options.isJson ? JSON.stringify({ ...about, screens: results }) : lines.join("\n"));
    return 0;
  } finally {
    await browser.close();
    server.close();
  }
}
