import { TABLET } from "./pages/devices.ts";
import { expectInView } from "./pages/layout-checks.ts";
import { settledBox } from "./pages/picture.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";
import { answers } from "./pages/values.ts";

/* A file of its own: files run in the order of their names, and the longest journey must not be one of the last. */

test.use(TABLET);

/** A notebook at 400 % zoom, with the least room of all. */
const SMALLEST = "320x256";
/** Besides it a phone with the bars of its browser, a small one, one in landscape, and an upright tablet. */
const SMALL = [SMALLEST, "390x664", "360x640", "844x390", "768x1024"] as const;

/** How far any element is lower than its content, px. */
const hiddenHeights = (elements: readonly Element[]): number =>
  Math.max(0, ...elements.map((element) => element.scrollHeight - element.clientHeight));

test("in a small window, field, value and ENT stay in view through the whole of a cycle, and the picture comes back", async ({
  page,
}) => {
  const { dialog, start, lathe, t } = await Turnwise.open(page);
  const values = answers(812, { Q493: "48.5", Q494: "-42" });
  const show = (screen: string) => {
    const [width = 0, height = 0] = screen.split("x").map(Number);
    return page.setViewportSize({ width, height });
  };
  await start.beginEmpty(812);
  await dialog.key("enterLong").waitFor();
  const seen = new Set<boolean>();
  for (let entries = 0; (await dialog.keypad.count()) > 0; entries += 1) {
    expect(entries).toBeLessThan(30);
    const asked = (await dialog.question.textContent()) ?? "";
    const q = Object.keys(values).find((each) => dialog.promptOf(812, each) === asked);
    const isNumber = (await dialog.value.count()) > 0;
    const field = isNumber ? dialog.value : dialog.choice(0);
    // Every prompt in the smallest window; the first number and the first choice in the others too.
    for (const screen of seen.has(isNumber) ? [SMALLEST] : SMALL) {
      await show(screen);
      for (const each of [dialog.question, field, dialog.key("enterLong")])
        await expectInView(each, `"${asked}" at ${screen}`);
      const lower = await dialog.choices.locator("label").evaluateAll(hiddenHeights);
      expect(lower, `a choice of "${asked}" at ${screen}`).toBe(0);
    }
    seen.add(isNumber);
    if (q !== undefined) await page.keyboard.type(values[q] ?? "");
    await dialog.key("enterLong").tap();
    await expect(dialog.question).not.toHaveText(asked);
  }
  await expect(dialog.question).toHaveText(t.dialog.done.title);
  for (const screen of SMALL) {
    await show(screen);
    expect(await page.locator("html").evaluateAll(hiddenHeights), `the page itself scrolls at ${screen}`).toBe(0);
  }
  await page.setViewportSize({ width: 390, height: 664 });
  const stage = lathe.view.getByRole("group", { name: t.lathe.title });
  const strip = await settledBox(stage);
  await page.touchscreen.tap(strip.x + strip.width / 2, strip.y + strip.height / 2);
  await expect.poll(async () => (await stage.boundingBox())?.height).toBeGreaterThan(2 * strip.height);
  await page.keyboard.press("Escape");
  await expect(dialog.question).toBeVisible();
});
