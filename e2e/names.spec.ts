import { existsSync, readFileSync } from "node:fs";
import { advice } from "../src/i18n/en/advice.ts";
import { output } from "../src/i18n/en/output.ts";
import { ambiguous, controls, kinds } from "./pages/controls.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

test.use({ reducedMotion: "no-preference" });

/** The snapshot, and the time a screen gets to show its names, ms; a changed name takes all of it. */
const LIST = new URL("names.txt", import.meta.url),
  LATEST = 15_000;

/*
 * External tests rely on roles and names: e2e/names.txt lists each under the first screen that has it, and changing one
 * is a decision. After one, `npm run e2e -- names --update-snapshots` rewrites the list.
 */
test("every control of every screen has the name listed for it, and no other control has that name", async ({
  page,
}) => {
  const turnwise = await Turnwise.open(page, { heldClock: true, seed: 7 });
  const { comparison, course, dialog, editor, effect, menus, sharing, own, settings, sheet, start, t, tools, works } =
    turnwise;
  const home = () => page.getByRole("link", { name: t.page.home }).click();
  const screens: string[] = [];
  const known = new Set<string>();
  // Waits for the listed names, since some appear late. The comparison at the end checks that all are there, and no
  // others.
  const listed = (existsSync(LIST) ? readFileSync(LIST, "utf8") : "").trimEnd().split("\n\n");
  const look = async (screen: string, part = page.locator("body")) => {
    const fresh = async () => kinds(await controls(part)).filter((kind) => !known.has(kind));
    const section = async () => [`# ${screen}`, ...(await fresh())].join("\n");
    await expect
      .poll(async () => listed.includes(await section()), { timeout: LATEST })
      .toBe(true)
      .catch(() => undefined);
    expect.soft(ambiguous(await controls(part)), `on the screen "${screen}"`).toEqual([]);
    screens.push(await section());
    for (const kind of await fresh()) known.add(kind);
  };

  await start.button(812, true).waitFor();
  await course.entrance.waitFor();
  await page.getByRole("button", { name: t.start.hero.pause, exact: true }).waitFor();
  await look("start");
  await page.getByRole("button", { name: t.page.start.which, exact: true }).click();
  await expect(page.getByRole("dialog").getByRole("list").first()).toHaveAttribute("aria-busy", "false");
  await look("which cycle", page.getByRole("dialog"));
  await page.keyboard.press("Escape");
  await settings.open();
  await settings.saveAll.waitFor();
  await look("settings", settings.dialog);
  await page.keyboard.press("Escape");

  await start.beginWithExample(820);
  await effect.proved();
  await look("cycle: a choice");
  await dialog.open("Q463");
  await look("cycle: a number");
  await turnwise.show("setup");
  await page.getByRole("region", { name: advice.starting, exact: true }).waitFor();
  await look("cycle: set-up");
  await turnwise.show("contour");
  await turnwise.contour.add.waitFor();
  await turnwise.contour.canvas.waitFor();
  await look("cycle: contour");
  await turnwise.show("findings");
  await turnwise.findings.panel.waitFor();
  await look("cycle: findings");

  await tools.open();
  await tools.rowButton(1).click();
  await look("tools");
  await tools.close();

  await home();
  await editor.openExample("flange");
  await expect(editor.total(t.page.effect.time)).toHaveText(/\d/);
  await look("program");
  await editor.show("findings");
  await turnwise.findings.items.first().waitFor();
  await look("program: findings");
  await editor.show("structure");
  await editor.line("CYCL DEF").click();
  await editor.show("block");
  await look("program: block");

  await comparison.open();
  await comparison.withOpened();
  await expect(comparison.summary).not.toBeEmpty();
  await look("compare", comparison.dialog);
  await comparison.close();
  await sharing.openDialog();
  await sharing.link();
  await look("hand on", sharing.shareDialog);
  await page.keyboard.press("Escape");
  await menus.choose("program", t.page.text.output);
  await page.getByRole("dialog", { name: output.title, exact: true }).waitFor();
  await look("NC output", page.getByRole("dialog"));
  await page.keyboard.press("Escape");
  await sheet.open();
  await expect(sheet.preview).toContainText("FLANGE");
  await look("setup sheet");
  await sheet.close();

  await home();
  await works.open();
  await expect(works.rows).toHaveCount(2);
  await works.select("FLANGE.h").check();
  await look("works");

  await home();
  await course.open();
  await look("course");
  await course.openLesson(3);
  await course.page(2).click();
  await course.slide("Q463").waitFor();
  await look("course: a page of a lesson");

  await page.goto(".?clock=manual&seed=7#/own");
  await own.add.click();
  await page.getByRole("button", { name: `${t.page.undo}:` }).waitFor();
  await look("own cycles");
  expect(`${screens.join("\n\n")}\n`).toMatchSnapshot("names.txt");
});
