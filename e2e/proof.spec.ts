import { readFile } from "node:fs/promises";
import { expectAccessibleAndFits } from "./pages/layout-checks.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

test("a cut below the contour of a cycle asks for confirmation, and one click confirms it", async ({ page }) => {
  const { editor, findings, t } = await Turnwise.open(page);
  await editor.paste(await readFile("tests/proof/groove-by-feed-below-a-contour.h", "utf8"));
  await editor.show("findings");
  const asked = findings.panel.getByText("below the contour of the cycle in block 9").first();
  await expect(asked).toBeVisible();
  await expectAccessibleAndFits(page);
  await page.getByRole("button", { name: t.findings.meant, exact: true }).first().click();
  await expect(asked).toBeHidden();
  await expect(findings.panel.getByText("Marked as intended")).toBeVisible();
  await editor.show("text");
  await expect(editor.text).toContainText("INTENDED CUT");
});

test("a part that is parted off leaves the picture, and turning it afterwards is an error", async ({ page }) => {
  const { editor, findings, t } = await Turnwise.open(page, { language: "de" });
  await editor.paste(await readFile("tests/proof/parted-off-then-turned.h", "utf8"));
  await expect(editor.total(t.findings.verdict.title)).toContainText(t.findings.verdict.faults(1));
  await editor.show("findings");
  await expect(findings.panel.getByText("Satz 9 trennt dieses Stück").first()).toBeVisible();
  await expectAccessibleAndFits(page);
});
