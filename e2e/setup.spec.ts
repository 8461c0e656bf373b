import { expect, test } from "@playwright/test";
import { Turnwise } from "./pages/turnwise.ts";

test("a tool that cannot make the contour says so at once, and names one that can", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { setup, effect, program, t } = turnwise;
  await turnwise.start.beginWithExample(852);
  await expect(effect.cell("proof")).toHaveText(t.page.effect.clean);
  await turnwise.show("setup");
  await setup.tool(1).check();
  const offer = page.getByRole("button", { name: new RegExp(`^${t.setup.tool.take(8)}`) });
  await expect(offer).toBeVisible();
  expect(await program.copy()).toContain("TOOL CALL 1");
  await offer.click();
  await expect(setup.tool(8)).toBeChecked();
  await expect(effect.cell("proof")).toHaveText(t.page.effect.clean);
});

test("a start point that stands in the material is said at its field, and the picture follows the blank", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { setup, effect, lathe, t } = turnwise;
  await turnwise.start.beginWithExample(812);
  await expect(effect.cell("proof")).toHaveText(t.page.effect.clean);
  await turnwise.show("setup");
  const before = await effect.cell("time").textContent();
  await setup.spindle("cuttingSpeed").fill("90");
  await expect(effect.cell("time")).not.toHaveText(before ?? "");
  await setup.start("x").fill("70");
  await setup.start("z").fill("-10");
  await expect(page.getByRole("tab", { name: new RegExp(`^${t.page.problems}`) })).toContainText(/\d/);
  await turnwise.show("problems");
  await turnwise.problems.panel.getByRole("button", { name: t.page.problem.goTo(t.page.problem.places.startX), exact: true }).first().click();
  await expect(setup.start("x")).toBeFocused();
  await setup.start("x").fill("75");
  await setup.start("z").fill("2");
  await setup.blank("bore").fill("20");
  await expect(lathe.picture).toBeVisible();
  await expect(setup.blank("bore")).toHaveAttribute("aria-invalid", "false");
  await setup.blank("outside").fill("-3");
  await expect(setup.blank("outside")).toHaveAttribute("aria-invalid", "true");
});
