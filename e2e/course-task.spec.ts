import { readFileSync } from "node:fs";
import { expectAccessible, expectFineInBothThemes } from "./pages/layout-checks.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

interface TaskFile {
  readonly words: Readonly<
    Record<"en" | "de", { readonly title: string; readonly hints: readonly string[]; readonly learned: string }>
  >;
  readonly solution: readonly string[];
}
const taskFile = (id: string): TaskFile =>
  JSON.parse(readFileSync(new URL(`../src/course/tasks/${id}.json`, import.meta.url), "utf8"));

/** Opens the tasks of a lesson and starts one of them. */
async function begin(
  turnwise: Turnwise,
  lesson: string,
  title: string,
  press: "Enter" | "tap" = "Enter",
): Promise<void> {
  await turnwise.page.goto(`./#/course/${lesson}/tasks`);
  const button = turnwise.course.task(title);
  await (press === "tap" ? button.tap() : button.press("Enter"));
  await expect(turnwise.task.assignment).toBeVisible();
}

test("a task by keyboard: a wrong try names place and step; hints, solution, passed, resumed", async ({ page }) => {
  // What was made plays.
  await page.emulateMedia({ reducedMotion: "no-preference" });
  const turnwise = await Turnwise.open(page);
  const { task, dialog, lathe } = turnwise;
  const { words } = task;
  const { title, hints, learned } = taskFile("l03-first-shoulder").words.en;
  await begin(turnwise, "first-shoulder", title);
  await expect(task.goal("⌀ 48.2 ±0.03")).toBeVisible();
  await expectFineInBothThemes(page, "the assignment of a task");
  await task.fold.press("Enter");
  await task.check.press("Enter");
  await expect(task.status).toContainText("Q493");
  await task.panel.getByRole("button", { name: words.goTo("Q493") }).press("Enter");
  await expect(dialog.value).toBeFocused();

  // Enters the radius where the diameter belongs.
  const values: readonly (readonly [string, string])[] = [
    ["Q493", "24.1"],
    ["Q494", "-27.4"],
    ["Q463", "2.5"],
    ["Q478", "0.3"],
    ["Q483", "0.5"],
    ["Q484", "0.2"],
    ["Q505", "0.15"],
    ["Q506", "0"],
  ];
  for (const [q, value] of values) await dialog.set(q, value);
  await turnwise.effect.proved();
  await task.check.press("Enter");
  await expect(task.mark).toContainText(words.slip.radius(words.slip.half("Q493 End ⌀", "24.1", "48.2")));
  await expect(lathe.mark("1")).toBeVisible();
  await expectFineInBothThemes(page, "a task with a wrong try");
  await task.nextMark.press("Enter");
  await expect(task.mark).toHaveAccessibleName(
    /^2: Cut 12\.05 mm into the part at ⌀[\d.]+, Z-[\d.]+: block \d+, (pass \d+|finishing cut)/,
  );

  await task.unfold.press("Enter");
  await expect(task.goal("⌀ 48.2 ±0.03")).toContainText(words.notMet);
  for (const stage of [1, 2]) await task.hint(stage).press("Enter");
  await expect(task.panel).toContainText(hints[1] ?? "");
  await expect(task.panel).not.toContainText(hints[2] ?? "");
  await dialog.set("Q493", "48.2");
  await expect(task.goal("⌀ 48.2 ±0.03")).not.toContainText(words.notMet);
  await expect(task.status).toContainText(words.stale);
  await turnwise.effect.proved();
  await task.check.press("Enter");
  await expect(task.status).toContainText(words.passedFor.hints);
  // What was made plays, over the folded assignment, and can be skipped; the next step is one button.
  await expect(task.assignment).toBeHidden();
  await expect(task.panel).toContainText(learned);
  await expect(task.made).toHaveText(task.pathWords.made.skip);
  await task.made.press("Enter");
  await expect(task.made).toHaveText(task.pathWords.made.again);
  await expect(task.next).toHaveText(words.nextTask(taskFile("l03-how-many-passes").words.en.title));
  await expectFineInBothThemes(page, "a passed task");
  await task.unfold.press("Enter");
  await task.solution.press("Enter");
  await task.panel.getByRole("button", { name: words.confirmShow, exact: true }).press("Enter");
  await task.panel.getByRole("button", { name: words.compare, exact: true }).press("Enter");
  await expect(page.getByRole("dialog")).toBeVisible();
  await page.keyboard.press("Escape");

  await page.reload();
  await expect(task.status).toContainText(words.tries(2));
  await expect(dialog.line("Q493")).toContainText("48.2");
  await task.unfold.press("Enter");
  await task.toLesson.press("Enter");
  await expect(turnwise.course.task(title)).toContainText(turnwise.course.words.states.hints);
  await turnwise.course.task(title).press("Enter");
  await expect(dialog.line("Q493")).toContainText("48.2");

  // Passed with help, it is in the review; started over from there, its help is covered again.
  await page.goto("./#/course");
  const { review } = turnwise.course;
  await expect(review.getByText(turnwise.course.words.states.hints)).toBeVisible();
  await review.getByRole("button", { name: title }).press("Enter");
  await expect(task.hint(1)).toBeVisible();
  await expect(dialog.line("Q493")).not.toContainText("48.2");
});

test("predictions, a fault that is found and fixed, and a drawing with its score", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { task, editor, lathe } = turnwise;
  const { words } = task;
  const strip = page.locator(".effect");
  await begin(turnwise, "first-shoulder", taskFile("l03-how-many-passes").words.en.title);
  await expect(task.field("answer")).toBeInViewport();
  await task.fold.press("Enter");
  await expect(strip).toBeHidden();
  await task.field("answer").fill("19");
  await page.keyboard.press("Enter");
  await expect(task.field("answer")).toHaveValue("");
  await expect(task.field("answer")).toBeFocused();
  await page.keyboard.type("2,1");
  await expectFineInBothThemes(page, "a question of a task");
  await page.reload();
  await expect(task.field("answer")).toHaveValue("19");
  await task.nextQuestion.press("Enter");
  await expect(task.field("answer")).toHaveValue("2,1");
  await task.run.press("Enter");
  await expect(strip).toBeVisible();
  const said = task.panel.getByRole("listitem").first();
  await expect(said).toContainText("Your answer: 19 passes.");
  const [, passes = ""] = /Correct: (\d+) passes/.exec(await said.innerText()) ?? [];
  await expect(task.panel.getByRole("listitem").nth(1)).toContainText("Correct");
  // The right answers were shown: the same questions come back with other numbers.
  await task.again.press("Enter");
  await expect(strip).toBeHidden();
  await expect(task.panel).toContainText(words.predict.otherNumbers(["block 1", "block 8"]));
  await task.field("answer").fill(passes);
  await page.keyboard.press("Enter");
  await task.field("answer").fill("9");
  await page.keyboard.press("Enter");
  await expect(said).toContainText(`Your answer: ${passes} passes.`);
  await expect(task.status).toContainText(words.tries(2));

  const fault = taskFile("l20-start-inside");
  await begin(turnwise, "faults", fault.words.en.title);
  await task.fold.press("Enter");
  await editor.line("FUNCTION TURNDATA").click();
  await expect(task.field("block")).toHaveValue("4");
  await task.field("block").fill("11");
  await task.nextQuestion.press("Enter");
  await task.field("x").fill("70.6");
  await task.field("z").fill("-32.4");
  await expect(lathe.mark(String.raw`\?`)).toBeVisible();
  await task.run.press("Enter");
  await expect(task.panel.getByRole("listitem").first()).toContainText(
    words.predict.right(words.predict.isBlock("11")),
  );
  await task.check.press("Enter");
  await expect(task.mark).toContainText(/^\d?\s*Rapid traverse into material at ⌀[\d.]+, Z-[\d.]+: block 11/);
  await editor.text.press("ControlOrMeta+a");
  await page.keyboard.insertText(fault.solution.join("\n"));
  await task.check.press("Enter");
  await expect(task.status).toContainText(words.passedFor.alone);

  const pin = taskFile("l22-pin");
  await begin(turnwise, "from-a-drawing", pin.words.en.title);
  await expect(task.drawing).toBeVisible();
  await expectFineInBothThemes(page, "a task from a drawing");
  await editor.text.press("ControlOrMeta+a");
  await page.keyboard.insertText(pin.solution.join("\n"));
  await task.check.press("Enter");
  await expect(task.panel).toContainText(/\d+ of 100/);
  await task.unfold.press("Enter");
  await expect(task.panel.getByRole("region", { name: words.score.title, exact: true })).toContainText(/\d+ of 100/);
  await expect(task.status).toContainText(words.passedFor.alone);
});

test.describe("on a phone", () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true });

  test("a fault by finger, in German: tap its place on the part; nothing covers the picture", async ({ page }) => {
    const turnwise = await Turnwise.open(page, { language: "de" });
    const { task, lathe } = turnwise;
    const { words } = task;
    const { title } = taskFile("l20-start-inside").words.de;
    await begin(turnwise, "faults", title, "tap");
    await expect(task.field("block")).toBeInViewport();
    await task.fold.tap();
    await task.field("block").fill("11");
    await task.nextQuestion.tap();
    const stage = lathe.view.locator(".lathe-stage");
    await stage.tap({ position: { x: 250, y: 60 } });
    await expect(task.field("x")).toHaveValue(/^[\d,]+$/);
    await expect(task.field("z")).toHaveValue(/^-[\d,]+$/);
    await expectAccessible(page);
    await task.run.tap();
    await expect(task.panel.getByRole("listitem").nth(1)).toContainText("⌀");
    await task.check.tap();
    await expect(task.mark).toContainText("Satz 11");
    await expect
      .poll(async () => {
        const [bar, picture] = [await task.panel.boundingBox(), await stage.boundingBox()];
        return bar && picture && bar.y + bar.height <= picture.y;
      })
      .toBe(true);
    await task.unfold.tap();
    await expect(stage).toBeHidden();
    await task.hint(1).tap();
    await expectAccessible(page);
    await task.fold.tap();
    await expect(stage).toBeVisible();
    await expect(task.status).toContainText(words.failed(2, 4));
  });
});
