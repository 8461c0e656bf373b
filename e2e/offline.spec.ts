import type { Page } from "@playwright/test";
import { provedIn } from "./pages/effect.ts";
import { newerVersion, Site } from "./pages/site.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";
import { offline as en } from "../src/i18n/en/offline.ts";

/** Only these tests use a service worker. */
test.use({ serviceWorkers: "allow" });

let site: Site;
const faults: string[] = [];
test.beforeEach(async ({ context }) => {
  site = await Site.start();
  faults.length = 0;
  context.on("weberror", (error) => faults.push(error.error().message));
});
test.afterEach(() => {
  site.stop();
  expect(faults).toEqual([]);
});

async function openPage(page: Page): Promise<Turnwise> {
  await page.goto(site.url);
  return Turnwise.at(page);
}

/** Waits until the settings report that the whole page is stored. */
async function kept(turnwise: Turnwise): Promise<void> {
  await turnwise.settings.open();
  await expect(turnwise.settings.dialog.getByRole("status").filter({ hasText: en.kept.kept })).toBeVisible();
  await turnwise.page.keyboard.press("Escape");
}

/** The script that a page was started from. */
const version = (page: Page) => page.locator("script[type=module][src]").getAttribute("src");

test("in flight mode: home screen, example, edit, check, copy, languages, tools, Back, and a killed worker", async ({
  page,
  context,
}) => {
  const first = await openPage(page);
  const { url } = site;
  await kept(first);
  const manifest = await page.evaluate(async () => {
    const link = document.querySelector<HTMLLinkElement>("link[rel=manifest]")?.href ?? "";
    const { start_url } = (await (await fetch(link)).json()) as { readonly start_url: string };
    return new URL(start_url, link).href;
  });
  expect(manifest).toBe(url);
  await page.close();
  site.stop();
  await context.setOffline(true);

  const screen = await context.newPage();
  await screen.goto(manifest);
  const turnwise = Turnwise.at(screen);
  await turnwise.start.beginWithExample(812);
  await turnwise.effect.proved();
  await turnwise.dialog.set("Q463", "2.4");
  await expect(turnwise.effect.cell("infeed")).toContainText("2.");
  await turnwise.effect.proved();
  const passes = await turnwise.effect.cell("passes").textContent();

  // The browser discards the idle calculation worker; the next value is still calculated.
  for (const worker of screen.workers()) await worker.evaluate(() => self.close());
  await turnwise.dialog.set("Q463", "1.1");
  await expect(turnwise.effect.cell("passes")).not.toHaveText(passes ?? "");
  await turnwise.effect.proved();
  expect(await turnwise.program.copy()).toContain("Q463=+1.1 ");

  await turnwise.tools.open();
  await expect(turnwise.tools.row(1)).toBeVisible();
  await screen.goBack();
  await turnwise.effect.proved();
  await screen.goBack();
  await turnwise.editor.openExample("flange");
  await expect(turnwise.editor.total(turnwise.t.findings.verdict.title)).toHaveText(provedIn(turnwise.t));
  for (const language of ["zh", "fr", "de"] as const) {
    await Turnwise.at(screen, language === "zh" ? "en" : language === "fr" ? "zh" : "fr").settings.chooseLanguage(
      language,
    );
    await expect(
      screen.getByText(Turnwise.at(screen, language).t.editor.sections.structure, { exact: true }),
    ).toBeVisible();
  }
  await screen.goto(`${url}gallery.html`);
  await expect(screen.getByRole("heading").first()).toBeVisible();
  await screen.goto(`${manifest}#/new`);
  await expect(screen.getByRole("dialog", { name: Turnwise.at(screen, "de").t.operations.newProgram })).toBeVisible();
});

test("a partial update changes nothing; a complete one is announced, waits for the button, and loses nothing", async ({
  page,
  context,
}) => {
  const turnwise = await openPage(page);
  await turnwise.start.beginWithExample(812);
  await turnwise.dialog.set("Q493", "51.5");
  await kept(turnwise);
  const old = await version(page);
  const other = await openPage(await context.newPage());
  const look = async () => {
    await turnwise.settings.open();
    await turnwise.settings.dialog.getByRole("button", { name: en.look, exact: true }).click();
  };
  const says = (text: string) => turnwise.settings.dialog.getByRole("status").filter({ hasText: text });

  // The connection breaks halfway; then a server returns an old page with a new list.
  const newer = newerVersion();
  site.serve(newer, (path) => /^assets\/[a-f]/i.test(path));
  await look();
  await expect(says(en.looked.unfinished)).toBeVisible();
  await page.keyboard.press("Escape");
  await page.reload();
  expect(await version(page)).toBe(old);
  await turnwise.effect.proved();
  await expect(turnwise.dialog.line("Q493")).toContainText("51.5");

  site.serve(newer);
  await look();
  const update = page.getByRole("button", { name: en.updateNow, exact: true });
  await expect(says(en.ready)).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(page.getByText(en.ready, { exact: true })).toBeVisible();
  await page.getByRole("button", { name: en.later, exact: true }).click();
  await expect(page.getByText(en.ready, { exact: true })).toBeHidden();
  await turnwise.dialog.set("Q494", "-41.25");
  expect(await version(page)).toBe(old);
  await turnwise.settings.open();
  await Promise.all([page.waitForEvent("load"), update.click()]);
  await expect(turnwise.dialog.line("Q494")).toContainText("-41.25");
  await expect(turnwise.dialog.line("Q493")).toContainText("51.5");
  expect(await version(page)).not.toBe(old);
  await turnwise.effect.proved();

  // The other tab keeps using its own parts, which no server has any more, until it is reloaded.
  await expect(other.page.getByText(en.elsewhere)).toBeVisible();
  expect(await version(other.page)).toBe(old);
  const keeps = () =>
    other.page.evaluate(
      async (name) => {
        const [cache = ""] = await caches.keys();
        return (await (await caches.open(cache)).keys()).some(({ url }) => url.endsWith(name));
      },
      old?.slice(1) ?? "",
    );
  expect(await keeps()).toBe(true);
  await other.tools.open();
  await expect(other.tools.row(1)).toBeVisible();
  await Promise.all([
    other.page.waitForEvent("load"),
    other.page.getByRole("button", { name: en.reload, exact: true }).click(),
  ]);
  await expect(other.tools.row(1)).toBeVisible();
  expect(await version(other.page)).not.toBe(old);
  await expect.poll(keeps).toBe(false);
});

test("a part that fails to load is reported, keeps the open work, and loads once the network is back", async ({
  browser,
}) => {
  const context = await browser.newContext({ serviceWorkers: "block" });
  context.on("weberror", (error) => faults.push(error.error().message));
  // Nothing is fetched before it is needed.
  await context.addInitScript(() => {
    window.requestIdleCallback = () => 0;
  });
  const page = await context.newPage();
  const turnwise = await openPage(page);
  const { t, start, dialog, tools } = turnwise;
  const { missing, tryAgain } = t.page.notice;
  await expect(start.button(812, true)).toBeEnabled();
  await context.setOffline(true);
  await page.getByRole("button", { name: t.page.programs.example(t.page.examples.flange), exact: true }).click();
  await expect(page.getByText(missing.offline)).toBeVisible();
  await page.getByRole("button", { name: t.page.tools.openLong }).click();
  await page.getByRole("button", { name: tryAgain, exact: true }).click();
  await expect(page.getByText(missing.offline)).toBeVisible();
  await context.setOffline(false);
  await expect(tools.row(1)).toBeVisible();
  await expect(page.getByText(missing.offline)).toBeHidden();
  // With its style sheet, which failed the first time as well.
  await expect(page.getByRole("table").first()).toHaveCSS("border-spacing", "0px");
  await tools.close();
  await start.beginWithExample(812);
  await turnwise.effect.proved();
  await dialog.set("Q463", "2.4");

  // The server has another version, without this part.
  site.serve(newerVersion());
  await page.getByRole("button", { name: t.page.settings, exact: true }).click();
  await expect(page.getByText(missing.gone)).toBeVisible();
  await Promise.all([
    page.waitForEvent("load"),
    page.getByRole("button", { name: t.page.notice.reload, exact: true }).click(),
  ]);
  await expect(dialog.line("Q463")).toContainText("2.4");
  await turnwise.settings.open();
  await expect(turnwise.settings.dialog).toBeVisible();
  await context.close();
});
