import type { Page } from "@playwright/test";
import { device as deviceTexts } from "../src/i18n/en/device.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

test("a reload in the middle of typing loses nothing", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { dialog } = turnwise;
  await turnwise.start.beginWithExample(852);
  await dialog.open("Q494");
  await dialog.type("-41.25");
  await expect(dialog.line("Q494")).toContainText("-41.25");
  await page.reload();
  await expect(dialog.line("Q494")).toContainText("-41.25");
});

test("one work in two tabs: one tab has it; it can be taken over with the last key, given back, or copied", async ({
  page,
  context,
}) => {
  const t = deviceTexts.elsewhere;
  const first = await Turnwise.open(page);
  await first.start.beginWithExample(812);
  await first.dialog.set("Q493", "51");
  const second = Turnwise.at(await context.newPage());
  await second.page.goto("./");
  const button = (turnwise: Turnwise, name: string) => turnwise.page.getByRole("button", { name, exact: true });
  await expect(second.page.getByRole("heading", { name: /open in another tab/ })).toBeVisible();

  await first.dialog.open("Q494");
  await first.dialog.type("-44.25");
  await button(second, t.take).click();
  await expect(second.dialog.line("Q494")).toContainText("-44.25");
  await expect(second.dialog.line("Q493")).toContainText("51");
  await second.dialog.set("Q493", "52.5");
  await expect(first.page.getByRole("heading", { name: /is now edited in another tab/ })).toBeVisible();

  await button(first, t.editAgain).click();
  await expect(first.dialog.line("Q493")).toContainText("52.5");
  await expect(first.dialog.line("Q494")).toContainText("-44.25");
  await button(second, t.copy).click();
  await second.dialog.set("Q493", "53.5");
  await first.dialog.set("Q494", "-45");
  await page.reload();
  await expect(first.dialog.line("Q494")).toContainText("-45");
  await expect(first.dialog.line("Q493")).toContainText("52.5");
  await second.page.reload();
  await expect(second.dialog.line("Q493")).toContainText("53.5");
  await expect(second.dialog.line("Q494")).toContainText("-44.25");

  const address = page.url();
  await page.close();
  await second.page.goto(address);
  await expect(second.dialog.line("Q494")).toContainText("-45");
});

test("a damaged save is set aside with a message, and the page opens", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  await turnwise.start.beginWithExample(812);
  await expect(turnwise.dialog.line("Q493")).toBeVisible();
  await expect.poll(() => damageSaves(page)).toBeGreaterThan(0);
  await page.reload();
  await expect(page.getByText(turnwise.t.page.notice.damaged(1))).toBeVisible();
  await expect(turnwise.start.button(812, true)).toBeVisible();
});

/**
 * Breaks every save on the device, as soon as the open work is stored with its list entry; returns their number, 0
 * before.
 */
function damageSaves(page: Page): Promise<number> {
  return page.evaluate(async () => {
    let count = 0;
    const open = (name: string) =>
      new Promise<IDBDatabase>((resolve, reject) => {
        const opening = indexedDB.open(name);
        opening.onsuccess = () => resolve(opening.result);
        opening.onerror = () => reject(opening.error);
      });
    const keysOf = (store: IDBObjectStore) =>
      new Promise<IDBValidKey[]>((resolve) => {
        const asking = store.getAllKeys();
        asking.onsuccess = () => resolve(asking.result);
      });
    const all = (await indexedDB.databases()).flatMap(({ name }) => name ?? []);
    if (!all.includes("turnwise-heads")) return 0;
    const heads = await open("turnwise-heads");
    const isWritten = (await keysOf(heads.transaction("heads").objectStore("heads"))).length > 0;
    heads.close();
    if (!isWritten) return 0;
    for (const name of all) {
      const db = await open(name);
      for (const storeName of db.objectStoreNames) {
        const store = db.transaction(storeName, "readwrite").objectStore(storeName);
        for (const key of await keysOf(store)) {
          store.put({ broken: true }, key);
          count += 1;
        }
      }
      db.close();
    }
    return count;
  });
}
