import { files as words } from "../src/i18n/en/files.ts";
import { expectFineAtSizes } from "./pages/layout-checks.ts";
import { provedIn } from "./pages/effect.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

const MAIN = `0 BEGIN PGM MAIN MM
1 BLK FORM CYLINDER Z D63.4 L90 DIST+0
2 FUNCTION MODE TURN
3 TOOL CALL 1
4 FUNCTION TURNDATA SPIN VCONST:ON VC:180 SMAX2500
5 M136
6 CALL PGM TNC:\\work\\away
7 CALL PGM DEFINES
8 L X+63.4 Z+1.8 FMAX M303
/9 CYCL CALL
10 L Z+52 R0 FMAX
11 M30
12 END PGM MAIN MM
`;
const DEFINES = `0 BEGIN PGM DEFINES MM
1 CYCL DEF 811 SHOULDER, LONGITDNL. ~
Q215=+0 ;MACHINING OPERATION ~
Q460=+2 ;SAFETY CLEARANCE ~
Q493=+41.27 ;DIAMETER AT CONTOUR END ~
Q494=-33.85 ;CONTOUR END IN Z ~
Q463=+2.35 ;MAX. CUTTING DEPTH ~
Q478=+0.3 ;ROUGHING FEED RATE ~
Q483=+0.5 ;OVERSIZE FOR DIAMETER ~
Q484=+0.15 ;OVERSIZE IN Z ~
Q505=+0.2 ;FINISHING FEED RATE ~
Q506=+0 ;CONTOUR SMOOTHING
2 END PGM DEFINES MM
`;
const AWAY = "0 BEGIN PGM AWAY MM\n1 L X+95 Z+52 R0 FMAX\n2 END PGM AWAY MM\n";

test("files dropped together run together, a missing one is reported and added, and a reload keeps them", async ({
  page,
}) => {
  // The browser's own question for files can not be answered from here; the plain one can.
  await page.addInitScript(() => Object.assign(window, { showOpenFilePicker: undefined }));
  const turnwise = await Turnwise.open(page);
  const { editor, findings, t } = turnwise;
  const verdict = editor.total(t.findings.verdict.title);
  await editor.drop({ "defines.h": DEFINES, "MAIN.h": MAIN });
  await expect(editor.total(t.editor.operations)).toHaveText("1");
  await expect(page.getByRole("heading", { level: 1 })).toHaveText("MAIN.h");
  await expect(editor.file("MAIN.h")).toHaveAttribute("aria-current", "true");
  await expect(verdict).not.toHaveText(provedIn(t));

  await editor.show("findings");
  await expect(findings.items.filter({ hasText: "away.H" })).toHaveCount(1);
  const choosing = page.waitForEvent("filechooser");
  await findings.button(t.editor.files.addOne("away.H")).click();
  await (await choosing).setFiles({ name: "AWAY.H", mimeType: "text/plain", buffer: Buffer.from(AWAY) });
  await expect(editor.file("away.H")).toBeVisible();
  await expect(verdict).toHaveText(provedIn(t));
  await turnwise.undo();
  await expect(editor.file("away.H")).toHaveCount(0);
  await turnwise.redo();
  await expect(verdict).toHaveText(provedIn(t));

  await page.reload();
  await expect(editor.file("away.H")).toBeVisible();
  await expect(verdict).toHaveText(provedIn(t));
});

test("a called program is shown and edited, another one can run, and a switch skips blocks", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { editor, findings, t } = turnwise;
  const passes = editor.total(t.page.effect.passes);
  await editor.drop({ "defines.h": DEFINES, "MAIN.h": MAIN, "away.h": AWAY });
  await expect(passes).toHaveText("5");
  await editor.line("CYCL CALL").click();
  await editor.show("block");
  await page.getByRole("button", { name: t.editor.goToDefinitionIn("1", "defines.h"), exact: true }).click();
  await expect(editor.file("defines.h")).toHaveAttribute("aria-current", "true");
  await expect(editor.heading).toContainText("1");
  await turnwise.dialog.open("Q463");
  await turnwise.dialog.value.fill("1.15");
  await expect(editor.line("Q463=+1.15")).toBeVisible();
  await expect(passes).toHaveText("10");
  await editor.file("MAIN.h").click();
  await expect(editor.line("CALL PGM DEFINES")).toBeVisible();
  await turnwise.undo();
  await expect(editor.file("defines.h")).toHaveAttribute("aria-current", "true");
  await expect(editor.line("Q463=+2.35")).toBeVisible();
  await expect(passes).toHaveText("5");

  await editor.line("Q494=").click();
  // At the edge of a row the second press goes to the edge of the block, which may have two rows.
  for (const key of ["Home", "Home", "Shift+End", "Shift+End"]) await page.keyboard.press(key);
  await page.keyboard.type("Q494=+QL7 ;CONTOUR END IN Z ~");
  await expect(editor.total(t.findings.verdict.title)).toContainText("defines.h");
  await editor.file("away.h").click();
  await editor.show("findings");
  const place = t.findings.blockOf("1", "defines.h");
  await findings.items
    .filter({ hasText: "QL7" })
    .getByRole("button", { name: t.findings.goTo(place) })
    .first()
    .click();
  await expect(editor.file("defines.h")).toHaveAttribute("aria-current", "true");

  await editor.files.getByRole("button", { name: t.editor.files.runLong("away.h"), exact: true }).press("Enter");
  await expect(editor.file("away.h")).toBeFocused();
  await expect(page.getByRole("heading", { level: 1 })).toHaveText("away.h");
  await expect(editor.total(t.editor.operations)).toHaveText("0");
  await turnwise.undo();
  await expect(page.getByRole("heading", { level: 1 })).toHaveText("MAIN.h");
  await expect(editor.total(t.editor.operations)).toHaveText("1");
  for (const name of ["defines.h", "away.h"])
    await editor.files.getByRole("button", { name: t.editor.files.remove(name), exact: true }).press("Enter");
  await expect(editor.total(t.findings.verdict.title)).not.toHaveText(provedIn(t));
  await expect(editor.file("MAIN.h")).toBeFocused();

  // A switch of the work skips the blocks with a skip mark.
  await page.getByRole("link", { name: t.page.home, exact: true }).click();
  const operations = editor.total(t.editor.operations);
  await editor.drop({ "defines.h": DEFINES, "MAIN.h": MAIN, "away.h": AWAY });
  await expect(operations).toHaveText("1");
  await editor.leaveOut.check();
  await expect(operations).toHaveText("0");
  await page.reload();
  await expect(editor.leaveOut).toBeChecked();
  await expect(operations).toHaveText("0");
  await editor.leaveOut.uncheck();
  await expect(operations).toHaveText("1");
  await turnwise.undo();
  await expect(operations).toHaveText("0");
});

test("a link carries the files of a work and its switch", async ({ page, context }) => {
  const { editor } = await Turnwise.open(page);
  await editor.drop({
    "defines.h": DEFINES,
    "MAIN.h": MAIN.replace("/9 CYCL CALL", "9 CYCL CALL\n/10 L Z+51 FMAX"),
    "away.h": AWAY,
  });
  await editor.leaveOut.check();
  const link = await editor.sharedLink();
  const other = await context.newPage();
  await other.goto(link);
  const { editor: opened, sharing, t } = Turnwise.at(other);
  await expect(sharing.incoming("MAIN.h")).toContainText("defines.h");
  await sharing.open();
  await expect(opened.file("defines.h")).toBeVisible();
  await expect(opened.leaveOut).toBeChecked();
  await expect(opened.total(t.editor.operations)).toHaveText("1");
});

test("from a folder with several programs, open one with the programs it calls, or all as separate works", async ({
  page,
}) => {
  // The folder picker of the browser can not be operated from here: it returns a folder of the origin private file
  // system.
  await page.addInitScript(() =>
    Object.assign(window, {
      showDirectoryPicker: async () => (await navigator.storage.getDirectory()).getDirectoryHandle("job"),
    }),
  );
  const turnwise = await Turnwise.open(page);
  const { editor, t } = turnwise;
  const other = AWAY.replaceAll("AWAY", "OTHER");
  await page.evaluate(
    async (all) => {
      const root = await (await navigator.storage.getDirectory()).getDirectoryHandle("job", { create: true });
      for (const [path, text] of Object.entries(all)) {
        const [name = "", folder] = path.split("/").reverse();
        const place = folder === undefined ? root : await root.getDirectoryHandle(folder, { create: true });
        const out = await (await place.getFileHandle(name, { create: true })).createWritable();
        await out.write(text);
        await out.close();
      }
    },
    {
      "MAIN.h": MAIN,
      "work/away.h": AWAY,
      "work/defines.h": DEFINES,
      "OTHER.h": other,
      ".hidden.h": AWAY,
      "photo.jpg": "1",
    },
  );
  const openFolder = page.getByRole("button", { name: t.page.programs.openFolder, exact: true });
  await openFolder.click();
  const question = page.getByRole("dialog", { name: words.choose.title, exact: true });
  await expect(question.getByRole("listitem")).toHaveCount(2);
  await expect(question.getByRole("button", { name: words.choose.open("MAIN.h") })).toContainText(words.choose.with(2));
  await expect(question).toContainText(words.choose.skipped(1));
  await expectFineAtSizes(page, "the question which program", [
    [1280, 844],
    [390, 844],
  ]);
  await page.setViewportSize({ width: 1280, height: 800 });
  await question.getByRole("button", { name: words.choose.open("MAIN.h") }).click();
  await expect(editor.total(t.editor.operations)).toHaveText("1");
  await expect(editor.file("defines.h")).toBeVisible();
  await expect(editor.file("OTHER.h")).toHaveCount(0);

  await page.getByRole("link", { name: t.page.home, exact: true }).click();
  await openFolder.click();
  await question.getByRole("button", { name: words.choose.all(2), exact: true }).click();
  await expect(page.getByRole("heading", { level: 1 })).toHaveText(/MAIN.h|OTHER.h/);
  await page.getByRole("link", { name: t.page.home, exact: true }).click();
  await expect(page.getByRole("button", { name: t.page.start.continueWork("OTHER.h"), exact: true })).toHaveCount(1);
});
