import { readFile } from "node:fs/promises";
import type { Locator } from "@playwright/test";
import { exported as words } from "../src/i18n/en/export.ts";
import { contourOf, propose, readDrawing } from "../src/program/drawing/formats.ts";
import { expectAccessibleAndFits } from "./pages/layout-checks.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

/** Name and bytes of the file that a button downloads. */
async function downloaded(button: Locator): Promise<{ readonly name: string; readonly bytes: Buffer }> {
  const waiting = button.page().waitForEvent("download");
  await button.click();
  const file = await waiting;
  return { name: file.suggestedFilename(), bytes: await readFile(await file.path()) };
}

/** Volume of a binary STL file, mm³, and its extent along the spindle. */
function measured(bytes: Buffer) {
  const count = bytes.readUInt32LE(80);
  expect(bytes.length).toBe(84 + 50 * count);
  let [volume, left, right] = [0, Infinity, -Infinity];
  for (let t = 0; t < count; t += 1) {
    const n = (k: number) => bytes.readFloatLE(84 + 50 * t + 12 + 4 * k);
    volume +=
      n(0) * (n(4) * n(8) - n(5) * n(7)) + n(1) * (n(5) * n(6) - n(3) * n(8)) + n(2) * (n(3) * n(7) - n(4) * n(6));
    for (const z of [n(2), n(5), n(8)]) [left, right] = [Math.min(left, z), Math.max(right, z)];
  }
  return { volume: volume / 6, left, right };
}

test("the part is exported as bodies and drawings, from a cycle and from a program", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { effect, lathe, start, t } = turnwise;
  const dialog = page.getByRole("dialog", { name: words.title, exact: true });
  const open = () => turnwise.menus.choose("export", t.page.text.exportPart);
  const save = (what: string, format: string) =>
    downloaded(dialog.getByRole("button", { name: words.save(what, format), exact: true }));

  await start.beginWithExample(812);
  await effect.proved();
  await open();
  await expectAccessibleAndFits(page);
  const [blank, part] = [await save(words.body.blank, "STL"), await save(words.body.part, "STL")];
  expect([blank.name, part.name]).toEqual(["SHOULDER812_blank.stl", "SHOULDER812_part.stl"]);
  const [whole, finished] = [measured(blank.bytes), measured(part.bytes)];
  expect(whole.volume / (Math.PI * 37.5 ** 2 * 100)).toBeCloseTo(1, 2);
  expect(whole.right - whole.left).toBeCloseTo(100, 3);
  expect(finished.volume).toBeLessThan(0.8 * whole.volume);
  await expect(dialog.getByRole("status")).toContainText("SHOULDER812_part.stl");
  // Nothing is cut yet, so the current stock is the blank. At the end it is the part.
  const now = measured((await save(words.body.stock, "STL")).bytes);
  expect(now.volume).toBeCloseTo(whole.volume, 0);
  await page.keyboard.press("Escape");
  await lathe.button("last").click();
  await open();
  const end = measured((await save(words.body.stock, "STL")).bytes);
  expect(end.volume / finished.volume).toBeCloseTo(1, 3);

  const drawing = await save(words.contour, "DXF");
  expect(drawing.name).toBe("SHOULDER812.dxf");
  const readBack = async (bytes: Uint8Array, diameters = false) => {
    const read = await readDrawing({ name: "contour.dxf", bytes });
    return contourOf(read, propose(read, { diameters }));
  };
  const radii = await readBack(drawing.bytes);
  expect(radii.segments.some((s) => s.kind === "arc")).toBe(true);
  expect(radii.notes.filter((n) => n.severity === "error")).toEqual([]);
  expect(radii.rows.at(-1)?.x).toBe("75");
  await dialog.getByRole("radio", { name: words.diameter("0.005 mm"), exact: true }).check();
  const across = await readBack((await save(words.contour, "DXF")).bytes, true);
  expect(across.rows.at(-1)?.x).toBe("75");
  const svg = (await save(words.contour, "SVG")).bytes.toString();
  expect(svg).toMatch(/^<svg [^>]*width="[\d.]+mm"/);
  expect(svg).toMatch(/ d="M[^"]*A/);
  await page.keyboard.press("Escape");

  await page.getByRole("link", { name: t.page.home }).click();
  await turnwise.editor.openExample("flange");
  await open();
  await dialog.getByRole("combobox", { name: words.which, exact: true }).selectOption("1");
  expect((await save(words.contour, "DXF")).name).toBe("FLANGE_2.dxf");
  expect(measured((await save(words.body.part, "STL")).bytes).volume).toBeGreaterThan(10_000);
  for (const [width, height] of [
    [390, 844],
    [768, 1024],
  ] as const) {
    await page.setViewportSize({ width, height });
    await expectAccessibleAndFits(page);
  }
});
