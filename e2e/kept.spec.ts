import type { Page } from "@playwright/test";
import { zipSync, strToU8 } from "fflate";
import { device as t } from "../src/i18n/en/device.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

const button = (page: Page, name: string | RegExp) => page.getByRole("button", { name, exact: true });
const opener = (page: Page) => page.locator("input[type=file]:not([webkitdirectory])").first();
const textFile = (name: string, text: string) => ({ name, mimeType: "text/plain", buffer: Buffer.from(text) });
const archive = (manifest: object) => ({
  name: "other.zip",
  mimeType: "application/zip",
  buffer: Buffer.from(zipSync({ "turnwise.json": strToU8(JSON.stringify(manifest)) })),
});

test("a work that was open when the page died is offered with its last key, and opens on request only", async ({
  page,
  context,
}) => {
  const turnwise = await Turnwise.open(page);
  await turnwise.editor.openFile("DIES.H", strToU8("0 BEGIN PGM DIES MM\n1 END PGM DIES MM\n"));
  await turnwise.editor.line("BEGIN PGM").click();
  await page.keyboard.press("End");
  const address = page.url();
  // The renderer ends in the task after the key, as it does when it is killed.
  const crash = await context.newCDPSession(page);
  await page.keyboard.type(" ;41.7");
  const died = page.waitForEvent("crash");
  void crash.send("Page.crash").catch(() => undefined);
  await died;
  await page.close();

  const next = Turnwise.at(await context.newPage());
  await next.page.goto(address);
  await expect(next.page.getByRole("heading", { name: t.died.title("DIES.H") })).toBeVisible();
  await expect(next.page.getByRole("textbox", { name: t.died.text })).toHaveValue(/BEGIN PGM DIES MM ;41\.7\n/);
  await button(next.page, t.died.copy).click();
  await expect(next.page.getByText(t.died.copied, { exact: true })).toBeVisible();
  await button(next.page, t.died.open).click();
  await expect(next.editor.line("BEGIN PGM DIES MM ;41.7")).toBeVisible();
  // It is shown, so that the next page opens it again.
  await expect.poll(() => next.page.evaluate(() => Object.keys(localStorage).join())).not.toContain("opening/");
  await next.page.reload();
  await expect(next.editor.line("BEGIN PGM DIES MM ;41.7")).toBeVisible();
});

test("a program of more than 5 MB keeps what was typed just before a reload", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const blocks = Array.from({ length: 210_000 }, (_, i) => `${i + 1} L  X+${i % 97}.5  Z-${i % 89}.25`);
  const text = `0 BEGIN PGM LONG MM\r\n${blocks.join("\r\n")}\r\n`;
  expect(text.length).toBeGreaterThan(5_000_000);
  await opener(page).setInputFiles(textFile("LONG.H", text));
  await turnwise.editor.line("BEGIN PGM").click();
  await expect.poll(() => page.evaluate(() => Object.keys(localStorage).join())).not.toContain("journal/");
  await page.keyboard.press("End");
  await page.keyboard.type(" ;3.1");
  await page.reload();
  await expect(turnwise.editor.line("BEGIN PGM LONG MM ;3.1")).toBeVisible();
});

test("rows of another device that nobody can read cost themselves only, and are named", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const job = { name: "P.H", text: "0 BEGIN PGM P MM\n1 END PGM P MM\n", encoding: "utf-8" };
  const result = { format: "turnwise-result/1", name: "Ada", made: 1e20, tasks: [] };
  const manifest = {
    format: "turnwise-archive/1",
    // The second one is called like a property of every object.
    works: ["far", "constructor"].map((work) => ({ work, name: "P", content: { version: 3, savedAt: 1e20, job } })),
    results: {
      content: {
        version: 1,
        files: [
          { file: "ada.json", result },
          { file: "bo.json", result: { ...result, name: "Bo", made: 1e12 } },
        ],
      },
    },
  };
  await opener(page).setInputFiles(archive(manifest));
  const dialog = page.getByRole("dialog");
  await expect(dialog.getByText(t.restore.unreadRows(1, "ada.json"))).toBeVisible();
  await button(page, t.restore.take).click();
  await button(page, t.restore.showAll).click();
  await expect(button(page, t.works.open("P.H"))).toHaveCount(2);

  // What an earlier edition has let in, and a work of a later one.
  await page.evaluate(async () => {
    localStorage.setItem(
      "turnwise/course-results",
      JSON.stringify({
        version: 1,
        files: [{ file: "old.json", result: { format: "turnwise-result/1", name: "Cy", made: 1e20, tasks: [] } }],
      }),
    );
    const open = indexedDB.open("turnwise-works");
    const db = await new Promise<IDBDatabase>((done) => (open.onsuccess = () => done(open.result)));
    const write = db.transaction("works", "readwrite");
    const store = write.objectStore("works");
    store.put({ version: 99, savedAt: 5, size: 5n, job: { name: "LATER.H" } }, "far-2");
    for (let i = 0; i < 250; i++) {
      const many = { name: `N${i}.H`, text: "0 BEGIN PGM N MM\n", encoding: "utf-8" };
      store.put({ version: 3, savedAt: i + 1, job: many }, `n${i}`);
    }
    await new Promise((done) => (write.oncomplete = done));
    db.close();
  });
  await page.reload();
  const unread = page.getByRole("region", { name: t.works.unread.title });
  await expect(unread.getByRole("listitem")).toHaveText([/LATER\.H.*newer/, /old\.json/]);
  const download = page.waitForEvent("download");
  await button(page, t.works.unread.save("LATER.H")).click();
  expect((await download).suggestedFilename()).toBe("LATER.H.json");
  // A list of any length is drawn in portions.
  await expect(turnwise.works.rows).toHaveCount(200);
  await button(page, t.works.more(52)).click();
  await expect(turnwise.works.rows).toHaveCount(252);
  await expect(turnwise.works.rows.nth(200).getByRole("checkbox")).toBeFocused();
  // A backup with a work of that name does not write over it.
  await page.goto("./#/");
  await opener(page).setInputFiles(
    archive({
      ...manifest,
      works: [
        { ...manifest.works[0], work: "far-2", content: { version: 3, savedAt: 500, job: { ...job, name: "Q.H" } } },
      ],
    }),
  );
  await button(page, t.restore.take).click();
  await button(page, t.restore.showAll).click();
  await expect(button(page, t.works.open("Q.H"))).toBeVisible();
  await expect(unread.getByText("LATER.H")).toBeVisible();
  await unread.getByRole("button", { name: t.works.remove("old.json") }).click();
  await expect(unread.getByRole("listitem")).toHaveCount(1);
  await expect(turnwise.page.getByText("Something went wrong")).toHaveCount(0);
});

test("a storage that never answers is reported, and the page goes on in memory with a file to take", async ({
  page,
}) => {
  await page.addInitScript(() => {
    IDBFactory.prototype.open = () => new EventTarget() as IDBOpenDBRequest;
  });
  const turnwise = await Turnwise.open(page);
  await expect(page.getByText(turnwise.t.page.notice.storageSilent)).toBeVisible();
  await turnwise.start.beginWithExample(812);
  await turnwise.dialog.set("Q493", "51.25");
  await expect(button(page, turnwise.t.page.notice.archiveUnkept)).toBeVisible();
  await page.getByRole("link", { name: turnwise.t.page.home }).click();
  await page
    .getByRole("button", { name: /^Continue/ })
    .first()
    .click();
  await expect(turnwise.dialog.line("Q493")).toContainText("51.25");
});
