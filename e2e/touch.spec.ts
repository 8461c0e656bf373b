import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";
import { answers } from "./pages/values.ts";

test.use({ hasTouch: true });

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
  for (const key of await dialog.keypad.getByRole("button").all()) {
    const box = await key.boundingBox();
    expect(Math.min(box?.width ?? 0, box?.height ?? 0), await key.getAttribute("aria-label") ?? "").toBeGreaterThanOrEqual(TARGET);
  }
  await dialog.key("signLong").tap();
  await expect(dialog.value).toHaveValue("-50");
  await dialog.key("cancel").tap();
  await expect(dialog.value).toHaveValue("50");
});
