import { readFile } from "node:fs/promises";
import type { Locator } from "@playwright/test";
import { courseTask } from "../src/i18n/en/course-task.ts";
import { expectFineInBothThemes } from "./pages/layout-checks.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

/** Name and text of the file that a button downloads. */
async function downloaded(button: Locator): Promise<readonly [string, string]> {
  const waiting = button.page().waitForEvent("download");
  await button.click();
  const file = await waiting;
  return [file.suggestedFilename(), (await readFile(await file.path())).toString()];
}

test("a task from an instructor to a learner by link, and its result back", async ({ page, browser }) => {
  const title = "Shoulder, ⌀ 50";
  const solution = await readFile("src/examples/shoulder.h", "utf8");
  const instructor = await Turnwise.open(page, { heldClock: true });
  const { words } = instructor.teaching;
  const form = instructor.teaching.form;
  await instructor.editor.openExample("shoulder");
  await instructor.teaching.openForm();

  // Missing fields are named; part and rules are filled in already.
  await expect(instructor.teaching.check).toContainText(words.needs.title);
  await expect(form.getByRole("checkbox", { name: words.rule.depth, exact: true })).toBeChecked();
  await instructor.teaching.fillTexts(title, "Turn the shoulder of the drawing.");
  await expect(instructor.teaching.check).toHaveText(words.passes);
  const size = form.getByRole("group", { name: words.sizes, exact: true }).getByRole("checkbox").first();
  await size.check();
  await expect(form.getByRole("img")).toHaveCount(2);
  await expectFineInBothThemes(page, "the form of a task");

  // An answer that breaks a rule blocks sharing.
  const depth = form.getByRole("textbox", { name: words.rule.depth, exact: true }),
    was = await depth.inputValue();
  await depth.fill("0.3");
  await expect(instructor.teaching.check).toContainText(words.refused);
  await expect(form.getByRole("button", { name: words.tryIt, exact: true })).toBeDisabled();
  await depth.fill(was);
  await expect(instructor.teaching.check).toHaveText(words.passes);
  // The start program must not pass unchanged.
  await form.getByRole("radio", { name: words.starts.program, exact: true }).check();
  await expect(instructor.teaching.check).toContainText(words.idle);
  await form.getByRole("checkbox", { name: words.fault.minus, exact: true }).check();
  await expect(instructor.teaching.check).toHaveText(words.passes);
  const link = await instructor.teaching.link(form);
  const [file, text] = await downloaded(form.getByRole("button", { name: words.saveTask, exact: true }));
  expect(file).toMatch(/^shoulder-50-\w+\.turnwise-task\.json$/);
  expect(JSON.parse(text)).toMatchObject({
    format: "turnwise-task/1",
    words: { en: { title } },
    sizes: [{ upper: 0.05, lower: -0.05 }],
  });
  // Closing the form, or leaving the page, loses nothing.
  await page.keyboard.press("Escape");
  await expect(form).toBeHidden();
  await page.reload();
  await instructor.teaching.openForm();
  await expect(form.getByLabel(words.name, { exact: true })).toHaveValue(title);
  await page.keyboard.press("Escape");

  // The learner: the link shows its contents before anything is stored.
  const context = await browser.newContext();
  const learner = await Turnwise.open(await context.newPage());
  const other = learner.page;
  await other.goto("about:blank");
  await other.goto(`${link.slice(0, link.indexOf("#"))}${link.slice(link.indexOf("#"), -20)}`);
  await expect(other.getByRole("dialog", { name: words.problem.link, exact: true })).toContainText(
    words.problem.damaged,
  );
  await other.goto("about:blank");
  await other.goto(link);
  const incoming = learner.teaching.incoming(title);
  await expect(incoming).toContainText("Turn the shoulder of the drawing.");
  await expectFineInBothThemes(other, "a task from outside");
  await incoming.getByRole("button", { name: words.incoming.take, exact: true }).click();
  const panel = other.getByRole("region", { name: courseTask.region(title), exact: true });
  await expect(panel).toBeVisible();
  await expect(learner.editor.text).toBeVisible();
  await panel.getByRole("button", { name: courseTask.check, exact: true }).click();
  await expect(panel).toContainText(courseTask.noRun);
  await learner.editor.text.focus();
  await other.keyboard.press("ControlOrMeta+a");
  await other.keyboard.insertText(solution);
  await expect(async () => {
    await panel.getByRole("button", { name: courseTask.check, exact: true }).click();
    await expect(panel).toContainText(courseTask.passedFor.alone, { timeout: 2000 });
  }).toPass();

  // It is listed below the course, as passed, and is handed in.
  await other.getByRole("link", { name: learner.t.page.home }).click();
  await learner.course.open();
  await expect(learner.teaching.kept).toContainText(learner.course.words.states.alone);
  await expectFineInBothThemes(other, "the course with a task from outside");
  await learner.teaching.kept.getByRole("button", { name: words.hand.open, exact: true }).click();
  const { handIn } = learner.teaching;
  await handIn.getByLabel(words.hand.name, { exact: true }).fill("Ada 7");
  await expect(handIn.getByRole("checkbox", { name: title, exact: true })).toBeChecked();
  const [resultFile, handed] = await downloaded(handIn.getByRole("button", { name: words.hand.save, exact: true }));
  expect(resultFile).toBe("Ada-7.turnwise-result.json");
  const {
    name,
    tasks: [first],
  } = JSON.parse(handed) as { name: string; tasks: { program: string; steps: number; worked: number }[] };
  expect([name, first?.program]).toEqual(["Ada 7", solution]);
  expect(first?.steps).toBeGreaterThan(0);
  await expectFineInBothThemes(other, "results that are handed in");
  const answer = await learner.teaching.link(handIn);
  await context.close();

  // The instructor reads it, from the file and from the link.
  await instructor.editor.drop({ [resultFile]: handed });
  const results = instructor.teaching.results("Ada 7");
  const row = results.getByRole("row", { name: new RegExp(`^${title}`) });
  await expect(row).toContainText(words.results.states.alone);
  await expect(row.getByRole("cell", { name: words.results.againPasses, exact: true })).toBeVisible();
  await expectFineInBothThemes(page, "results that were handed in");
  await page.keyboard.press("Escape");
  await page.goto("about:blank");
  await page.goto(answer);
  await row.getByRole("button", { name: words.results.open(title), exact: true }).click();
  await expect(instructor.editor.text).toContainText("BEGIN PGM");
  await expect(results).toBeHidden();
});
