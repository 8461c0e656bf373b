import { Insertion } from "./pages/insertion.ts";
import { provedIn } from "./pages/effect.ts";
import { tabTo } from "./pages/keyboard.ts";
import { expectAccessibleAndFits } from "./pages/layout-checks.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

/** Most values, choices and confirmations from the empty page to the verified program. */
const MOST_ENTRIES = 45;

test("a bushing from the empty page, by keyboard alone", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { editor, t } = turnwise;
  const { keyboard } = page;
  const insertion = new Insertion({ page, t, language: "en" });
  const verdict = editor.total(t.findings.verdict.title);

  await tabTo(page, page.getByRole("button", { name: t.page.programs.create, exact: true }));
  await keyboard.press("Enter");
  await expect(page.getByRole("textbox", { name: t.operations.programName })).toBeFocused();
  await keyboard.type("BUSHING");
  for (const [field, size] of [
    ["outside", "80"],
    ["bore", "38"],
    ["length", "61"],
  ] as const) {
    await tabTo(page, page.getByRole("textbox", { name: t.setup.blank[field] }));
    await keyboard.type(size);
    insertion.entries += 1;
  }
  await insertion.enter("");

  await insertion.begin(822);
  // Sizes that follow from the stock are only suggested: nothing is verified before they are confirmed.
  await expect(verdict).not.toHaveText(provedIn(t));
  await expectAccessibleAndFits(page);
  await insertion.answer([
    ["Q493", ""],
    ["Q494", ""],
  ]);
  await expect(verdict).toHaveText(provedIn(t));
  await insertion.next();

  await insertion.begin(812);
  await insertion.answer([
    ["Q493", "70"],
    ["Q494", "-15"],
    ["Q495", ""],
    ["Q501", "1"],
    ["Q502", "1.5"],
  ]);
  await insertion.next();

  await insertion.begin(862, { start: "-12" });
  await insertion.answer([
    ["Q493", "67"],
    ["Q494", "-15"],
  ]);
  await insertion.next();

  // The thread takes the cylinder that carries it, and the recess behind it as its relief.
  await insertion.begin(831);
  await insertion.answer([
    ["Q472", "1.5"],
    ["Q473", ""],
    ["Q492", ""],
    ["Q494", ""],
    ["Q474", ""],
  ]);
  await insertion.next();

  await insertion.begin(812, { site: "inside" });
  await insertion.answer([
    ["Q493", "40"],
    ["Q494", "-61"],
    ["Q495", ""],
    ["Q501", "1"],
    ["Q502", "1"],
  ]);
  await expect(editor.total(t.editor.operations)).toHaveText("5");
  await expect(verdict).toHaveText(provedIn(t));
  expect(insertion.entries).toBeLessThan(MOST_ENTRIES);

  const text = (await editor.downloaded()).toString();
  expect(text).toMatch(/Q491=\+70 ;[^~]*~\nQ472=\+1\.5 /);
  expect(text).toContain("VCONST:OFF S550");
});
