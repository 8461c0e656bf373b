import threePasses from "../src/course/tasks/l03-equal-passes.json" with { type: "json" };
import { offline } from "../src/i18n/en/offline.ts";
import { expectFineInBothThemes } from "./pages/layout-checks.ts";
import { Site } from "./pages/site.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

const MINUTE = 60_000;

test("an exam of two exercises: made, written without a network until time is up, and collected", async ({
  page,
  browser,
}) => {
  const title = "Week 12",
    first = "Exactly three passes",
    second = "What will be measured?";
  const site = await Site.start();
  // The learner was here before, and works without a network: the page is stored on the device meanwhile.
  const context = await browser.newContext({ serviceWorkers: "allow" });
  const pupil = await context.newPage();
  await pupil.goto(site.url);
  const learner = Turnwise.at(pupil);
  await page.goto(site.url);
  const instructor = Turnwise.at(page);
  const { teaching } = instructor;
  const words = teaching.setWords;
  await instructor.course.open();
  await teaching.newSet(title);
  for (const task of [first, second]) await teaching.addToSet(task);
  await teaching.makeExam(20);
  // Tasks of the course are only named in the link, in all languages: it fits a QR code.
  await expect(teaching.setForm.getByText(words.courseHasAnswers)).toBeVisible();
  await expect(teaching.setForm.getByRole("region", { name: "QR code" }).getByRole("img")).toBeVisible();
  const link = await teaching.link(teaching.setForm);
  expect(link.length).toBeLessThan(500);
  await expectFineInBothThemes(page, "the form of a set");

  await learner.settings.open();
  await expect(learner.settings.dialog.getByRole("status").filter({ hasText: offline.kept.kept })).toBeVisible();
  await pupil.keyboard.press("Escape");
  await context.setOffline(true);
  await pupil.goto("about:blank");
  const clock = "?clock=2026-11-23T08:00";
  await pupil.goto(`${site.url}${clock}${link.slice(link.indexOf("#"))}`);
  await learner.teaching.startExam(title, "Ada 7", "MT 2");
  await expect(learner.teaching.timeLeft).toHaveText("20:00");
  // The drawing stands beside the work, and the check says no more than the instructor chose.
  await expect(learner.task.drawing).toBeVisible();
  await learner.editor.text.focus();
  await pupil.keyboard.press("ControlOrMeta+a");
  await pupil.keyboard.insertText(`${threePasses.solution.join("\n")}\n`);
  await learner.calculated();
  await pupil.getByRole("button", { name: words.exam.checkLeft(3), exact: true }).click();
  await expect(learner.task.status).toHaveText(learner.task.states.passed);
  await learner.teaching.nextOfSet(second);
  await learner.task.field("answer").fill("1");
  await learner.lathe.advance(18 * MINUTE);
  await expect(learner.teaching.setBar.getByRole("status")).toHaveText(words.minutesLeft(5));
  // When time is up, the programs and answers of that moment count.
  await learner.lathe.advance(2 * MINUTE);
  await expect(learner.task.status).toHaveText(words.exam.over);
  await learner.teaching.setBar.getByRole("button", { name: words.handIn, exact: true }).click();
  const answer = await learner.teaching.link(learner.teaching.handIn);
  await context.close();

  await page.goto("about:blank");
  await page.goto(answer);
  const results = teaching.results("Ada 7");
  await expect(results.getByRole("row", { name: new RegExp(first) })).toContainText(teaching.words.results.againPasses);
  site.stop();
});
