import type { Locator, Page } from "@playwright/test";
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

/** Its smaller end, mm, is in the jaws of the first clamping. */
const STUD = {
  format: "turnwise-part/1",
  name: "STUD",
  material: "brass",
  blank: { outside: 40, bore: 0, length: 42, allowance: 1 },
  clamping: { kind: "chuckOutside", words: { D: 40, LENGTH: 18, FACE: -23, SIZE: 160 } },
  outside: [{ x: 0, z: 0 }, { x: 36 }, { z: -24 }, { x: 24 }, { z: -40 }],
  inside: [],
  marks: {},
};

const button = (page: Page, name: string | RegExp) => page.getByRole("button", { name, exact: true });
const strip = (page: Page) => page.getByRole("region", { name: words.result.title, exact: true });
const steps = (page: Page) => page.getByRole("list", { name: words.steps.title, exact: true }).getByRole("listitem");

/** Waits for the end of a search. */
async function planned(page: Page): Promise<void> {
  await expect(strip(page).getByRole("status")).toHaveAttribute("aria-busy", "false");
  await expect(steps(page).first()).toBeVisible();
}

/** Moves the focus to an element with the Tab key, and the arrows in its toolbar; it is never lost on the way. */
async function tabTo(target: Locator, back = false): Promise<void> {
  const page = target.page();
  await target.waitFor();
  for (let i = 0; i < 150; i += 1) {
    const [isThere, isInBar] = await target.evaluate((element) => {
      const { activeElement } = document;
      return [element === activeElement, element.closest("[role=toolbar]")?.contains(activeElement) ?? false] as const;
    });
    if (isThere) return;
    if (isInBar) await page.keyboard.press(back ? "ArrowLeft" : "ArrowRight");
    else await page.keyboard.press(back ? "Shift+Tab" : "Tab");
  }
  await expect(target).toBeFocused();
}

/** The focus is on an element of the page. */
const expectFocus = (page: Page): Promise<void> =>
  expect.poll(() => page.evaluate(() => document.activeElement !== document.body)).toBe(true);

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

test("a part is planned, changed and opened by keyboard alone", async ({ page }) => {
  const { contour, editor, t } = await Turnwise.open(page);
  const enter = async (target: Locator, back = false) => {
    await tabTo(target, back);
    await page.keyboard.press("Enter");
    await expectFocus(page);
  };
  const type = async (target: Locator, text: string) => {
    await tabTo(target);
    await page.keyboard.press("ControlOrMeta+a");
    await page.keyboard.type(text);
  };
  const mark = (name: string) => page.getByRole("textbox", { name, exact: true });

  await enter(page.getByRole("link", { name: "Working plan from the part", exact: true }));
  for (const [i, [x, z, thread]] of [
    ["0", "0"],
    ["20", ""],
    ["", "-20", "M20x1.5"],
    ["18", ""],
    ["", "-25"],
    ["30", ""],
    ["", "-45"],
  ].entries()) {
    await enter(contour.add, true);
    if (x) await type(contour.x(i + 1), x);
    if (z) await type(contour.z(i + 1), z);
    if (thread) await type(mark(words.mark.thread), thread);
  }
  await type(mark(words.mark.tolerance), "h7");
  await enter(button(page, words.run.plan));
  await planned(page);
  await expectFocus(page);

  // Another way, with the focus at its operation afterwards.
  const way = button(page, /^Operation 2: use /);
  await enter(steps(page).nth(1).getByRole("button").first(), true);
  const name = (await way.first().getAttribute("aria-label")) ?? "";
  await enter(way.first());
  await planned(page);
  await expectFocus(page);
  await expect(steps(page).nth(1)).toContainText(/T\d+/.exec(name)?.[0] ?? "");
  await expect(button(page, words.steps.lock(2))).toHaveAttribute("aria-pressed", "true");
  await enter(button(page, words.steps.lock(1)), true);
  await expect(button(page, words.steps.lock(1))).toHaveAttribute("aria-pressed", "true");

  // A value: what it does is shown, then it is applied with Enter.
  const form = page.getByRole("form", { name: words.steps.valuesLong(2), exact: true });
  await type(form.getByRole("textbox").first(), "0.7");
  await expect(form).toContainText(words.steps.preview);
  await page.keyboard.press("Enter");
  await planned(page);
  await expectFocus(page);
  await expect(form.getByRole("textbox").first()).toHaveValue("0.7");
  await expect(form).toContainText(words.steps.planned("").trim());
  await expectAccessibleAndFits(page);
  await enter(button(page, words.result.open));
  await expect(editor.text).toContainText("BEGIN PGM PART MM");
  await expect(editor.total(t.findings.verdict.title)).toHaveText(provedIn(t));
});

test("a dropped part file is planned in two clampings, and both can be changed", async ({ page }) => {
  const { editor } = await Turnwise.open(page);
  await editor.drop({ "stud.json": JSON.stringify(STUD) });
  await expect(page.getByRole("textbox", { name: words.part.name, exact: true })).toHaveValue("STUD");
  await button(page, words.run.plan).click();
  await planned(page);
  await button(page, words.result.second).click();
  await steps(page).nth(1).getByRole("button").first().click();
  const infeed = () => page.getByRole("form").getByRole("textbox").first();
  const before = await infeed().inputValue();

  await infeed().fill("0.9");
  await expect(page.getByRole("form")).toContainText(words.steps.longer("").trim());
  await button(page, words.steps.apply).click();
  await planned(page);
  await expect(steps(page).nth(1)).toContainText(words.because.byHand);
  await expect(button(page, words.result.second)).toHaveAttribute("aria-pressed", "true");
  await expectAccessibleAndFits(page);

  // It stays after a reload, and can be taken back.
  await page.reload();
  await page.getByRole("tab", { name: words.tabs.plan, exact: true }).click();
  await planned(page);
  await button(page, words.result.second).click();
  await steps(page).nth(1).getByRole("button").first().click();
  await expect(infeed()).toHaveValue("0.9");
  await button(page, words.steps.usePlanned).click();
  await planned(page);
  await expect(infeed()).toHaveValue(before);
  await button(page, words.result.openSecond).click();
  await expect(editor.text).toContainText("STUD_2");

  // The open program is a part again.
  await page.goBack();
  await button(page, words.part.more).click();
  await page.getByRole("menuitem", { name: words.part.fromProgram, exact: true }).click();
  await expect(page.getByRole("textbox", { name: words.part.name, exact: true })).toHaveValue(/^STUD_2/);
});
