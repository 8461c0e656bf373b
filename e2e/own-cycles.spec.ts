import { tabTo } from "./pages/keyboard.ts";
import { expectAccessibleAndFits } from "./pages/layout-checks.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

const PROGRAM = `0 BEGIN PGM PULL MM
1 BLK FORM CYLINDER Z D80 L120 DIST+1
2 TOOL CALL 1
3 FUNCTION MODE TURN
4 L X+82 Z+2 R0 FMAX
5 CYCL DEF 317 BAR PULLER ~
    Q1711=+31.7   ;PULL LENGTH ~
    Q1712=+1 ;GRIP ~
    Q1713=+250 ;FEED RATE
6 CYCL CALL
7 M30
8 END PGM PULL MM
`;
const stored = "turnwise/own-cycles";

test("an unknown block is described, its dialog changes the text, and it is inserted again after a reload", async ({
  page,
}) => {
  const turnwise = await Turnwise.open(page);
  const { editor, dialog, own, t } = turnwise;
  await editor.openFile("PULL.H", Buffer.from(PROGRAM));
  await editor.line("CYCL DEF 317").click();
  await editor.show("block");
  await own.describe.click();
  await expect(own.number).toHaveValue("317");
  await expect(own.name).toHaveValue("BAR PULLER");
  await expect(own.kind("Q1711")).toHaveValue("length");
  await expect(own.kind("Q1711")).toBeFocused();
  await expect(own.kind("Q1713")).toHaveValue("feed");
  await own.cell("Q1711", "min").fill("0.5");
  await own.cell("Q1711", "max").fill("187.25");
  await own.kind("Q1712").selectOption("choice");
  await own.cell("Q1712", "choices").fill("0 open, 1 closed");
  await expect(own.text).toContainText("CYCL DEF 317 BAR PULLER ~");
  await expectAccessibleAndFits(page);
  await own.back.click();

  await expect(dialog.question).toHaveText("PULL LENGTH");
  await expect(page.getByText(t.editor.ownUnproved)).toBeVisible();
  await dialog.set("Q1711", "200");
  await expect(editor.line("Q1711")).toContainText("Q1711=+200   ;PULL LENGTH ~");
  await dialog.open("Q1711");
  await page.getByRole("button", { name: t.dialog.takeNearest("187.25") }).click();
  await dialog.open("Q1712");
  await page.keyboard.press("0");
  await expectAccessibleAndFits(page);
  const changed = PROGRAM.replace("+31.7", "+187.25").replace("Q1712=+1", "Q1712=+0");
  expect((await editor.downloaded()).toString()).toBe(changed);
  await expect(page.getByRole("region", { name: t.editor.total })).toContainText("CYCL DEF 317 BAR PULLER");

  await expect
    .poll(() => page.evaluate((key) => localStorage.getItem(key) ?? "", stored))
    .toContain("0 open, 1 closed");
  await page.reload();
  await editor.line("Q1713").click();
  await editor.show("block");
  await expect(dialog.question).toHaveText("FEED RATE");
  await editor.line("Q1712").getByText("Q1712", { exact: true }).hover();
  await expect(page.locator(".nc-help")).toContainText("1: closed");
  await editor.tool("insertLong").click();
  await page
    .getByRole("group", { name: t.editor.palette })
    .getByRole("button", { name: `CYCL DEF ${t.editor.kinds.cycle}`, exact: true })
    .click();
  await own.group.getByRole("button", { name: t.page.own.title }).click();
  await expect(own.group).toContainText(t.own.mark);
  await expectAccessibleAndFits(page);
  await own.group
    .getByRole("button", { name: `${t.page.start.cycle(317, "BAR PULLER")}: ${t.chooser.insert}` })
    .click();
  await expect(dialog.question).toHaveText("PULL LENGTH");
  const second =
    "6 CYCL DEF 317 BAR PULLER ~\n    Q1711=+31.7 ;PULL LENGTH ~\n    Q1712=+1 ;GRIP ~\n    Q1713=+250 ;FEED RATE\n";
  expect((await editor.downloaded()).toString()).toContain(second);
});

test("by keyboard alone: from the settings, a cycle is created, kept, deleted and restored", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { own, t } = turnwise;
  const { keyboard } = page;
  await tabTo(page, page.getByRole("button", { name: t.page.settings, exact: true }));
  await keyboard.press("Enter");
  await tabTo(page, page.getByRole("dialog").getByRole("button", { name: t.page.own.title, exact: true }));
  await keyboard.press("Enter");
  await expect(page.getByText(t.own.none)).toBeVisible();
  await expectAccessibleAndFits(page);
  await tabTo(page, own.add);
  await keyboard.press("Enter");
  await expect(own.number).toBeFocused();
  await keyboard.type("812");
  await expect(page.getByText(t.own.problems.known("812"))).toBeVisible();
  await expectAccessibleAndFits(page);
  await keyboard.press("ControlOrMeta+a");
  await keyboard.type("731");
  await keyboard.press("Enter");
  await keyboard.type("PART CATCHER");
  await keyboard.press("Enter");
  await keyboard.type("Q1801");
  await tabTo(page, own.cell("Q1801", "prompt"));
  await keyboard.type("WAY");
  await expect(own.text).toContainText("Q1801=+0 ;WAY");
  await expect.poll(() => page.evaluate((key) => localStorage.getItem(key) ?? "", stored)).toContain("WAY");
  await tabTo(page, own.remove(731, "PART CATCHER"), "Shift+Tab");
  await keyboard.press("Enter");
  await expect(own.row(731, "PART CATCHER")).toHaveCount(0);
  await keyboard.press("ControlOrMeta+z");
  await expect(own.row(731, "PART CATCHER")).toBeVisible();
  await tabTo(page, own.back, "Shift+Tab");
  await keyboard.press("Enter");
  await expect(turnwise.start.search).toBeVisible();
});
