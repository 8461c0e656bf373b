import { readFile } from "node:fs/promises";
import { machineTexts as t } from "../src/i18n/en/machine.ts";
import { expectFineAtSizes } from "./pages/layout-checks.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

test("machine data: a preset, an invalid value, export and import, and their effect on the running time", async ({
  page,
}) => {
  const turnwise = await Turnwise.open(page);
  await turnwise.start.beginWithExample(812);
  await turnwise.effect.proved();
  const time = turnwise.effect.cell("time");
  const before = await time.innerText();
  await page.getByRole("button", { name: t.time.title }).click();
  const parts = page.getByRole("dialog", { name: t.time.title });
  await expect(parts).toContainText(t.time.noMachine);
  await expect(parts.getByRole("row")).toHaveCount(3);
  await page.keyboard.press("Escape");

  await turnwise.settings.open();
  const { dialog, machine: section } = turnwise.settings;
  await section.getByRole("combobox", { name: t.preset }).selectOption(t.presets.large);
  await section.getByText(t.values, { exact: true }).click();
  const most = section.getByRole("textbox", { name: t.fields.most, exact: true });
  await expect(most).toHaveValue("1600");
  await expectFineAtSizes(page, "machine", [
    [1280, 800],
    [390, 664],
  ]);
  await page.setViewportSize({ width: 1280, height: 800 });

  await most.fill("5");
  await expect(section.getByText(t.problems.low("", "10"))).toBeVisible();
  await expect(section.getByText(t.kept)).toBeVisible();
  await expect(section.getByRole("button", { name: t.save })).toHaveCount(0);
  await most.fill("1500");
  await most.press("Enter");
  await expect(dialog).toBeVisible();
  await expect(section.getByRole("combobox", { name: t.preset })).toHaveValue("own");
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    section.getByRole("button", { name: t.save }).click(),
  ]);
  const file = await readFile(await download.path(), "utf8");
  expect(JSON.parse(file)).toMatchObject({
    format: "turnwise-machine/1",
    spindle: { most: 1500 },
    output: { spindleOn: 303 },
  });

  const bring = async (name: string, text: string) => {
    const choosing = page.waitForEvent("filechooser");
    await section.getByRole("button", { name: t.open }).click();
    await (await choosing).setFiles({ name, mimeType: "application/json", buffer: Buffer.from(text) });
  };
  await bring("bad.json", file.replace("1500", "7"));
  await expect(section.getByText(t.refused(t.problems.low("spindle.most: ", "10")))).toBeVisible();
  await bring("good.json", file.replace(/"name": "[^"]*"/, `"name": "Lathe 7"`));
  await expect(section.getByText(t.taken("Lathe 7"))).toBeVisible();
  await dialog.getByRole("button", { name: turnwise.t.page.close, exact: true }).first().click();

  await expect(time).not.toHaveText(before);
  await page.getByRole("button", { name: t.time.title }).click();
  await expect(parts).toContainText(t.time.machine("Lathe 7"));
  await expect(parts.getByRole("row", { name: t.time.causes.toolChange })).toBeVisible();
  await page.keyboard.press("Escape");
  await page.reload();
  await expect(time).not.toHaveText(before);
});
