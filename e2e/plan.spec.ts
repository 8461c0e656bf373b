import { plan as words } from "../src/i18n/en/plan.ts";
import { provedIn } from "./pages/effect.ts";
import { expectAccessibleAndFits } from "./pages/layout-checks.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

const ROWS = [
  ["0", "0"],
  ["30", ""],
  ["", "-40"],
  ["46", ""],
  ["", "-70"],
] as const;

test("a part is typed, planned, planned again without a tool, and opened as a verified program", async ({ page }) => {
  const { contour, editor, t } = await Turnwise.open(page);
  const button = (name: string | RegExp) => page.getByRole("button", { name, exact: true });
  const strip = page.getByRole("region", { name: words.result.title, exact: true });
  const steps = page.getByRole("list", { name: words.steps.title, exact: true }).getByRole("listitem");

  await page.getByRole("link", { name: "Working plan from the part", exact: true }).click();
  await expect(strip).toContainText(words.run.empty);
  for (const [i, [x, z]] of ROWS.entries()) {
    await contour.add.click();
    await contour.x(i + 1).fill(x);
    await contour.z(i + 1).fill(z);
  }
  await page.getByRole("textbox", { name: words.mark.tolerance, exact: true }).fill("h6");
  await expect(button(words.mark.go(5, "h6"))).toBeVisible();
  await expectAccessibleAndFits(page);

  // The focus stays where it was pressed.
  await button(words.run.plan).press("Enter");
  await expect(strip).toContainText(words.result.rest);
  await expect(button(words.run.again)).toBeFocused();
  await expect(steps.first()).toContainText(words.kinds.face);
  await steps.first().getByRole("button").first().click();
  await expectAccessibleAndFits(page);

  // What follows from an excluded tool is planned again.
  const exclude = button(/^Exclude T\d/);
  const tool = (await exclude.innerText()).replace("Exclude ", "");
  await exclude.click();
  await expect(steps.first()).not.toContainText(tool);
  await expect(strip).toContainText(words.result.rest);

  // The part is kept and planned again at once, and a plan of a part that was changed is shown as outdated.
  await page.reload();
  await expect(contour.z(5)).toHaveValue("-70");
  await expect(strip).toContainText(words.result.rest);
  await page.getByRole("tab", { name: words.tabs.part, exact: true }).click();
  await contour.x(2).fill("28");
  await expect(strip).toContainText(words.run.outdated);
  await expect(button(words.result.open)).toBeDisabled();
  await button(words.run.again).click();
  await button(words.result.open).click();
  await expect(editor.text).toContainText("BEGIN PGM PART MM");
  await expect(editor.total(t.findings.verdict.title)).toHaveText(provedIn(t));
  await page.goBack();
  await expect(page).toHaveURL(/#\/plan$/);
});
