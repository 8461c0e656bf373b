import { load as de } from "../src/i18n/de/load.ts";
import { load as en } from "../src/i18n/en/load.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

test("colour map of roughness and load: scale, worst place, values under the pointer, list, other values, other language", async ({
  page,
}) => {
  const turnwise = await Turnwise.open(page);
  const { lathe, editor } = turnwise;
  await editor.openExample("flange");
  await expect(lathe.picture).toBeVisible();
  const { view } = lathe;
  const strip = (name: string) => page.getByRole("region", { name, exact: true });
  const lines = lathe.picture.locator(".load-line");

  await test.step("nothing of the colour map is present or fetched before it is chosen", async () => {
    await expect(lines).toHaveCount(0);
    const fetched = await page.evaluate(() => performance.getEntriesByType("resource").map(({ name }) => name));
    expect(fetched.filter((name) => /LoadStrip|LoadLines/.test(name))).toEqual([]);
  });

  await test.step("roughness of the finished surface, with its rule; the tool goes to the roughest place", async () => {
    await lathe.colours.selectOption("roughness");
    const told = strip(en.names.roughness);
    await expect(told).toContainText("f²/(8·r)");
    await expect(told.getByRole("list", { name: en.scale })).toContainText(en.notByNose);
    await expect.poll(() => lines.count()).toBeGreaterThan(2);
    expect(await lines.count()).toBeLessThan(9);
    // The outside is finished with f 0.15 and a nose of 0.4: 0.15²/3.2 mm.
    await expect(told.getByRole("paragraph").filter({ hasText: en.greatest })).toContainText("7 µm");
    await told.getByRole("button", { name: en.go }).click();
    await expect(told.getByRole("paragraph").filter({ hasText: en.now })).toContainText("f 0.15 mm, r 0.4 mm");
    await expect(lathe.running).toContainText("62.000");
  });

  await test.step("depth of cut, measured in the stock, also under the pointer", async () => {
    await lathe.colours.selectOption("depth");
    const told = strip(en.names.depth);
    await told.getByRole("button", { name: en.go }).click();
    await expect(told.getByRole("paragraph").filter({ hasText: en.now })).toContainText(/3\.02 mm/);
    const at = await lines.last().boundingBox();
    if (!at) throw new Error("nothing is drawn");
    await page.mouse.move(at.x + at.width / 2, at.y + at.height / 2);
    for (let y = at.y - 4; y < at.y + at.height + 4; y += 3) {
      if (await told.getByText(en.here, { exact: true }).isVisible()) break;
      await page.mouse.move(at.x + at.width / 2, y);
    }
    await expect(told.getByText(en.here, { exact: true })).toBeVisible();
  });

  await test.step("where the spindle is at its limit, and the same as a list by operation", async () => {
    await lathe.colours.selectOption("speed");
    const told = strip(en.names.speed);
    await expect(told.getByRole("list", { name: en.scale })).toContainText(en.limited);
    await expect(told.getByRole("paragraph").filter({ hasText: en.least })).toContainText("m/min");
    await view.getByText(en.table(en.names.speed)).click();
    const rows = view.getByRole("table").getByRole("row");
    await expect(rows.first()).toContainText(en.value);
    await expect.poll(() => rows.count()).toBeGreaterThan(6);
    await rows.nth(2).getByRole("button").click();
    await expect(lathe.running).toContainText("Block 21");
  });

  await test.step("in another language, and off again", async () => {
    await turnwise.settings.chooseLanguage("de");
    await expect(strip(de.names.speed)).toContainText(de.limited);
    await Turnwise.at(page, "de").lathe.colours.selectOption("none");
    await expect(lines).toHaveCount(0);
  });
});
