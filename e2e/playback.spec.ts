import { frames } from "./pages/picture.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

test.use({ reducedMotion: "no-preference" });

/**
 * The painted material, one letter for each small square of the canvas, so that rounding of single edge pixels does not
 * count.
 */
const stock = (turnwise: Turnwise) =>
  turnwise.lathe.picture.locator("canvas.material").evaluate((element) => {
    const { width, height } = element as HTMLCanvasElement,
      side = 4;
    const pixels = (element as HTMLCanvasElement).getContext("2d")?.getImageData(0, 0, width, height).data ?? [];
    let squares = "";
    for (let y = 0; y + side <= height; y += side) {
      for (let x = 0; x + side <= width; x += side) {
        let covered = 0;
        for (let i = 0; i < side * side; i += 1)
          covered += pixels[4 * ((y + Math.floor(i / side)) * width + x + (i % side)) + 3] ?? 0;
        squares += covered > side * side * 128 ? "#" : ".";
      }
    }
    return squares;
  });

/** Shading of the material, or of another canvas: the mean of each square. */
const shades = (turnwise: Turnwise, canvas = "canvas.material") =>
  turnwise.lathe.picture.locator(canvas).evaluate((element) => {
    const { width, height } = element as HTMLCanvasElement,
      side = 12;
    const pen = new OffscreenCanvas(width, height).getContext("2d");
    pen?.drawImage(element as HTMLCanvasElement, 0, 0);
    const pixels = pen?.getImageData(0, 0, width, height).data ?? [];
    const squares: number[] = [];
    for (let y = 0; y + side <= height; y += side) {
      for (let x = 0; x + side <= width; x += side) {
        let sum = 0;
        for (let i = 0; i < side * side; i += 1)
          sum += pixels[4 * ((y + Math.floor(i / side)) * width + x + (i % side))] ?? 0;
        squares.push(sum / (side * side));
      }
    }
    return squares;
  });

/** Squares whose shading differs between two pictures. */
const differing = (one: readonly number[], other: readonly number[]) =>
  one.filter((v, i) => Math.abs(v - (other[i] ?? 0)) > 6).length;

test("playing with a manual clock; playing, stepping and seeking show the same stock, in each view", async ({
  page,
}) => {
  const turnwise = await Turnwise.open(page, { heldClock: true });
  const { lathe, program, effect, t } = turnwise;
  await turnwise.start.beginWithExample(812);
  await effect.proved();
  await lathe.button("play").click();
  const before = await lathe.timeline.inputValue();
  await frames(page, 6);
  expect(await lathe.timeline.inputValue()).toBe(before);
  await lathe.advance(5000);
  await expect.poll(async () => Number(await lathe.timeline.inputValue())).toBeGreaterThan(Number(before));
  await lathe.button("pause").click();
  for (let i = 0; i < 40 && !/Step 2 of 6/.test((await lathe.running.textContent()) ?? ""); i += 1)
    await lathe.button("forward").click();
  await expect(lathe.running).toContainText("Step 2 of 6");
  await expect(program.runningBlock).toContainText("CYCL CALL");

  await lathe.button("first").click();
  for (let i = 0; i < 12; i += 1) await lathe.button("forward").click();
  await lathe.advance(50);
  const stepped = await stock(turnwise);
  const place = await lathe.timeline.inputValue();
  await lathe.button("last").click();
  await lathe.advance(50);
  expect(await stock(turnwise)).not.toBe(stepped);
  await lathe.timeline.fill(place);
  await lathe.advance(50);
  const sought = await stock(turnwise);
  await lathe.button("first").click();
  await lathe.advance(50);
  for (let i = 0; i < 12; i += 1) await lathe.button("forward").click();
  await lathe.advance(50);
  expect(await stock(turnwise)).toBe(stepped);
  expect(sought).not.toBeNull();

  // With X down too, the stock looks the same after playing and after a reload of the view.
  await expect(lathe.section).toHaveValue("half");
  const seen: number[][] = [];
  for (const view of ["half", "full", "outside"] as const) {
    await lathe.section.selectOption(t.lathe.sections[view]);
    if (view === "outside") await lathe.button("xDown").click();
    for (const back of ["forward", "first", "play"] as const) await lathe.button(back).click();
    for (let i = 0; i < 9; i += 1) await lathe.advance(3700);
    await lathe.button("pause").click();
    const played = await shades(turnwise);
    for (const anew of ["zoomIn", "fit"] as const) await lathe.button(anew).click();
    await lathe.advance(50);
    expect(differing(played, await shades(turnwise))).toBe(0);
    for (const before of seen) expect(differing(before, played)).toBeGreaterThan(40);
    seen.push(played);
  }
});

test("the worker paints the stock exactly as the paused page does; the current chip; keys of the view", async ({
  page,
}) => {
  const turnwise = await Turnwise.open(page);
  const { lathe, effect, t } = turnwise,
    layer = lathe.picture.locator(".played canvas");
  await turnwise.start.beginWithExample(812);
  await effect.proved();
  const blank = await shades(turnwise);
  await lathe.timeline.fill("411.3");
  await lathe.speed.selectOption("0.1");
  for (const again of [false, true]) {
    await lathe.button("play").click();
    await expect(layer).toBeVisible();
    if (again) {
      await lathe.button("zoomIn").click();
      await lathe.button("fit").click();
      await expect(layer).toBeVisible();
    }
    const played = await shades(turnwise, ".played canvas");
    await lathe.button("pause").click();
    await expect(layer).toBeHidden();
    expect(differing(played, await shades(turnwise, ".sheet.material:not(.played *)"))).toBeLessThan(12);
    expect(differing(played, blank)).toBeGreaterThan(100);
  }

  // The current chip is shown at the edge and in numbers, and finished passes fade.
  await lathe.button("first").click();
  const edge = lathe.picture.locator(".chip-edge"),
    measure = lathe.picture.locator(".chip-sheet text");
  const passes = (progress: "done" | "running" | "coming") => lathe.picture.locator(`.pass-${progress}`);
  await expect(passes("done")).toHaveCount(0);
  await expect(lathe.running).not.toContainText(/\bap /);
  const total = Number(await lathe.timeline.getAttribute("max"));
  await lathe.timeline.fill(String(Math.round(total * 0.4)));
  await expect(lathe.running).toContainText("Pass 3 of 5");
  await expect(lathe.running).toContainText("ap 2.452 · h 0.300 mm · A 0.734 mm²");
  await expect(edge).toHaveAttribute("d", /^M/);
  await expect(measure).toHaveText("");
  for (let i = 0; i < 8; i += 1) await lathe.button("zoomIn").click();
  await expect(measure).toHaveText(/^h 0\.300 · b \d/);
  await expect(passes("running")).toHaveCount(1);
  const [done, coming] = [await passes("done").count(), await passes("coming").count()];
  expect(done).toBeGreaterThan(1);
  expect(coming).toBeGreaterThan(1);
  await lathe.button("last").click();
  await expect(passes("done")).toHaveCount(done + coming + 1);
  await expect(edge).toHaveAttribute("d", "");
  await expect(lathe.running).not.toContainText(/\bap /);

  // Keys of the view, with reduced motion.
  await page.emulateMedia({ reducedMotion: "reduce" });
  await lathe.view.getByRole("group", { name: t.lathe.title }).focus();
  await page.keyboard.press("End");
  await expect(lathe.picture).toHaveAccessibleName(new RegExp(t.lathe.atEnd));
  await page.keyboard.press("Home");
  await expect(lathe.picture).toHaveAccessibleName(new RegExp(t.lathe.atStart));
});
