import type { Page } from "@playwright/test";
import { compare as words } from "../src/i18n/en/compare.ts";
import { files as filesWords } from "../src/i18n/en/files.ts";
import { expectFineInBothThemes } from "./pages/layout-checks.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

/** Characters of the older encoding, undefined bytes, mixed line ends, and no line end at the end of the file. */
const AWKWARD = [
  ...Buffer.from("0 BEGIN PGM AWK MM\r\n1 ; ", "latin1"),
  ...Array.from({ length: 128 }, (_, i) => 128 + i),
  ...Buffer.from("\n2 TOOL CALL 1\r3 L X+63.4 Z+1.8 R0 FMAX\r\n4 END PGM AWK MM", "latin1"),
];

const put = (page: Page, bytes: readonly number[]) =>
  page.evaluate(
    async (all) => {
      const root = await navigator.storage.getDirectory();
      const out = await (await root.getFileHandle("AWK.H", { create: true })).createWritable();
      await out.write(new Uint8Array(all));
      await out.close();
    },
    [...bytes],
  );
const onDevice = (page: Page) =>
  page.evaluate(async () => {
    const root = await navigator.storage.getDirectory();
    return [...new Uint8Array(await (await (await root.getFileHandle("AWK.H")).getFile()).arrayBuffer())];
  });

test("a file is saved back byte for byte after a reload, and never over foreign changes", async ({ page }) => {
  // The file picker of the browser can not be operated from here: it returns files of the origin private file system.
  await page.addInitScript(() =>
    Object.assign(window, {
      showOpenFilePicker: async () => [await (await navigator.storage.getDirectory()).getFileHandle("AWK.H")],
    }),
  );
  const turnwise = await Turnwise.open(page);
  const { editor, t } = turnwise;
  // A file can not be read at the moment the page replaces it.
  const held = async () => Buffer.from(await onDevice(page).catch(() => [])).toString("latin1");
  const holds = (text: string) => expect.poll(held).toBe(text);
  const typeBehind = async (text: string) => {
    await editor.line("X+63.4").click();
    // In a file with mixed line ends, carriage returns are characters.
    await page.keyboard.press("End");
    await page.keyboard.press("ArrowLeft");
    await page.keyboard.type(text);
  };
  await put(page, AWKWARD);
  await page.getByRole("button", { name: t.page.programs.openFile, exact: true }).first().click();
  await expect(editor.text).toBeVisible();
  const save = page.getByRole("button", { name: t.editor.saveLong("AWK.H"), exact: true });
  await save.click();
  await expect(page.getByText(t.editor.saved("AWK.H"), { exact: true })).toBeVisible();
  await holds(Buffer.from(AWKWARD).toString("latin1"));

  await page.reload();
  await typeBehind(" M8");
  await save.click();
  const edited = Buffer.from(AWKWARD).toString("latin1").replace("FMAX", "FMAX M8");
  await holds(edited);

  // Another program changes a value in the file.
  const others = edited.replace("TOOL CALL 1", "TOOL CALL 3");
  await put(page, [...Buffer.from(others, "latin1")]);
  await typeBehind(" M5");
  await save.click();
  const question = page.getByRole("alertdialog", { name: filesWords.changed.title("AWK.H"), exact: true });
  await expect(question).toBeVisible();
  await expectFineInBothThemes(page, "a file that changed on the device");
  await holds(others);
  await question.getByRole("button", { name: filesWords.compare, exact: true }).click();
  const comparison = page.getByRole("dialog", { name: words.title, exact: true });
  await expect(comparison.getByRole("group", { name: words.list }).getByRole("button")).toHaveCount(2);
  await expect(comparison.getByRole("group", { name: words.list })).toContainText(`${words.tool} 3 → 1`);
  await page.keyboard.press("Escape");
  await save.click();
  await question.getByRole("button", { name: filesWords.overwrite, exact: true }).click();
  await holds(edited.replace("M8", "M8 M5"));

  // Characters that the encoding lacks are reported before saving; so is a deleted file.
  await typeBehind(" ;→");
  await expect(page.getByText(t.editor.otherEncoding("→", "AWK.H"))).toBeVisible();
  await page.evaluate(async () => (await navigator.storage.getDirectory()).removeEntry("AWK.H"));
  await save.click();
  await expect(page.getByRole("alertdialog", { name: filesWords.gone.title("AWK.H"), exact: true })).toBeVisible();
});
