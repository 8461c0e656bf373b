import { insert } from "../src/i18n/en/insert.ts";
import { readFileSync } from "node:fs";
import { TABLET } from "./pages/devices.ts";
import { dragFinger } from "./pages/finger.ts";
import { expectFits } from "./pages/layout-checks.ts";
import { expect, test } from "./pages/test.ts";
import { pictureAt, settledBox } from "./pages/picture.ts";
import { Turnwise } from "./pages/turnwise.ts";
import { answers } from "./pages/values.ts";

test.use(TABLET);

/** Smallest target for a gloved finger, px. */
const TARGET = 48;

test("a shoulder by touch at tablet size, from the empty page to the copied program", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { dialog, program } = turnwise;
  await turnwise.start.button(812, false).tap();
  await expect(dialog.question).toHaveText(turnwise.t.setup.blank.outside);
  await dialog.key("endLong").tap();
  for (const [q, value] of Object.entries(answers(812, { Q493: "48.5", Q494: "-42" }))) {
    await expect(dialog.question).toHaveText(dialog.promptOf(812, q));
    for (const character of value) {
      const key = character === "-" ? "signLong" : character === "." ? "point" : Number(character);
      await dialog.key(key).tap();
    }
    await dialog.key("enterLong").tap();
  }
  await expect(dialog.question).toHaveText(turnwise.t.dialog.done.title);
  await program.copyButton.tap();
  const text = await program.clipboard();
  expect(text).toContain("Q493=+48.5 ");
  expect(text).toContain("Q494=-42 ");
  await turnwise.effect.proved();
});

test("the keys of the keypad are large enough for a glove, and keep the system keyboard away", async ({ page }) => {
  const { start, dialog } = await Turnwise.open(page);
  await start.button(812, true).tap();
  await dialog.open("Q493");
  await expect(dialog.value).toHaveAttribute("inputmode", "none");
  await expect(dialog.key("enterLong")).toBeVisible();
  for (const key of await dialog.keypad.getByRole("button").all()) {
    const box = await key.boundingBox();
    expect(
      Math.min(box?.width ?? 0, box?.height ?? 0),
      (await key.getAttribute("aria-label")) ?? "",
    ).toBeGreaterThanOrEqual(TARGET);
  }
  await dialog.key("signLong").tap();
  await expect(dialog.value).toHaveValue("-50");
  await dialog.key("cancel").tap();
  await expect(dialog.value).toHaveValue("50");
});

test("a contour of five elements by touch: drawn, a diameter changed on the drawing, a corner chamfered, each undone", async ({
  page,
}) => {
  const turnwise = await Turnwise.open(page);
  const { contour, dialog, t } = turnwise;
  await turnwise.start.button(820, false).tap();
  await page.getByRole("tab", { name: t.page.contour }).tap();
  const box = await settledBox(contour.drawing);
  const spot = (x: number, y: number) => ({ x: box.x + box.width * x, y: box.y + box.height * y });
  const spots = [spot(0.72, 0.6), spot(0.55, 0.6), spot(0.55, 0.42), spot(0.36, 0.42), spot(0.36, 0.24)];
  for (const [i, at] of spots.entries()) {
    await page.touchscreen.tap(at.x, at.y);
    await expect(contour.kind(i + 1)).toBeVisible();
  }
  await expect(contour.drawing).toHaveAccessibleName(new RegExp(t.contour.drawingElement(5)));

  const name = t.contour.xOf(5),
    drawn = await contour.x(5).inputValue();
  await contour.dimension(name).tap();
  await expect(contour.dimensionField(name)).toHaveAttribute("inputmode", "none");
  for (const key of [7, 3, "point", 4] as const) await dialog.key(key).tap();
  await dialog.keypad.getByRole("button", { name: t.dialog.keys.enterField, exact: true }).tap();
  await expect(dialog.keypad).toBeHidden();
  await expect(contour.x(5)).toHaveValue("73.4");

  await contour.drawingMode("chamfer").tap();
  await expect(contour.drawingMode("chamfer")).toHaveAttribute("aria-pressed", "true");
  const corner = spots[2] ?? spot(0.5, 0.5);
  await dragFinger(page, corner, { x: corner.x + 26, y: corner.y + 4 });
  await expect(contour.kind(4)).toHaveValue("CHF");

  const undo = turnwise.historyButton("undo");
  await undo.tap();
  await expect(contour.kind(4)).toHaveValue("L");
  await undo.tap();
  await expect(contour.x(5)).toHaveValue(drawn);
  for (const left of [4, 3, 2, 1]) {
    await undo.tap();
    await expect(contour.kind(left + 1)).toHaveCount(0);
    await expect(contour.kind(left)).toBeVisible();
  }
});

test("every number field opens the keypad and stays visible above it; a name field keeps the system keyboard", async ({
  page,
}) => {
  const turnwise = await Turnwise.open(page);
  const { dialog, setup, t } = turnwise;
  await turnwise.start.button(812, true).tap();
  await page.getByRole("tab", { name: t.page.setup }).tap();
  const field = setup.start("z");
  await field.tap();
  await expect(field).toHaveAttribute("inputmode", "none");
  await expect(dialog.key(7)).toBeVisible();
  for (const key of await dialog.keypad.getByRole("button").all()) {
    const size = await key.boundingBox();
    expect(Math.min(size?.width ?? 0, size?.height ?? 0)).toBeGreaterThanOrEqual(TARGET);
  }
  for (const key of [4, "point", 5] as const) await dialog.key(key).tap();
  await expect(field).toHaveValue("4.5");
  await dialog.keypad.getByRole("button", { name: t.dialog.keys.enterField, exact: true }).tap();
  await expect(field).not.toBeFocused();
  const above = await settledBox(dialog.keypad),
    at = await settledBox(page.locator(":focus"));
  expect(at.y + at.height).toBeLessThanOrEqual(above.y);
  await dialog.keypad.getByRole("button", { name: t.dialog.keys.readyLong, exact: true }).tap();
  await expect(dialog.keypad).toBeHidden();
});

test("a program of three operations from nothing, by touch alone", async ({ page }) => {
  const { editor, t } = await Turnwise.open(page);
  await page.getByRole("button", { name: t.page.programs.create, exact: true }).tap();
  await page.getByRole("button", { name: t.operations.create, exact: true }).tap();
  const put = async (group: "transverse" | "longitudinal" | "recessing", cycle: 822 | 812 | 862) => {
    if (group === "transverse") await editor.inserting.getByRole("radio", { name: insert.sites.face }).tap();
    await editor.inserting.getByRole("button", { name: new RegExp(t.cycles.groups[group]) }).tap();
    await editor.inserting
      .getByRole("button", { name: new RegExp(`^${t.page.start.cycle(cycle, t.cycles.of[cycle].name)}`) })
      .first()
      .tap();
    if (group === "recessing") await editor.inserting.getByRole("textbox", { name: t.setup.start.z }).fill("-20");
    await editor.inserting.getByRole("button", { name: t.operations.put, exact: true }).tap();
    await expect(editor.inserting).toHaveCount(0);
  };
  await put("transverse", 822);
  for (const [done, group, cycle] of [
    [1, "longitudinal", 812],
    [2, "recessing", 862],
  ] as const) {
    await expect(editor.total(t.editor.operations)).toHaveText(String(done));
    await page.getByRole("tab", { name: t.editor.sections.structure, exact: true }).tap();
    await page.getByRole("button", { name: t.operations.insert, exact: true }).tap();
    await put(group, cycle);
  }
  await expect(editor.total(t.editor.operations)).toHaveText("3");
  await page.getByRole("tab", { name: t.editor.sections.structure, exact: true }).tap();
  await expect(editor.operation(3)).toBeVisible();
  for (const button of await page.getByRole("tabpanel").getByRole("button").all())
    expect((await button.boundingBox())?.height ?? TARGET).toBeGreaterThanOrEqual(44);
});

test("a wrong infeed is fixed by touch: the pass in the picture, its prompt, the keypad", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { editor, lathe, dialog, t } = turnwise;
  const flange = readFileSync(new URL("../src/examples/flange.h", import.meta.url), "utf8");
  await editor.paste(flange.replace("Q463=+3 ;MAX. CUTTING DEPTH", "Q463=+0.3 ;MAX. CUTTING DEPTH"));
  const passes = editor.total(t.page.effect.passes);
  await expect(passes).not.toHaveText(/^(25|–)$/);
  const at = await pictureAt(page, lathe.view.getByRole("group", { name: t.lathe.title }), -22.3, 78);
  await page.touchscreen.tap(at.x, at.y);
  await expect(dialog.value).toHaveAccessibleName(/^Q463/);
  await dialog.value.tap();
  await dialog.value.press("ControlOrMeta+a");
  await dialog.key(3).tap();
  await dialog.key("enterLong").tap();
  await expect(passes).toHaveText("25");
});

/** Phones and tablets, upright and landscape, windows of half a screen, and a notebook. */
const SCREENS = [
  "320x640",
  "390x844",
  "600x960",
  "768x1024",
  "844x390",
  "800x600",
  "900x600",
  "1024x768",
  "1280x800",
] as const;

test("nothing overflows any screen sideways, with large letters, in a language with long words", async ({ page }) => {
  const turnwise = await Turnwise.open(page, { language: "fr" });
  const { settings } = turnwise;
  // All widths grow with the letters, which are at least as large as the usual ones in every window.
  await settings.open();
  await settings.chooseLetters("presentation");
  await page.keyboard.press("Escape");
  const fitEverywhere = async (what: string) => {
    for (const screen of SCREENS) {
      const [width = 0, height = 0] = screen.split("x").map(Number);
      await page.setViewportSize({ width, height });
      await expectFits(page, `${what} at ${screen}`);
    }
  };
  await fitEverywhere("the start");
  // Five tabs, one with a count.
  await turnwise.start.beginEmpty(860);
  await fitEverywhere("a dialog with a contour");
  await page.getByRole("link", { name: turnwise.t.page.home }).click();
  await turnwise.editor.openExample("flange");
  await fitEverywhere("a program");
});
