import { readFile } from "node:fs/promises";
import type { Locator, Page } from "@playwright/test";
import { device as t } from "../src/i18n/en/device.ts";
import { guide } from "../src/i18n/en/guide.ts";
import { expectAccessible, expectFineAtSizes } from "./pages/layout-checks.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

const button = (within: Page | Locator, name: string) => within.getByRole("button", { name, exact: true });

/** Name and bytes of the file that a click downloads. */
async function downloaded(page: Page, press: () => Promise<void>) {
  const [download] = await Promise.all([page.waitForEvent("download"), press()]);
  return {
    name: download.suggestedFilename(),
    mimeType: "application/zip",
    buffer: await readFile(await download.path()),
  };
}

/** Saves a cycle and a program. */
async function twoWorks(page: Page): Promise<Turnwise> {
  const turnwise = await Turnwise.open(page);
  await turnwise.start.beginWithExample(812);
  await turnwise.dialog.set("Q493", "51.25");
  await button(page, turnwise.t.page.settings).waitFor();
  await page.getByRole("link", { name: turnwise.t.page.home }).click();
  await page.getByRole("button", { name: turnwise.t.page.programs.example(turnwise.t.page.examples.shoulder) }).click();
  await expect(page.locator(".cm-content")).toBeVisible();
  await page.getByRole("link", { name: turnwise.t.page.home }).click();
  await expect(page.getByRole("link", { name: turnwise.t.page.start.allWorks(2) })).toBeVisible();
  return turnwise;
}

test("all works by keyboard: searched, renamed, duplicated, deleted and restored, at every size", async ({ page }) => {
  const turnwise = await twoWorks(page);
  await page.getByRole("link", { name: turnwise.t.page.start.allWorks(2) }).press("Enter");
  const search = page.getByRole("searchbox", { name: t.works.search });
  const rows = page.getByRole("list", { name: t.works.list }).getByRole("listitem");
  await expect(rows).toHaveCount(2);
  await expect(search).toBeFocused();
  await page.keyboard.type("812");
  await expect(rows).toHaveCount(1);
  await page.keyboard.press("ArrowDown");
  await expect(rows.getByRole("button").first()).toBeFocused();
  await page.keyboard.press("F2");
  await page.keyboard.press("Control+a");
  await page.keyboard.type("WELLE 9");
  await page.keyboard.press("Enter");
  await expect(button(page, t.works.open("WELLE 9"))).toBeFocused();
  await search.fill("");
  await expect(button(page, t.works.open("WELLE 9"))).toBeVisible();
  await button(page, t.works.duplicate("WELLE 9")).press("Enter");
  await expect(button(page, t.works.open("WELLE 9_2"))).toBeFocused();
  await page.getByRole("checkbox", { name: t.works.selectAll }).check();
  await button(page, t.works.removeSelected).click();
  await expect(rows).toHaveCount(0);
  await page.keyboard.press("Control+z");
  await expect(rows).toHaveCount(3);
  await expect(page.getByText(t.works.removed(3, ""))).toHaveCount(0);
  await button(page, t.works.open("WELLE 9_2")).focus();
  await page.keyboard.press("Delete");
  await expect(rows).toHaveCount(2);
  await expect(rows.getByRole("button", { name: /^Open/ }).and(page.locator(":focus"))).toHaveCount(1);
  await expectFineAtSizes(page, "all works", [
    [1280, 800],
    [768, 1024],
    [390, 844],
  ]);
  await page.reload();
  await expect(rows).toHaveCount(2);
  await button(page, t.works.open("WELLE 9")).press("Enter");
  await expect(turnwise.dialog.line("Q493")).toContainText("51.25");
  await page.goBack();
  await expect(rows).toHaveCount(2);
});

test("a backup restores on another device and overwrites nothing there", async ({ page, browser }) => {
  const turnwise = await twoWorks(page);
  await turnwise.settings.open();
  // The stored works are counted in the background: the button must not move meanwhile.
  const close = button(turnwise.settings.dialog, turnwise.t.page.close);
  const before = await close.boundingBox();
  await expect(turnwise.settings.saveAll).toBeVisible();
  expect(await close.boundingBox()).toEqual(before);
  await turnwise.settings.dialog.getByRole("combobox", { name: turnwise.t.page.theme }).selectOption("dark");
  const file = await downloaded(page, () => button(page, t.here.exportLong).click());
  expect(file.name).toMatch(/^turnwise-\d{4}-\d\d-\d\d\.zip$/);
  await expect(page.getByText(t.here.exported(2, 1))).toBeVisible();
  await button(page, turnwise.t.page.close).click();

  const other = await browser.newContext();
  const elsewhere = await Turnwise.open(await other.newPage());
  const dialog = elsewhere.page.getByRole("dialog", { name: t.restore.title(file.name) });
  const bring = async () => {
    await elsewhere.settings.open();
    const [chooser] = await Promise.all([
      elsewhere.page.waitForEvent("filechooser"),
      button(elsewhere.page, t.here.importLong).click(),
    ]);
    await chooser.setFiles(file);
    await expect(dialog).toBeVisible();
  };
  await bring();
  await expect(dialog.getByText(t.restore.states.fresh, { exact: true })).toHaveCount(2);
  await expect(dialog.getByText(t.restore.sameTable)).toBeVisible();
  await expectAccessible(elsewhere.page);
  await dialog.getByRole("checkbox", { name: t.restore.settings }).check();
  await button(elsewhere.page, t.restore.take).click();
  await expect(dialog.getByText(t.restore.done(2))).toBeVisible();
  await expect(elsewhere.page.locator("html")).toHaveAttribute("data-theme", "dark");
  await button(elsewhere.page, t.restore.showAll).click();
  await elsewhere.page.getByRole("button", { name: /^Open .*812/ }).click();
  await expect(elsewhere.dialog.line("Q493")).toContainText("51.25");
  await elsewhere.dialog.set("Q493", "49.5");
  await bring();
  await expect(dialog.getByText(t.restore.states.same, { exact: true })).toHaveCount(1);
  await expect(dialog.getByText(t.restore.states.beside, { exact: true })).toHaveCount(1);
  await button(elsewhere.page, t.restore.take).click();
  await button(elsewhere.page, t.restore.showAll).click();
  await expect(elsewhere.page.getByText(t.works.count(3))).toBeVisible();
  await elsewhere.page.goBack();
  await expect(elsewhere.dialog.line("Q493")).toContainText("49.5");

  // A backup also opens like a program file; a truncated one says so.
  await elsewhere.page.getByRole("link", { name: elsewhere.t.page.home }).click();
  const cut = { ...file, buffer: file.buffer.subarray(0, file.buffer.length - 30) };
  await elsewhere.page.locator("input[type=file]:not([webkitdirectory])").setInputFiles(cut);
  await expect(dialog.getByText(t.restore.problems.damaged(file.name))).toBeVisible();
  await other.close();
});

test("a full disk and refused storage are reported, editing continues, and unsaved works can be exported", async ({
  page,
  browser,
}) => {
  await page.addInitScript(() => {
    const full = () => {
      throw new DOMException("no room", "QuotaExceededError");
    };
    IDBObjectStore.prototype.put = full;
    Storage.prototype.setItem = full;
  });
  const turnwise = await Turnwise.open(page);
  await turnwise.start.beginWithExample(812);
  await turnwise.dialog.set("Q493", "51.25");
  const { notice } = turnwise.t.page;
  await expect(page.getByText(notice.storageFull)).toBeVisible();
  await turnwise.tools.open();
  await turnwise.tools.add.click();
  await expect(page.getByText(notice.toolsNotKept)).toBeVisible();
  await page.goBack();
  await expect(turnwise.dialog.line("Q493")).toContainText("51.25");
  const file = await downloaded(page, () => button(page, notice.archiveUnkept).click());

  const other = await browser.newContext();
  const elsewhere = await Turnwise.open(await other.newPage());
  await elsewhere.page.locator("input[type=file]:not([webkitdirectory])").setInputFiles(file);
  await button(elsewhere.page, t.restore.take).click();
  await button(elsewhere.page, t.restore.showAll).click();
  await elsewhere.page.getByRole("button", { name: /^Open .*812/ }).click();
  await expect(elsewhere.dialog.line("Q493")).toContainText("51.25");
  await other.close();

  await page.addInitScript(() => {
    const refuse = () => {
      throw new DOMException("refused", "SecurityError");
    };
    Object.defineProperty(window, "indexedDB", { get: refuse });
    Object.defineProperty(window, "localStorage", { get: refuse });
    Object.defineProperty(window, "sessionStorage", { get: refuse });
  });
  const without = await Turnwise.open(page);
  await without.start.beginWithExample(812);
  await expect(page.getByText(notice.notKept)).toBeVisible();
  await without.dialog.set("Q493", "52.5");
  await expect(without.dialog.line("Q493")).toContainText("52.5");
});

test("an error of the page keeps the work, offers an export, and stores a local report", async ({ page, context }) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.route(/assets\/GuidePage-.*\.js/, (route) =>
    route.fulfill({
      contentType: "text/javascript",
      body: 'export const GuidePage = () => { throw new Error("planted fault"); };',
    }),
  );
  const turnwise = await Turnwise.open(page);
  await turnwise.start.beginWithExample(812);
  await turnwise.dialog.set("Q493", "51.25");
  await page.getByRole("button", { name: guide.moreAbout("Q") }).click();
  const crash = page.getByRole("main");
  await expect(page.getByRole("alert")).toContainText(turnwise.t.page.notice.crash);
  const text = crash.getByRole("textbox", { name: t.reports.text });
  await expect(text).toHaveValue(/planted fault/);
  await expect(text).not.toHaveValue(/BEGIN PGM/);
  await expectAccessible(page);
  await crash.getByRole("checkbox", { name: t.reports.withProgram }).check();
  await button(page, t.reports.copy).click();
  await expect.poll(() => page.evaluate(() => navigator.clipboard.readText())).toMatch(/planted fault[^]*BEGIN PGM/);
  expect((await downloaded(page, () => button(page, t.reports.work).click())).buffer.toString()).toContain("BEGIN PGM");
  expect((await downloaded(page, () => button(page, t.here.exportLong).click())).name).toMatch(/^turnwise-.*\.zip$/);
  await button(page, turnwise.t.page.notice.startOver).click();
  await page.getByRole("link", { name: turnwise.t.page.start.allWorks(1) }).waitFor();
  await turnwise.settings.open();
  await turnwise.settings.dialog.getByText(`${t.reports.title} (1)`).click();
  await expect(turnwise.settings.dialog.getByRole("textbox", { name: t.reports.text })).toHaveValue(/planted fault/);
  await button(page, t.reports.remove).click();
  await expect(turnwise.settings.dialog.getByText(`${t.reports.title} (1)`)).toHaveCount(0);
});
