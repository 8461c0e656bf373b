import { createHash } from "node:crypto";
import { solid as words } from "../src/i18n/en/solid.ts";
import { looksRight } from "./pages/look.ts";
import { frames, settledBox } from "./pages/picture.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

test("the turned body in space: turned, cut open, at any moment; the section where the graphics card is gone", async ({
  page,
}) => {
  const turnwise = await Turnwise.open(page);
  const { effect, lathe, start } = turnwise;
  const field = lathe.view.getByRole("group", { name: words.title, exact: true }),
    picture = field.getByRole("img");
  const seen = async () =>
    createHash("sha1")
      .update(await picture.screenshot())
      .digest("hex");
  /** What is seen once it is another picture than before, and stays. */
  const changed = async (before: string) => {
    let now = before;
    await expect
      .poll(async () => {
        const last = now;
        await frames(page, 6);
        now = await seen();
        return now !== before && now === last;
      })
      .toBe(true);
    return now;
  };
  await start.beginWithExample(812);
  await effect.proved();
  await lathe.section.selectOption("solid");
  await expect(picture).toHaveAccessibleName(/quarter section/);
  await expect(lathe.view.locator(".lathe-picture")).toHaveCount(0);
  await looksRight(page);

  let now = await changed("");
  await field.focus();
  for (const key of ["ArrowLeft", "ArrowUp", "Shift+ArrowRight", "+", "0", "2", "3"]) {
    await page.keyboard.press(key);
    now = await changed(now);
  }
  await field.getByRole("button", { name: words.quarter, exact: true }).click();
  await expect(picture).not.toHaveAccessibleName(/quarter section/);
  now = await changed(now);
  await field.getByRole("button", { name: words.iso, exact: true }).click();
  now = await changed(now);
  await lathe.button("zoomIn").click();
  now = await changed(now);
  await lathe.button("fit").click();
  now = await changed(now);
  const box = await settledBox(picture);
  await page.mouse.move(box.x + 200, box.y + 150);
  await page.mouse.down();
  await page.mouse.move(box.x + 260, box.y + 170, { steps: 4 });
  await page.mouse.up();
  now = await changed(now);
  // Nothing is drawn as long as nothing changes.
  await frames(page, 24);
  expect(await seen()).toBe(now);
  await lathe.button("last").click();
  now = await changed(now);
  await expect(picture).toHaveAccessibleName(/Block|block/);
  // The body itself is there: what its surfaces stand for is told with it.
  await expect(field.getByRole("list", { name: words.surfaces, exact: true })).toContainText(words.textures.finished);

  // Measuring is done in the section; after it the body is back.
  await lathe.button("ruler").click();
  await expect(field).toHaveCount(0);
  await lathe.button("ruler").click();
  await expect(lathe.view.locator(".lathe-picture")).toHaveCount(0);

  await picture.evaluate((canvas: HTMLCanvasElement) => {
    const lose = canvas.getContext("webgl2")?.getExtension("WEBGL_lose_context");
    lose?.loseContext();
    setTimeout(() => lose?.restoreContext(), 1500);
  });
  await expect(lathe.view.getByText(words.lost)).toBeVisible();
  await expect(lathe.view.locator(".lathe-picture")).toBeVisible();
  await looksRight(page);
  await expect(lathe.view.getByText(words.lost)).toHaveCount(0);
  await expect(lathe.view.locator(".lathe-picture")).toHaveCount(0);
  await changed("");
  await lathe.section.selectOption("half");
  await expect(field).toHaveCount(0);
  await expect(lathe.view.locator(".lathe-picture")).toBeVisible();

  // No WebGL at all, until there is: the choice is kept, the section is shown and says why.
  await lathe.section.selectOption("solid");
  await page.addInitScript(() => {
    const before = HTMLCanvasElement.prototype.getContext;
    let refused = 0;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, kind: string, ...rest: unknown[]) {
      if (kind.startsWith("webgl") && (refused += 1) === 1) return null;
      return Reflect.apply(before, this, [kind, ...rest]) as never;
    } as typeof before;
  });
  await page.reload();
  await expect(lathe.view.getByText(words.missing)).toBeVisible();
  await expect(lathe.view.locator(".lathe-picture")).toBeVisible();
  await lathe.view.getByRole("button", { name: words.again, exact: true }).click();
  await expect(picture).toBeVisible();
  await expect(lathe.view.locator(".lathe-picture")).toHaveCount(0);
});

test("on small screens the named views can be pressed while something is told by colour", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { effect, lathe, start } = turnwise;
  await start.beginWithExample(812);
  await effect.proved();
  await lathe.colours.selectOption("roughness");
  await lathe.shows("solid");
  const quarter = lathe.view.getByRole("button", { name: words.quarter, exact: true });
  for (const [width, height] of [
    [390, 844],
    [844, 390],
    [1024, 768],
  ] as const) {
    await page.setViewportSize({ width, height });
    await expect(quarter).toBeVisible();
    const before = await quarter.getAttribute("aria-pressed");
    await quarter.click({ timeout: 10_000 });
    await expect(quarter).not.toHaveAttribute("aria-pressed", String(before));
  }
});
