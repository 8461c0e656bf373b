import { measure } from "../src/i18n/en/measure.ts";
import { dragFinger } from "./pages/finger.ts";
import { expectAccessible } from "./pages/layout-checks.ts";
import { pictureAt, settledBox } from "./pages/picture.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

test.use({ hasTouch: true });

const { kinds } = measure;

test("diameter, length, radius, angle by keys: kept, updated by a value, printed on the sheet, undone", async ({
  page,
}) => {
  const turnwise = await Turnwise.open(page);
  const { lathe, dialog, effect, sheet } = turnwise;
  await turnwise.start.beginWithExample(812);
  await effect.proved();
  const label = (name: string | RegExp) => lathe.view.getByRole("button", { name, exact: typeof name === "string" });
  const press = async (...keys: readonly string[]) => {
    for (const key of keys) await page.keyboard.press(key);
  };
  await lathe.button("ruler").press("Enter");
  // The picture takes the keys at once, and buffers them while the tools load.
  await press("d", "n", "n", "n", "n", "Enter");
  const tools = lathe.view.getByRole("toolbar", { name: measure.tools });
  await expect(tools.getByRole("button", { name: kinds.diameter })).toHaveAttribute("aria-pressed", "true");
  await expect(label(`${kinds.diameter} ⌀54.736, contour`)).toBeVisible();
  await press("r", "n", "Enter");
  await expect(label(`${kinds.radius} R1.500, contour`)).toBeVisible();
  await press("a", "n", "n", "Enter", "Enter");
  await expect(label(`${kinds.angle} 5.000°, contour`)).toBeVisible();
  await press("l", "n", "Enter", "p", "p", "Enter");
  await expect(label(/^Length \d+\.\d+, contour/)).toBeVisible();
  await expectAccessible(page);

  // With another angle the cone differs; its measurements follow.
  await press("Escape");
  await dialog.set("Q495", "7");
  await expect(label(`${kinds.angle} 7.000°, contour`)).toBeVisible();
  await expect(label(/^Diameter ⌀5\d\.\d{3}, contour$/)).not.toHaveText("⌀54.736");
  await turnwise.undo();
  await expect(label(`${kinds.diameter} ⌀54.736, contour`)).toBeVisible();

  await page.reload();
  await effect.proved();
  const radius = label(`${kinds.radius} R1.500, contour`);
  await radius.press("ArrowUp");
  await radius.press("Delete");
  await expect(radius).toHaveCount(0);
  await turnwise.undo();
  await expect(radius).toBeVisible();

  await sheet.open();
  const drawing = sheet.preview.getByRole("img", { name: sheet.words.drawingOf("SHOULDER812") });
  await expect(drawing).toContainText("R1.500");
  await expect(sheet.preview).toContainText(`${kinds.angle} 5.000°, contour`);
  expect((await page.pdf({ preferCSSPageSize: true })).byteLength).toBeGreaterThan(10_000);
  await page.getByRole("checkbox", { name: sheet.words.withMeasured }).uncheck();
  await expect(drawing).not.toContainText("R1.500");
});

test("by touch: tap a surface, place the cross beside the finger, move a label, clear all", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { lathe, effect } = turnwise;
  await turnwise.start.beginWithExample(812);
  await effect.proved();
  await lathe.button("ruler").tap();
  const stage = lathe.view.getByRole("group", { name: turnwise.t.lathe.title });
  await lathe.view.getByRole("toolbar", { name: measure.tools }).getByRole("button", { name: kinds.diameter }).tap();
  const bar = await pictureAt(page, stage, -75.3, 75);
  await page.touchscreen.tap(bar.x, bar.y + 3);
  const one = lathe.view.getByRole("button", { name: /^Diameter ⌀75\.000/ });
  await expect(one).toBeVisible();
  // The cross is above the finger, so that the point is visible.
  const cone = await pictureAt(page, stage, -30, 55.2);
  await dragFinger(page, { x: cone.x - 60, y: cone.y + 30 }, { x: cone.x, y: cone.y + 64 });
  await expect(lathe.view.getByRole("button", { name: /^Diameter ⌀5\d\.\d{3}, contour/ })).toBeVisible();

  const before = await settledBox(one);
  const from = { x: before.x + before.width / 2, y: before.y + before.height / 2 };
  await dragFinger(page, from, { x: from.x + 30, y: from.y - 20 });
  await expect.poll(async () => Math.round(((await one.boundingBox())?.x ?? 0) - before.x)).toBe(30);
  await turnwise.undo();
  await expect.poll(async () => Math.round(((await one.boundingBox())?.x ?? 0) - before.x)).toBe(0);
  await one.tap();
  await lathe.view
    .getByRole("button", { name: /^Remove Diameter ⌀75\.000/ })
    .first()
    .tap();
  await expect(one).toHaveCount(0);
  await lathe.view.getByText(measure.count("1")).tap();
  await lathe.view.getByRole("button", { name: measure.clear }).tap();
  await expect(lathe.view.getByRole("button", { name: /^Diameter ⌀/ })).toHaveCount(0);
});

test("an angle in the plane by keys alone", async ({ page }) => {
  const { editor, lathe, t } = await Turnwise.open(page);
  await editor.openExample("plate");
  // Until the milling is known, the lathe view is shown, with its own ruler.
  await page.getByRole("region", { name: t.approach.view }).waitFor();
  await lathe.button("ruler").press("Enter");
  await expect(lathe.view.getByRole("toolbar", { name: measure.tools })).toBeVisible();
  for (const key of ["a", "n", "Enter", "Enter"]) await page.keyboard.press(key);
  await expect(lathe.view.getByRole("button", { name: `${kinds.angle} 90.000°, contour`, exact: true })).toBeVisible();
});
