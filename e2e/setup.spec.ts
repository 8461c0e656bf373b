import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

test("an unfit tool, a start point inside the material and a Q parameter are reported and answered", async ({
  page,
}) => {
  const turnwise = await Turnwise.open(page);
  const { dialog, setup, effect, lathe, program, t } = turnwise;
  await turnwise.start.beginWithExample(852);
  await effect.proved();
  await turnwise.show("setup");
  await setup.tool(1).check();
  const offer = page.getByRole("button", { name: new RegExp(`^${t.setup.tool.take(8)}`) });
  await expect(offer).toBeVisible();
  await expect(program.blocks.filter({ hasText: "TOOL CALL 1" })).toBeVisible();
  await offer.click();
  await expect(setup.tool(8)).toBeChecked();
  await effect.proved();

  // A start point inside the material is reported at its field, and the picture follows the blank.
  await page.getByRole("link", { name: t.page.home, exact: true }).click();
  await turnwise.start.beginWithExample(812);
  await effect.proved();
  await turnwise.show("setup");
  const before = await effect.cell("time").textContent();
  await setup.spindle("cuttingSpeed").fill("90");
  await expect(effect.cell("time")).not.toHaveText(before ?? "");
  await setup.start("x").fill("70");
  await setup.start("z").fill("-10");
  await expect(page.getByRole("tab", { name: new RegExp(`^${t.findings.title}`) })).toContainText(/\d/);
  await turnwise.show("findings");
  await turnwise.findings.panel
    .getByRole("button", { name: t.findings.goTo(t.findings.places.startX), exact: true })
    .first()
    .click();
  await expect(setup.start("x")).toBeFocused();
  await setup.start("x").fill("75");
  await setup.start("z").fill("2");
  await setup.blank("bore").fill("20");
  await expect(lathe.picture).toBeVisible();
  await expect(setup.blank("bore")).toHaveAttribute("aria-invalid", "false");
  await setup.blank("outside").fill("-3");
  await expect(setup.blank("outside")).toHaveAttribute("aria-invalid", "true");

  // A Q parameter in a prompt asks for its value, and the program sets it before the cycle.
  await page.getByRole("link", { name: t.page.home, exact: true }).click();
  await turnwise.start.beginWithExample(812);
  await effect.proved();
  const time = await effect.cell("time").textContent();
  await dialog.open("Q493");
  await dialog.type("q5");
  await expect(dialog.messages).toContainText("Q5");
  await dialog.active.getByRole("button", { name: t.dialog.giveParameter("Q5"), exact: true }).click();
  const value = setup.parameter("Q5");
  await expect(value).toBeFocused();
  await expect(page.getByText(t.setup.parameters.ask("Q5"))).toBeVisible();
  await value.fill("40");
  await effect.proved();
  await expect(effect.cell("time")).not.toHaveText(time ?? "");
  const text = await program.copy();
  expect(text).toMatch(/\n\d+ Q5 = 40\r?\n/);
  expect(text).toContain("Q493=+Q5");
  await turnwise.show("prompts");
  await dialog.open("Q494");
  await dialog.type("-Q5/2-1");
  await page.keyboard.press("Enter");
  await expect(dialog.line("Q494")).toContainText("-21");
  await turnwise.undo();
  await turnwise.undo();
  await page.reload();
  await turnwise.show("setup");
  await expect(value).toHaveValue("40");
});
