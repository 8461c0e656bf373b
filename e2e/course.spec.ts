import { dragFinger } from "./pages/finger.ts";
import { expectAccessible, expectFineInBothThemes } from "./pages/layout-checks.ts";
import { settledBox } from "./pages/picture.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

test.use({ reducedMotion: "no-preference" });

test("the course by keyboard: a lesson to its end, a slider moved, example and task opened, all resumed", async ({
  page,
}) => {
  const turnwise = await Turnwise.open(page, { heldClock: true });
  const { course, t } = turnwise;
  const { words } = course;
  await course.entrance.press("Enter");
  await expect(course.lessons).toBeVisible();
  await expect(page).toHaveTitle(`${words.title} · Turnwise`);
  await expectFineInBothThemes(page, "the list of lessons");

  // The other path has six lessons, and starts at its own first one.
  await course.path("Three parts in an hour").check();
  await expect(course.lessons.getByRole("heading", { level: 2 })).toHaveCount(6);
  await expect(page.getByRole("link", { name: words.begin("3"), exact: true })).toBeVisible();
  await course.path(course.pathWords.whole.title).check();
  await course.lesson(1).press("Enter");
  await expect(course.picture).toBeVisible();
  await expect(page).toHaveTitle(/^Lesson 1, .+ · Turnwise$/);
  const count = (await course.pages.getByRole("link").count()) - 1;
  expect(count).toBeGreaterThan(2);
  await expect(course.previous).toHaveCount(0);
  await course.answer("6 mm").press("Enter");
  await expect(course.reason).toContainText(words.question.wrong);
  await course.answer("3 mm").press("Enter");
  await expect(course.reason).toContainText(words.question.right);
  await expect(course.answer("3 mm")).toBeFocused();
  await expectFineInBothThemes(page, "a page with an answered question");
  const said = new Set<string>();
  for (let at = 1; at <= count; at++) {
    await expect(course.page(at)).toHaveAttribute("aria-current", "page");
    await expect(course.text(at, count)).not.toBeEmpty();
    said.add(await course.text(at, count).innerText());
    await page.keyboard.press("ArrowRight");
  }
  expect(said.size).toBe(count);
  await expect(course.page("tasks")).toHaveAttribute("aria-current", "page");
  await expectFineInBothThemes(page, "the tasks of a lesson");
  // Two presses, or two clicks at the place of one link, do not skip the tasks.
  await page.keyboard.press("ArrowLeft");
  await course.toTasks.press("Enter");
  await page.keyboard.press("Enter");
  await expect(page.getByRole("heading", { name: words.tasks, exact: true })).toBeFocused();
  await page.keyboard.press("ArrowLeft");
  await course.toTasks.dblclick();
  await expect(course.page("tasks")).toHaveAttribute("aria-current", "page");
  await page.keyboard.press("ArrowLeft");
  await expect(course.page(count)).toHaveAttribute("aria-current", "page");
  await page.goBack();
  await expect(course.page("tasks")).toHaveAttribute("aria-current", "page");
  await page.goForward();
  await expect(course.page(count)).toHaveAttribute("aria-current", "page");

  await page.goto("./#/course/axes/4");
  await course.block("11 L Z-25 F0.2").press("Enter");
  await expect(course.reason).toContainText(words.question.right);
  await page.goto("./#/course/first-shoulder/3");
  const passesOfQuestion = course.question.getByRole("textbox");
  await passesOfQuestion.fill("5");
  await passesOfQuestion.press("Enter");
  await expect(course.reason).toContainText(words.question.wrong);
  await passesOfQuestion.fill("6");
  await passesOfQuestion.press("Enter");
  await expect(course.reason).toContainText(words.question.shown);
  await expect(course.fact(t.page.effect.passes)).toHaveText("6");

  await page.goto(".?clock=manual#/course/first-shoulder/2");
  const passes = course.fact(t.page.effect.passes);
  const infeed = course.fact(t.page.effect.infeed);
  await expect(passes).toHaveText("4");
  await expect(infeed).toHaveText(/^2\.250/);
  const begun = Number(await course.moment.inputValue());
  await turnwise.lathe.advance(2000);
  await expect.poll(async () => Number(await course.moment.inputValue())).toBeGreaterThan(begun);
  await course.pause.press("Enter");
  await expect(course.play).toBeVisible();
  await page.getByText(words.picture.program, { exact: true }).press("Enter");
  await expect(course.runningBlock).toHaveText(/^9 CYCL CALL\s*$/);
  await page.getByText(words.picture.program, { exact: true }).press("Enter");
  const slide = course.slide("Q463");
  await slide.focus();
  for (let step = 0; step < 5; step++) await page.keyboard.press("ArrowRight");
  await expect(slide).toHaveAttribute("aria-valuetext", /^3 /);
  await expect(passes).toHaveText("3");
  await expect(infeed).toHaveText(/^3\.000/);
  await expect(course.page(2)).toHaveAttribute("aria-current", "page");
  await expectFineInBothThemes(page, "a page of a lesson");
  await page.reload();
  await expect(course.page(2)).toHaveAttribute("aria-current", "page");
  await expect(passes).toHaveText("4");

  await course.page("tasks").press("Enter");
  await course.example.press("Enter");
  await expect(turnwise.editor.total(t.editor.operations)).toHaveText(/\d/);
  await page.goBack();
  await expect(course.page("tasks")).toHaveAttribute("aria-current", "page");
  const first = page.getByRole("main").getByRole("listitem").getByRole("button").first();
  await expect(first).toContainText(words.states.new);
  await first.press("Enter");
  await expect(page).toHaveURL(/#\/work\//);
  await page.goBack();
  await expect(course.page("tasks")).toHaveAttribute("aria-current", "page");

  await page.getByRole("link", { name: t.page.home }).click();
  await expect(course.entrance).toContainText(words.entrance.goOn("3"));
  await course.entrance.press("Enter");
  await page.getByRole("link", { name: words.toList, exact: true }).press("Enter");
  await page.getByRole("button", { name: words.restart, exact: true }).press("Enter");
  await expect(page.getByText(words.restarted)).toBeVisible();
  await expect(page.getByRole("link", { name: words.begin("1"), exact: true })).toBeVisible();
  await turnwise.undo();
  await expect(page.getByRole("link", { name: words.begin("1"), exact: true })).toHaveCount(0);
  await expect(page.getByRole("button", { name: words.restart, exact: true })).toBeVisible();
});

test.describe("on a phone", () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, reducedMotion: "reduce" });

  test("a lesson by finger, in German: paused until played, and a swipe across the text turns pages", async ({
    page,
  }) => {
    const turnwise = await Turnwise.open(page, { language: "de" });
    const { course, t } = turnwise;
    await course.entrance.tap();
    await course.lesson(3).tap();
    await expect(course.play).toBeVisible();
    await course.play.tap();
    await expect(course.pause).toBeVisible();
    const words = page.locator(".lesson-words"),
      shown = page.getByRole("main");
    const swipe = async (by: number) => {
      const box = await settledBox(words);
      const from = { x: box.x + box.width / 2 - by / 2, y: box.y + 40 };
      await dragFinger(page, from, { x: from.x + by, y: from.y + 4 });
    };
    await swipe(-180);
    await expect(course.page(2)).toHaveAttribute("aria-current", "page");
    await swipe(180);
    await expect(course.page(1)).toHaveAttribute("aria-current", "page");
    await course.next.tap();
    await expect(course.page(2)).toHaveAttribute("aria-current", "page");
    const slide = course.slide("Q463");
    await slide.scrollIntoViewIfNeeded();
    await slide.fill("9");
    await expect(course.fact(t.page.effect.passes)).toHaveText("1");
    await expectAccessible(page);
    expect(await shown.evaluate((main) => main.scrollWidth - main.clientWidth)).toBeLessThanOrEqual(0);
    const stage = await page.locator(".lesson-lathe").boundingBox();
    expect(stage && stage.y >= 0 && stage.y < 300).toBe(true);
  });
});
