import { expect, test } from "./pages/test.ts";
import { tabTo } from "./pages/keyboard.ts";
import { Turnwise } from "./pages/turnwise.ts";
import { answers, type Answers } from "./pages/values.ts";

/**
 * Values that differ from the example, so that showing the example can not pass: a sum, a comma and a choice. The
 * contour is the printed one, deeper.
 */
const OWN: Answers = { Q463: "75/30", Q488: "0,12", Q506: "1" };
const EXPECTED = ["Q463=+2.5 ", "Q488=+0.12 ", "Q506=+1 ", "L X+75 Z-20", "RND R2"];
/** One row per element: what is typed into its fields. */
const CONTOUR: readonly { kind: string; x?: string; z?: string; r?: string }[] = [
  { kind: "L", x: "75", z: "-20" },
  { kind: "L", x: "50" },
  { kind: "RND", r: "2" },
  { kind: "L", x: "20", z: "-25" },
  { kind: "RND", r: "2" },
  { kind: "L", z: "0" },
];

test("cycle 820 from the empty page to the copied program by keyboard alone", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { dialog, program, effect } = turnwise;
  const { keyboard } = page;
  await tabTo(page, turnwise.start.search);
  await keyboard.type("820");
  await expect(turnwise.start.button(820, false)).toBeVisible();
  await keyboard.press("ArrowDown");
  await expect(turnwise.start.button(820, true)).toBeFocused();
  await keyboard.press("ArrowRight");
  await keyboard.press("Enter");
  await expect(dialog.question).toHaveText(turnwise.t.setup.blank.outside);
  await keyboard.press("End");

  await expect(dialog.question).toHaveText(turnwise.t.dialog.contour.question);
  await keyboard.press("Enter");
  const table = turnwise.contour;
  for (const [i, row] of CONTOUR.entries()) {
    await tabTo(page, table.add);
    await keyboard.press("Enter");
    const n = i + 1;
    if (row.kind !== "L") {
      await tabTo(page, table.kind(n), "Shift+Tab");
      await table.kind(n).press(row.kind === "RND" ? "R" : "C");
      await expect(table.kind(n)).toHaveValue(row.kind);
    }
    for (const [field, text] of [
      [table.x(n), row.x],
      [table.z(n), row.z],
      [table.radius(n), row.r],
    ] as const) {
      if (text === undefined) continue;
      await tabTo(
        page,
        field,
        (await field.evaluate((e) =>
          Boolean(
            document.activeElement &&
            document.activeElement.compareDocumentPosition(e) & Node.DOCUMENT_POSITION_PRECEDING,
          ),
        ))
          ? "Shift+Tab"
          : "Tab",
      );
      await keyboard.type(text);
    }
  }
  await tabTo(page, page.getByRole("button", { name: turnwise.t.dialog.contour.back, exact: true }), "Shift+Tab");
  await keyboard.press("Enter");

  for (const [q, value] of Object.entries(answers(820, OWN))) {
    await expect(dialog.question).toHaveText(dialog.promptOf(820, q));
    await keyboard.type(value);
    await keyboard.press("Enter");
  }
  await expect(dialog.question).toHaveText(turnwise.t.dialog.done.title);
  await expect(effect.cell("passes")).not.toHaveText(turnwise.t.page.effect.unknown);
  await effect.proved();
  await expect(program.copyButton).toBeFocused();
  await keyboard.press("Enter");
  const text = await program.clipboard();
  await expect(program.confirmation).toBeVisible();
  expect(text).toMatch(/^0\s+BEGIN PGM /);
  for (const line of EXPECTED) expect(text.replace(/ +/g, " ")).toContain(line);
  await expect
    .poll(() => program.shown())
    .toEqual(
      text
        .trimEnd()
        .split(/\r?\n/)
        .map((line) => line.trimEnd()),
    );
});

test("dimensions of the contour are chosen and typed on the drawing by keyboard alone", async ({ page }) => {
  const turnwise = await Turnwise.open(page, { language: "de" });
  const { contour, t } = turnwise;
  const { keyboard } = page;
  await turnwise.start.beginWithExample(820);
  await turnwise.show("contour");
  await tabTo(page, contour.canvas);
  // On its way, focus passed through the table: its last element is the selected one.
  for (let i = 0; i < 2; i += 1) await keyboard.press("ArrowLeft");
  await expect(contour.drawing).toHaveAccessibleName(new RegExp(t.contour.drawingElement(4)));
  const x = t.contour.xOf(4),
    z = t.contour.zOf(4);
  await keyboard.press("Tab");
  await expect(contour.dimension(x)).toBeFocused();
  await keyboard.press("Enter");
  await keyboard.type("21+2,5/2");
  await keyboard.press("Enter");
  await expect(contour.x(4)).toHaveValue("22,25");
  await expect(contour.dimension(x)).toBeFocused();
  await keyboard.press("Tab");
  await expect(contour.dimension(z)).toBeFocused();
  await keyboard.press("Enter");
  await keyboard.type("-31");
  await keyboard.press("Escape");
  await expect(contour.z(4)).toHaveValue("-25");
  await expect(contour.dimension(z)).toBeFocused();
  await keyboard.press("Control+z");
  await expect(contour.x(4)).toHaveValue("20");
});
