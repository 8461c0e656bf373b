import { readFileSync } from "node:fs";
import { pictureAt } from "./pages/picture.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

test.use({ reducedMotion: "no-preference" });

const FLANGE = readFileSync(new URL("../src/examples/flange.h", import.meta.url), "utf8");
/** The mistyped infeed of the first roughing cycle: far larger than the others. */
const WRONG = FLANGE.replace("Q463=+3 ;MAX. CUTTING DEPTH", "Q463=+0.3 ;MAX. CUTTING DEPTH");

const stageOf = (turnwise: Turnwise) => turnwise.lathe.view.getByRole("group", { name: turnwise.t.lathe.title });

const differing = (text: string) => text.split(/\r?\n/).filter((line, i) => line !== FLANGE.split(/\r?\n/)[i]);

test("a wrong infeed is found in the picture, by mouse and by keyboard, and fixed at its prompt; lines move the tool", async ({
  page,
}) => {
  const turnwise = await Turnwise.open(page);
  const { editor, lathe, dialog, program } = turnwise;
  await editor.paste(WRONG);
  await expect(editor.total(turnwise.t.page.effect.passes)).toHaveText("81");
  const at = await pictureAt(page, stageOf(turnwise), -22.3, 78);
  await page.mouse.move(at.x, at.y);
  await page.mouse.click(at.x, at.y);
  await expect(lathe.running).toContainText("Step 2 of 6");
  await expect(editor.heading).toContainText("19");
  await expect(dialog.value).toHaveAccessibleName(/^Q463/);
  await expect(dialog.value).toHaveValue("0.3");
  await dialog.value.fill("3");
  await dialog.value.press("Enter");
  await expect(editor.total(turnwise.t.page.effect.passes)).toHaveText("25");
  expect(differing(await program.copy())).toEqual([]);

  // The same by keyboard: from the picture to the prompt and back.
  await turnwise.undo();
  await expect(editor.total(turnwise.t.page.effect.passes)).toHaveText("81");
  await stageOf(turnwise).focus();
  await page.keyboard.press("Home");
  for (let i = 0; i < 200 && !/Block 21/.test((await lathe.running.textContent()) ?? ""); i += 1)
    await page.keyboard.press("ArrowRight");
  await expect(lathe.running).toContainText("Block 21");
  await page.keyboard.press("Enter");
  await expect(dialog.value).toHaveAccessibleName(/^Q463/);
  await expect(dialog.value).toBeFocused();
  await page.keyboard.type("3");
  await page.keyboard.press("Enter");
  await expect(editor.total(turnwise.t.page.effect.passes)).toHaveText("25");
  expect(differing(await program.copy())).toEqual([]);

  // A line of the text moves the tool to the start of its block, and marks its path.
  await editor.show("structure");
  await editor.filter("all");
  await editor.part("TOOL CALL 15").click();
  await expect(lathe.running).toContainText("Block 11");
  await editor.line("12 CYCL CALL").click();
  await expect(lathe.running).toContainText("Block 12");
  await expect(lathe.view.locator(".shape-marked")).toHaveCount(1);
  await page.keyboard.press("ArrowUp");
  await expect(lathe.running).toContainText("Block 11");
  await editor.show("structure");
  await editor.filter("all");
  await editor.part("TOOL CALL 3").click();
  await expect(lathe.running).toContainText("Block 33");
});

test("in the workplace of one cycle: the same place everywhere, measured, compared, and its paths hidden", async ({
  page,
}) => {
  const turnwise = await Turnwise.open(page);
  const { lathe, dialog, effect, program, t } = turnwise;
  await turnwise.start.beginWithExample(812);
  await effect.proved();
  await program.panel
    .getByRole("code")
    .filter({ hasText: /^Q505=/ })
    .click();
  await expect(dialog.value).toHaveAccessibleName(/^Q505/);
  await expect(program.runningBlock).toContainText("CYCL CALL");
  await lathe.view.getByRole("button", { name: t.lathe.stepList.unfold, exact: true }).click();
  const steps = lathe.view.getByRole("list", { name: t.lathe.stepList.title }).getByRole("listitem");
  await expect(steps).toHaveCount(6);
  await steps.nth(2).getByRole("button").click();
  await expect(lathe.running).toContainText("Step 3 of 6");
  await expect(steps.nth(2)).toHaveAttribute("aria-current", "step");
  const at = await pictureAt(page, stageOf(turnwise), -20.7, 65);
  await page.mouse.click(at.x, at.y);
  await expect(dialog.value).toHaveAccessibleName(/^Q463/);
  await expect(lathe.running).toContainText("Step 2 of 6");

  // A move without a prompt of its own leaves the keyboard in the picture.
  await stageOf(turnwise).focus();
  await page.keyboard.press("Home");
  await page.keyboard.press("Enter");
  await expect(stageOf(turnwise)).toBeFocused();

  // A drag with the ruler measures, and leaves the picture where it is.
  await lathe.button("ruler").click();
  const reading = lathe.view.locator(".measure-panel");
  await expect(reading.getByRole("status")).not.toBeEmpty();
  const stage = stageOf(turnwise);
  const from = await pictureAt(page, stage, -90, 20),
    to = await pictureAt(page, stage, -70, 30);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move((from.x + to.x) / 2, to.y, { steps: 4 });
  await page.mouse.move(to.x, to.y, { steps: 4 });
  await page.mouse.up();
  await expect(reading.getByRole("status")).toContainText(/20/);
  expect(await pictureAt(page, stage, -90, 20)).toEqual(from);
  await lathe.button("ruler").click();

  // A dimension in the help picture opens its prompt; a measured length goes into the open one.
  await page.locator(".help-picture text[data-q=Q493]").click();
  await expect(dialog.value).toHaveAccessibleName(/^Q493/);
  await lathe.button("ruler").click();
  const origin = await pictureAt(page, stageOf(turnwise), 0, 0);
  await page.mouse.click(origin.x, origin.y);
  const offer = lathe.view.getByRole("button", { name: t.lathe.takeInto("⌀0", "Q493") });
  await offer.click();
  await expect(dialog.value).toHaveValue("0");
  await page.keyboard.press("ControlOrMeta+z");
  await expect(dialog.value).toHaveValue("50");
  await lathe.button("ruler").click();

  // Two settings are compared, and the pinned one is restored in one step.
  const words = t.page.effect.pin;
  await effect.strip.getByRole("button", { name: words.make }).click();
  await dialog.set("Q463", "2");
  await dialog.set("Q505", "0.13");
  await expect(effect.cell("passes")).toHaveText("7");
  const card = page.getByRole("region", { name: words.title, exact: true });
  await expect(card.getByRole("row", { name: /^Passes/ })).toHaveText(/5.*7/);
  await expect(card.getByRole("row", { name: /^Q505/ })).toHaveText(/0\.2.*0\.13/);
  await expect(lathe.view.locator(".lathe-pinned")).toHaveCount(1);
  await card.getByRole("button", { name: words.back }).click();
  await expect(effect.cell("passes")).toHaveText("5");
  await expect(lathe.view.locator(".lathe-pinned")).toHaveCount(0);
  await page.keyboard.press("ControlOrMeta+z");
  await expect(effect.cell("passes")).toHaveText("7");
  await card.getByRole("button", { name: words.letGo }).click();
  await expect(card).toHaveCount(0);

  // The path display is limited to the current cycle or hidden, and remembered.
  const paths = lathe.view.getByRole("combobox", { name: t.lathe.paths.title });
  const drawn = lathe.view.locator(".lathe-paths path");
  await expect(drawn).not.toHaveCount(0);
  await paths.selectOption("none");
  await expect(drawn).toHaveCount(0);
  await page.reload();
  await effect.proved();
  await expect(paths).toHaveValue("none");
  await expect(drawn).toHaveCount(0);
});

test("a changed value shows the previous one, and the previous path stays for two seconds", async ({ page }) => {
  const turnwise = await Turnwise.open(page, { heldClock: true });
  const { lathe, dialog, effect } = turnwise;
  await turnwise.start.beginWithExample(812);
  await effect.proved();
  await expect(lathe.view.locator(".lathe-paths path")).not.toHaveCount(0);
  const ghost = lathe.view.locator(".lathe-former");
  await dialog.open("Q463");
  await dialog.value.fill("2");
  await expect(effect.cell("passes")).toHaveText("7");
  await expect(effect.cell("passes")).toHaveAttribute("data-was", "5");
  await expect(effect.cell("time")).toHaveAttribute("data-by", /^\+/);
  await expect(ghost).toHaveCount(1);
  await lathe.advance(1900);
  await expect(ghost).toHaveCount(1);
  await lathe.advance(200);
  await expect(ghost).toHaveCount(0);
  await dialog.value.press("Enter");
  await expect(effect.cell("passes")).not.toHaveAttribute("data-was");
});
