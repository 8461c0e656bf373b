import { readFileSync } from "node:fs";
import { plan } from "../src/i18n/en/plan.ts";
import { expectFineInBothThemes } from "./pages/layout-checks.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";
import { words as wordsOf } from "./pages/words.ts";

interface TaskFile {
  readonly words: Readonly<Record<"en" | "de", { readonly title: string }>>;
  readonly solution: readonly string[];
  readonly wrong: readonly { readonly program: readonly string[] }[];
}
const flange = JSON.parse(
  readFileSync(new URL("../src/course/tasks/l26-bearing-flange.json", import.meta.url), "utf8"),
) as TaskFile;

/** The planner needs some seconds, and shares the machine with other tests. */
const PLANNED = { timeout: 90_000 };
test.describe.configure({ timeout: 180_000 });

test("a part from its drawing: wrong, right, and its plan beside the planner's", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { task, editor } = turnwise;
  const { words } = task;
  const c = wordsOf("en", "plan-comparison");
  await page.goto("./#/course/two-plans/tasks");
  await turnwise.course.task(flange.words.en.title).press("Enter");
  await expect(task.assignment).toBeVisible();

  const write = async (program: readonly string[]) => {
    await editor.text.press("ControlOrMeta+a");
    await page.keyboard.insertText(program.join("\n"));
    await task.check.press("Enter");
  };
  await write(flange.wrong[0]?.program ?? []);
  await expect(task.mark).toBeVisible();
  await expect(task.panel.getByRole("button", { name: words.comparePlan, exact: true })).toHaveCount(0);
  await write(flange.solution);
  await expect(task.status).toContainText(words.passedFor.alone);

  await task.panel.getByRole("button", { name: words.comparePlan, exact: true }).first().press("Enter");
  const dialog = page.getByRole("dialog", { name: c.title });
  const rows = dialog.getByRole("list", { name: c.rows }).locator(":scope > li");
  await expect(rows).toHaveCount(5, PLANNED);
  // Facing with the roughing tool saves a change: tried in the whole program, whose goals are all met.
  await expect(rows.first()).toContainText(c.differs.tool);
  await expect(rows.first()).toContainText(c.tried.better.other);
  await expect(rows.first()).toContainText(c.tried.changes(4));
  await expect(dialog.getByRole("row", { name: c.facts.goals })).toContainText(c.met);
  await rows.first().getByText(c.why, { exact: true }).click();
  await expect(rows.first().getByRole("table")).toContainText("Q463");
  await expectFineInBothThemes(page, "two plans side by side");
  // The better way opens as a program of its own, no longer as the exercise.
  await rows.first().getByRole("button", { name: plan.result.open }).press("Enter");
  await expect(dialog).toBeHidden();
  await expect(task.panel).toBeHidden();
  await expect(editor.text).toContainText(/BEARING_FLANGE.*TOOL CALL 1(?!5)/s);
});

test.describe("on a phone", () => {
  test.use({ viewport: { width: 390, height: 664 }, hasTouch: true });

  test("the planner's plan as help, in German, is asked for and counted", async ({ page }) => {
    const turnwise = await Turnwise.open(page, { language: "de" });
    const { task } = turnwise;
    const { words } = task;
    const c = wordsOf("de", "plan-comparison");
    await page.goto("./#/course/two-plans/tasks");
    await turnwise.course.task(flange.words.de.title).tap();
    const button = task.panel.getByRole("button", { name: words.showPlan, exact: true });
    await button.tap();
    await task.panel.getByRole("button", { name: words.cancelShow, exact: true }).tap();
    await button.tap();
    await task.panel.getByRole("button", { name: words.confirmShow, exact: true }).tap();
    const dialog = page.getByRole("dialog", { name: c.title });
    await expect(dialog.getByText(c.noProgram)).toBeVisible(PLANNED);
    await expect(dialog.getByText(c.onlyPlanner).first()).toBeVisible();
    await expectFineInBothThemes(page, "the planner's plan on a phone");
    await page.keyboard.press("Escape");
    // Once shown, it opens without the question.
    await button.tap();
    await expect(dialog).toBeVisible();
  });
});
