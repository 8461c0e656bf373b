import { quantile } from "../../e2e/pages/measure.ts";
import { middle } from "../reference.ts";
import { referenceIn, type Bench } from "./bench-page.ts";
import { countFrames, drawnAfterKey, moveBox, removeBox, type Frames } from "./in-page.ts";
import type { BenchOptions } from "./options.ts";
import type { Screen } from "./screens.ts";
import type { MeasuredWork } from "./works.ts";

/** Frames of the page compared with the empty page: the median of all rounds, and the worst. */
export interface FrameResult {
  /** Frames per second of the empty page, and of the measured page. */
  readonly empty: number;
  readonly perSecond: number;
  /** Frames as a share of the empty page's, median of the rounds. */
  readonly share: number;
  readonly p95: number;
  readonly worst: number;
  /** Number of tasks of more than 50 ms in all rounds, and the longest of them. */
  readonly long: number;
  readonly longest: number;
}

/** Times from a key to the drawing, ms, and the duration of the reference loop in the same page. */
export interface KeyResult {
  readonly reference: number;
  /** Time to the frame that shows the digit itself. */
  readonly digit: { readonly median: number; readonly p95: number };
  readonly path: { readonly median: number; readonly p95: number };
  readonly picture: { readonly median: number; readonly p95: number };
  readonly keys: number;
  /**
   * Number of tasks of more than 50 ms between a key and the complete picture, over all keys, and the longest of them.
   */
  readonly long: number;
  readonly longest: number;
}

/** All measurements on one screen. */
export interface ScreenResults {
  readonly screen: Screen;
  /** A page with nothing but a moving box. */
  readonly box: FrameResult | null;
  /** By program and case: "flange 10x". */
  readonly frames: Readonly<Record<string, FrameResult>>;
  /** By program. */
  readonly keys: Readonly<Record<string, KeyResult>>;
}

/**
 * Duration of a baseline measurement, ms. The empty page is measured before and after each round, so that other load on
 * the machine affects both.
 */
const BASELINE_MS = 1200;
/** Time to settle after a click, ms. */
const SETTLE = 400;

/** The frame rate of the empty page. A page in the background gets one frame per second, so it must be in front. */
async function measureBaseline({ empty, slow }: Bench): Promise<number> {
  await empty.bringToFront();
  await slow("empty");
  return (await empty.evaluate(countFrames, BASELINE_MS)).perSecond;
}

async function paired(
  bench: Bench,
  options: BenchOptions,
  act: (round: number) => Promise<() => Promise<void>>,
): Promise<FrameResult> {
  const rounds: { readonly empty: number; readonly frames: Frames }[] = [];
  let before = await measureBaseline(bench);
  for (let round = 0; round < options.rounds; round += 1) {
    await bench.page.bringToFront();
    await bench.slow("page");
    const end = await act(round);
    const frames = await bench.page.evaluate(countFrames, options.seconds * 1000);
    await end();
    const after = await measureBaseline(bench);
    rounds.push({ empty: (before + after) / 2, frames });
    before = after;
  }
  const long = rounds.flatMap(({ frames }) => frames.long);
  return {
    empty: middle(rounds.map((each) => each.empty)),
    perSecond: middle(rounds.map(({ frames }) => frames.perSecond)),
    share: middle(rounds.map((each) => each.frames.perSecond / each.empty)),
    p95: middle(rounds.map(({ frames }) => frames.p95)),
    worst: Math.max(...rounds.map(({ frames }) => frames.worst)),
    long: long.length,
    longest: Math.max(0, ...long),
  };
}

/**
 * The best possible frame rate while something is drawn: a page with only a moving box, compared with the empty page.
 */
export async function measureBox(bench: Bench, options: BenchOptions): Promise<FrameResult> {
  const box = { ...bench, page: bench.empty, slow: () => bench.slow("empty") };
  return paired(box, { ...options, rounds: Math.min(3, options.rounds) }, async () => {
    await bench.empty.evaluate(moveBox);
    return () => bench.empty.evaluate(removeBox);
  });
}

/** Moves the tool to a fraction of the running time. */
export async function seek({ turnwise }: Pick<Bench, "turnwise">, part: number): Promise<void> {
  await turnwise.lathe.timeline.evaluate((input: HTMLInputElement, value) => {
    Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")?.set?.call(input, String(value * 1000));
    input.dispatchEvent(new Event("input", { bubbles: true }));
  }, part);
}

/** Frames while a program plays at a multiple of machine speed, each round from another position. */
export async function measurePlaying(
  bench: Bench,
  work: MeasuredWork,
  rate: number,
  options: BenchOptions,
): Promise<FrameResult> {
  const {
    page,
    turnwise: { lathe },
  } = bench;
  await lathe.speed.selectOption(String(rate));
  const result = await paired(bench, options, async (round) => {
    await seek(bench, work.from[round % work.from.length] ?? 0);
    await lathe.button("play").click();
    await page.waitForTimeout(SETTLE);
    return async () => {
      if (await lathe.button("play").isVisible())
        throw new Error(`${work.name} came to its end while it was measured at ${rate}x`);
      await lathe.button("pause").click();
    };
  });
  return result;
}

/** Runs a measurement in the 3D view, then restores the section. */
async function inSpace<Result>({ page, turnwise: { lathe } }: Bench, measure: () => Promise<Result>): Promise<Result> {
  await lathe.shows("solid");
  await page.waitForSelector(".solid-field > canvas");
  // The library is fetched, and its shaders are compiled, with the first picture.
  await page.waitForTimeout(5 * SETTLE);
  const result = await measure();
  await lathe.shows("half");
  return result;
}

/** Frames while a program plays in the 3D view. */
export const measureSpace = (
  bench: Bench,
  work: MeasuredWork,
  rate: number,
  options: BenchOptions,
): Promise<FrameResult> => inSpace(bench, () => measurePlaying(bench, work, rate, options));

/** Frames while the body is turned by hand, paused in the middle of the program. */
export const measureOrbit = (bench: Bench, work: MeasuredWork, options: BenchOptions): Promise<FrameResult> =>
  inSpace(bench, () => measureLooking(bench, work, "orbit", options));

/** Repeats a step until the returned function is called. */
function repeatUntilStopped(step: (count: number) => Promise<void>): () => Promise<void> {
  let goes = true;
  const done = (async () => {
    for (let count = 0; goes; count += 1) await step(count);
  })();
  return () => {
    goes = false;
    return done;
  };
}

/** Frames while the picture is dragged, turned or zoomed, paused in the middle of the program. */
export async function measureLooking(
  bench: Bench,
  work: MeasuredWork,
  how: "pan" | "zoom" | "orbit",
  options: BenchOptions,
): Promise<FrameResult> {
  const {
    page,
    turnwise: { lathe },
  } = bench;
  await seek(bench, work.from[2] ?? 0);
  const box = await (how === "orbit" ? page.locator(".solid-field") : lathe.picture).boundingBox();
  if (!box) throw new Error("there is no picture");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const result = await paired(bench, options, async () => {
    await page.mouse.move(x, y);
    if (how !== "zoom") await page.mouse.down();
    const stop = repeatUntilStopped((count) =>
      how !== "zoom"
        ? page.mouse.move(x + 80 * Math.sin(count / 9), y + 50 * Math.cos(count / 7))
        : page.mouse.wheel(0, Math.floor(count / 24) % 2 === 0 ? -60 : 60),
    );
    await page.waitForTimeout(SETTLE);
    return async () => {
      await stop();
      if (how !== "zoom") await page.mouse.up();
    };
  });
  await page.keyboard.press("Escape");
  return result;
}

/**
 * A picture is complete after this period without activity, longer than the page's debounce of typing; `patience` is
 * the timeout, ms.
 */
const QUIET = { quiet: 900, patience: 60_000 };

/**
 * From a pressed key to the new path, and to the complete new picture: at the end of the program, where its stock shows
 * every change.
 */
export async function measureKeys(bench: Bench, work: MeasuredWork, options: BenchOptions): Promise<KeyResult> {
  const { page, turnwise } = bench;
  await work.ask(turnwise);
  await turnwise.lathe.button("last").click();
  await turnwise.dialog.value.fill("0.1");
  await bench.slow("page");
  const digits: number[] = [],
    paths: number[] = [],
    pictures: number[] = [],
    references: number[] = [],
    long: number[] = [];
  for (let key = -2; key < options.keys; key += 1) {
    if (key % 4 === 0) references.push(await referenceIn(page));
    await page.keyboard.press(key % 2 === 0 ? String(3 + (Math.abs(key) % 7)) : "Backspace");
    const { digit, path, picture, tasks } = await page.evaluate(drawnAfterKey, QUIET);
    if (key < 0) continue;
    long.push(...tasks);
    digits.push(digit ?? Number.NaN);
    paths.push(path ?? Number.NaN);
    pictures.push(picture ?? Number.NaN);
  }
  if (paths.some(Number.isNaN)) throw new Error(`a key in ${work.name} drew no other path`);
  const of = (times: readonly number[]) => ({ median: middle(times), p95: quantile(times, 0.95) });
  return {
    reference: middle(references),
    digit: of(digits),
    path: of(paths),
    picture: of(pictures),
    keys: paths.length,
    long: long.length,
    longest: Math.max(0, ...long),
  };
}
