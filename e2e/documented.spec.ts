/*
 * The examples of docs/automation.md, as they are printed there: tests/page-objects.test.ts compares them.
 */
import { Turnwise } from "./pages/index.ts";
import { expect, test } from "./pages/test.ts";

test.use({ reducedMotion: "no-preference" });

// example: a shoulder
test("a shoulder", async ({ page }) => {
  const turnwise = await Turnwise.open(page, { language: "de", heldClock: "2026-11-21T08:00", seed: 7 });
  await turnwise.start.beginWithExample(812); // a card of the first screen
  await turnwise.dialog.set("Q463", "2,4"); // open the prompt, type, ENT
  await turnwise.show("setup"); // a tab
  await turnwise.setup.start("x").fill("80");
  await turnwise.calculated(); // the strip belongs to these values
  await expect(turnwise.effect.cell("passes")).toHaveText("7");
  await turnwise.lathe.button("play").click();
  await turnwise.lathe.advance(2000); // two seconds of animation, exactly
  await expect(turnwise.lathe.running).toContainText("2");
  const program = await turnwise.program.copy(); // text on the clipboard
  expect(program).toContain("Q463=+2.4 ");
});

// example: an exercise of the course
test("an exercise of the course", async ({ browser }) => {
  const turnwise = await Turnwise.open(browser, { viewport: { width: 1024, height: 768 }, touch: true });
  const { course, dialog, task } = turnwise;
  await course.open();
  await course.openLesson(3);
  await course.page("tasks").tap();
  await course.task("The first shoulder").tap();
  await task.fold.tap(); // from the assignment to the prompts
  const values = { Q493: "40", Q494: "-27.4", Q463: "2.5", Q478: "0.3", Q483: "0.5", Q484: "0.2", Q505: "0.15" };
  for (const [q, value] of Object.entries(values)) await dialog.set(q, value);
  await dialog.set("Q506", "0"); // a choice
  await turnwise.calculated();
  await task.check.tap();
  await expect(task.status).toContainText("not met"); // ⌀40 instead of ⌀48.2
  await task.draw.tap(); // the drawing in place of the lathe
  await task.size("27.4").tap(); // marks what makes it
  await expect(dialog.value).toHaveAccessibleName(/^Q494/);
  await dialog.set("Q493", "48.2");
  await turnwise.calculated();
  await task.check.tap();
  await expect(task.status).toContainText(task.states.passedFor.alone);
  await expect(task.next).toBeVisible();
  await turnwise.page.context().close();
});
// end
