import { createHash } from "node:crypto";
import { solid as words } from "../src/i18n/en/solid.ts";
import { expectAccessibleAndFits } from "./pages/layout-checks.ts";
import { frames, settledBox } from "./pages/picture.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

test("the turned body in 3D: rotated, cut open, at any moment; the section if the graphics card is lost", async ({
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
  /** The next picture that differs from the previous one, once it no longer changes. */
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
  await expectAccessibleAndFits(page);

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
  // No frames are drawn while nothing changes.
  await frames(page, 24);
  expect(await seen()).toBe(now);
  await lathe.button("last").click();
  now = await changed(now);
  await expect(picture).toHaveAccessibleName(/Block|block/);
  // The body is shown, with the legend of its surfaces.
  await expect(field.getByRole("list", { name: words.surfaces, exact: true })).toContainText(words.textures.finished);

  // Measuring switches to the section; afterwards the body is back.
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
  await expectAccessibleAndFits(page);
  await expect(lathe.view.getByText(words.lost)).toHaveCount(0);
  await expect(lathe.view.locator(".lathe-picture")).toHaveCount(0);
  await changed("");
  await lathe.section.selectOption("half");
  await expect(field).toHaveCount(0);
  await expect(lathe.view.locator(".lathe-picture")).toBeVisible();

  // Without WebGL the choice is kept, and the section is shown with the reason.
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

test("on small screens the named views can be pressed while a colour map is shown", async ({ page }) => {
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
