import { drawing as notes } from "../src/i18n/en/drawing.ts";
import { drawingImport as words } from "../src/i18n/en/drawing-import.ts";
import { expectFineInBothThemes } from "./pages/layout-checks.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

type Place = readonly [number, number];
const groups = (...pairs: readonly (readonly [number, string | number])[]) =>
  pairs.map(([code, value]) => `${code}\n${value}\n`).join("");
const line = ([x, y]: Place, [u, v]: Place, layer: string) =>
  groups([0, "LINE"], [8, layer], [10, x], [20, y], [11, u], [21, v]);

/** A bush in half section, with its centre line and a gap of 0.4 mm in the bore. */
const SECTION: readonly Place[] = [
  [150, 120],
  [150, 135],
  [120, 135],
  [120, 142],
  [90, 142],
  [90, 120],
  [149.6, 120],
];
const DXF = [
  groups([0, "SECTION"], [2, "HEADER"], [9, "$INSUNITS"], [70, 4], [0, "ENDSEC"], [0, "SECTION"], [2, "ENTITIES"]),
  ...SECTION.slice(1).map((to, i) => line(SECTION[i] as Place, to, "PART")),
  line([80, 100], [160, 100], "CENTER"),
  groups([0, "ENDSEC"], [0, "EOF"]),
].join("");

test("a dropped drawing becomes a verified part; its contour is picked by tap and keyboard, its gap stays noted", async ({
  page,
}) => {
  const turnwise = await Turnwise.open(page);
  const { editor, contour, dialog: prompts, effect } = turnwise;
  await editor.drop({ "bush.dxf": DXF });
  const dialog = page.getByRole("dialog", { name: words.title, exact: true }),
    sheet = dialog.getByRole("group", { name: words.sheet, exact: true }),
    rows = dialog.getByRole("listbox").getByRole("option"),
    use = dialog.getByRole("button", { name: words.newProgram, exact: true });
  await expect(sheet).toBeFocused();
  await expect(dialog).toContainText(words.source.file);
  await expect(dialog.getByRole("button", { name: /0\.4 mm/ })).toBeVisible();
  await expectFineInBothThemes(page, "the contour of a drawing");

  // Closed, the section has an outside and a bore; a tap on its lower line chooses the bore.
  await dialog.getByRole("button", { name: words.closeGapOf(1), exact: true }).click();
  const bore = dialog.getByRole("radio", { name: words.sides.bore, exact: true });
  await expect(rows).toHaveCount(5);
  await dialog.getByRole("button", { name: words.showContour, exact: true }).click();
  // The contour fills the picture but for its margins: its middle is that of the picture, 11 mm above the bore.
  const { width, height } = (await sheet.boundingBox()) ?? { width: 0, height: 0 };
  const scale = Math.min((width - 72) / 108, (height - 64) / 70);
  await sheet.click({ position: { x: width / 2, y: height / 2 + 11 * scale } });
  await expect(bore).toBeChecked();
  await expect(rows).toHaveCount(2);
  await dialog.getByRole("radio", { name: words.sides.outside, exact: true }).check();

  // By keyboard: Z0 at the next point to the left, and back by the proposal.
  await dialog.getByRole("radio", { name: words.pick.zero, exact: true }).check();
  await sheet.focus();
  await page.keyboard.press("ArrowLeft");
  const zero = dialog.getByRole("textbox", { name: `${words.zero} ${words.zeroAt.x}`, exact: true });
  await expect(zero).not.toHaveValue("150");
  await dialog.getByRole("button", { name: words.atEnd.x.high, exact: true }).click();
  await expect(zero).toHaveValue("150");
  await expect(rows).toHaveCount(5);
  await use.click();

  await expect(contour.x(1)).toHaveValue("40");
  await expect(contour.z(5)).toHaveValue("-60");
  await expect(page.getByText(notes.gapJoined({ width: "0.4", x: "40", z: "-0.2" }))).toBeVisible();
  await turnwise.show("prompts");
  await page.getByRole("button", { name: /^Use \d+ suggestions$/ }).click();
  for (const q of ["Q215", "Q499"]) await prompts.set(q, "0");
  await expect(effect.cell("proof")).toHaveText(/^(?:Verified|Path verified)/);
});
