import { expect, test } from "./pages/test.ts";
import { LANGUAGES } from "../src/i18n/languages.ts";
import { formatNumber } from "../src/i18n/number.ts";
import { tabTo } from "./pages/keyboard.ts";
import { expectAccessible, expectAccessibleAndFits } from "./pages/layout-checks.ts";
import { words } from "./pages/words.ts";
import { Turnwise } from "./pages/turnwise.ts";

test("a new tool by keyboard alone: created, kept over a reload, offered in the set-up and used", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { tools, setup, effect, t } = turnwise;
  const { keyboard } = page;
  await turnwise.start.beginWithExample(812);
  await effect.proved();
  await tabTo(page, page.getByRole("button", { name: t.page.tools.openLong }), "Shift+Tab");
  await keyboard.press("Enter");
  await expect(tools.rowButton(1)).toBeFocused();
  await keyboard.press("ArrowDown");
  await expect(tools.rowButton(2)).toBeFocused();
  await tabTo(page, tools.add, "Shift+Tab");
  await keyboard.press("Enter");
  await expect(tools.cell("T")).toBeFocused();
  await expect(tools.cell("T")).toHaveValue("16");
  await keyboard.type("21");
  await keyboard.press("Enter");
  await expect(tools.cell("NAME")).toBeFocused();
  await keyboard.type("shop 35");
  await tabTo(page, tools.direction(1));
  await keyboard.press("Enter");
  await expect(tools.cell("RS")).toBeFocused();
  for (const value of ["0.4", "", "93", "35", "16"]) {
    await keyboard.type(value);
    await keyboard.press("Enter");
  }
  await expect(tools.row(21)).toContainText("SHOP 35");
  await expect(tools.drawing).toBeVisible();
  await expect.poll(() => page.evaluate(() => localStorage.getItem("turnwise/tools") ?? "")).toContain("SHOP 35");
  await page.reload();
  await expect(tools.rowButton(21)).toBeVisible();
  await tools.close();
  await expect(turnwise.dialog.question).toBeVisible();
  await turnwise.show("setup");
  await setup.tool(21).check();
  await expect(effect.cell("proof")).toContainText(t.findings.verdict.holderUnknown);
  await expect(turnwise.program.blocks.filter({ hasText: "TOOL CALL 21" })).toBeVisible();
  await tools.open();
  await tools.rowButton(21).click();
  await tools.cell("RS").fill("-1");
  await expect(tools.form).toContainText(t.dialog.takeNearest("0"));
  await expect(tools.drawing).toContainText(t.tools.lastPossible);
  await tools.close();
  await turnwise.show("findings");
  await expect(page.getByRole("tabpanel")).toContainText("RS -1");
});

test("a tool is changed, duplicated, deleted and restored; TO by its picture, and a sum", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { tools, t } = turnwise;
  await tools.open();
  await tools.rowButton(3).click();
  await tools.cell("RS").fill("1.2");
  await expect(tools.row(3)).toContainText("1.2");
  await turnwise.undo();
  await expect(tools.cell("RS")).toHaveValue("0.4");
  await turnwise.redo();
  await expect(tools.cell("RS")).toHaveValue("1.2");
  await tools.duplicate.click();
  await expect(tools.cell("T")).toHaveValue("16");
  await expect(tools.cell("RS")).toHaveValue("1.2");
  await tools.cell("T").fill("3");
  await tools.form.getByRole("button", { name: turnwise.t.dialog.takeNearest("16") }).click();
  await expect(tools.cell("T")).toHaveValue("16");
  await tools.remove.click();
  await expect(tools.rowButton(16)).toHaveCount(0);
  await tools.takeBack.click();
  await expect(tools.rowButton(16)).toBeVisible();
  await tools.restore();
  await expect(tools.rowButton(16)).toHaveCount(0);
  await page.keyboard.press("Control+z");
  await expect(tools.rowButton(16)).toBeVisible();

  // TO by its picture, columns unused by a type, and a sum.
  await tools.rowButton(1).click();
  const shape = () => tools.drawing.locator("path.shape-insert").getAttribute("d");
  const before = await shape();
  await tools.direction(7).check();
  await expect.poll(shape).not.toBe(before);
  await tools.direction(7).press("ArrowDown");
  await expect(tools.direction(8)).toBeChecked();
  await tools.type.selectOption("RECTURN");
  await expect(tools.cell("T-ANGLE")).toBeDisabled();
  await expect(tools.cell("CUTWIDTH")).toBeEnabled();
  await expect(tools.drawing).toContainText(t.tools.lastPossible);
  await tools.cell("CUTWIDTH").fill("2*1,5");
  await tools.cell("CUTWIDTH").press("Enter");
  await expect(tools.cell("CUTWIDTH")).toHaveValue("3");
  await expect(tools.drawing).not.toContainText(t.tools.lastPossible);
  await tools.cell("width").fill("20");
  await tools.cell("length").fill("100");
  await expect(tools.drawing.locator("path.shape-holder")).toBeAttached();
});

const codes = words("en", "tool-codes"),
  files = words("en", "tool-files");

test("export and import again, as JSON and as column text", async ({ page }) => {
  const { tools, t } = await Turnwise.open(page);
  await tools.open();
  const json = await tools.export("json");
  expect(json.name).toBe("TOOLS.json");
  expect(JSON.parse(json.text).tools).toHaveLength(15);
  const text = await tools.export("text");
  expect(text.name).toBe("TOOLTURN.TRN");
  expect(text.text).toMatch(/^BEGIN TOOLTURN\.TRN MM\r\nT /);
  await tools.choose({
    name: "SHOP.TRN",
    content: text.text.replace("CNMG-80-R08", "MINE-80-R08").replace("\r\n15 ", "\r\n40 "),
  });
  await expect(tools.incoming).toContainText(files.fresh(1));
  await expect(tools.incoming).toContainText("NAME CNMG-80-R08 → MINE-80-R08");
  await expect(tools.incoming).toContainText(files.same(13));
  await tools.take("new");
  await expect(tools.row(1)).toContainText("CNMG-80-R08");
  await tools.import("SHOP.TRN", text.text.replace("CNMG-80-R08", "MINE-80-R08").replace("\r\n15 ", "\r\n40 "));
  await expect(tools.status).toContainText(files.taken("SHOP.TRN", 0, 1));
  await expect(tools.row(1)).toContainText("MINE-80-R08");
  await expect(tools.rowButton(40)).toBeVisible();
  await tools.takeBack.click();
  await expect(tools.row(1)).toContainText("CNMG-80-R08");
  await tools.choose({ name: "letter.txt", content: "Dear sirs" });
  await expect(tools.status).toContainText(files.notATable("letter.txt"));
  await tools.choose({
    name: "wrong.json",
    content: '{ "tools": [ { "T": 50, "TYPE": "ROUGH", "TO": 99, "RS": 0.8, "COLOUR": 1 } ] }',
  });
  await expect(tools.incoming).toContainText(files.wrong(1));
  await expect(tools.incoming).toContainText(files.leftOut("COLOUR"));
  await tools.take();
  await expect(tools.status).toContainText(t.tools.importedWrong(1));
  await expect(tools.rowButton(50)).toHaveAttribute("aria-current", "true");
  await tools.export("json");
  await expect(tools.status).toContainText(t.tools.exportedWithout("50"));
});

/* A table as a control stores it: windows-1252, a description, unknown columns, decimal comma, a replacement tool. */
const SHOP = [
  "BEGIN TOOLTURN.TRN MM Version: 'Update:110.24'",
  "#STRUCTBEGIN",
  "   NAME = T",
  "#STRUCTEND",
  "T       NAME                ZL        XL        YL    RS       TO T-ANGLE P-ANGLE CUTLENGTH TYPE     SPB-INSERT DOC          ",
  "81      SCHRUPPER           +120,5    -40       +0    +0,8     1  +95     +80     +12       ROUGH    +0         Träger 4     ",
  "81.1    SCHRUPPER           +120,5    -38       +0    +0,8     1  +95     +80     +12       ROUGH    +0         für Rückseite",
  "84      SCHLICHTER          +118,25   -40       +0    +0,4     1  +93     +35     +16       FINISH   +0         ³ neu        ",
  "[END]",
  "",
].join("\r\n");

test("a shop's table is written back byte for byte except for the changed tool, and a sheet adds to it", async ({
  page,
}) => {
  const turnwise = await Turnwise.open(page);
  const { tools } = turnwise;
  await tools.open();
  await tools.choose({ name: "TOOLTURN.TRN", content: Buffer.from(SHOP, "latin1") });
  await expect(tools.incoming).toContainText(files.fresh(3));
  await expect(tools.incoming).toContainText(files.keptInFile("YL, SPB-INSERT, DOC"));
  await expectAccessibleAndFits(page);
  await page.keyboard.press("Enter");
  await expect(tools.rowButton("81.1")).toBeVisible();
  const same = await tools.export("again");
  expect(same.name).toBe("TOOLTURN.TRN");
  expect(same.bytes.equals(Buffer.from(SHOP, "latin1"))).toBe(true);
  await expect(tools.status).toContainText(files.againShipped(15));
  await tools.rowButton(84).click();
  await tools.cell("RS").fill("0.2");
  await expect.poll(() => page.evaluate(() => localStorage.getItem("turnwise/tools") ?? "")).toContain('"0.2"');
  await page.reload();
  await tools.choose({
    name: "new.csv",
    content: "\uFEFFT;NAME;TYPE;TO;RS;T-ANGLE;P-ANGLE;Preis\r\n83;NEU;ROUGH;1;1,2;95;80;12,50\r\n84;;;;0,3;;;\r\n",
  });
  await expect(tools.incoming).toContainText("RS 0.2 → 0.3");
  await expect(tools.incoming).toContainText(files.leftOut("Preis"));
  await tools.take("new");
  const changed = await tools.export("again");
  const titles = SHOP.split("\r\n")[4] ?? "";
  const expected = SHOP.replace("+0,4     1  +93", "+0,2     1  +93").replace(
    "84      SCHL",
    `${"83      NEU                                           +1,2     1  +95     +80               ROUGH".padEnd(
      titles.length,
    )}\r\n84      SCHL`,
  );
  expect(changed.bytes.toString("latin1")).toBe(expected);
  const sheet = await tools.export("csv");
  expect(sheet.text.split("\r\n").find((line) => line.startsWith("84,"))).toMatch(
    /^84,SCHLICHTER,118\.25,-40,,,,0\.2,/,
  );
});

test("codes typed by keyboard make a tool with its holder, and a verified program runs with it", async ({ page }) => {
  const turnwise = await Turnwise.open(page);
  const { tools, setup, effect, t } = turnwise;
  const { keyboard } = page;
  await turnwise.start.beginWithExample(812);
  await effect.proved();
  await tools.open();
  await tabTo(page, tools.add, "Shift+Tab");
  await keyboard.press("Enter");
  await expect(tools.cell("T")).toBeFocused();
  await tabTo(page, tools.code);
  await keyboard.type("dnmg 15 06 08");
  await expect(tools.form.getByRole("list", { name: codes.says })).toContainText("rhombic, 55°");
  await keyboard.press("Enter");
  await expect(tools.form).toContainText(codes.taken("DNMG150608", 4));
  await expect(tools.code).toBeFocused();
  await keyboard.type("PCLNR 2525M12");
  await expect(tools.form).toContainText(codes.notes.rowAngle("55", "80"));
  await keyboard.press("Escape");
  await keyboard.type("PDJNR 2525M15");
  await expectAccessibleAndFits(page);
  await keyboard.press("Enter");
  await expect(tools.row(16)).toContainText("DNMG150608");
  await expect(tools.drawing.locator("path.shape-holder").first()).toBeAttached();
  await turnwise.undo();
  await expect(tools.cell("T-ANGLE")).toHaveValue("");
  await turnwise.redo();
  await expect(tools.cell("T-ANGLE")).toHaveValue("93");
  await tools.close();
  await turnwise.show("setup");
  await setup.tool(16).check();
  await expect(turnwise.program.blocks.filter({ hasText: "TOOL CALL 16" })).toBeVisible();
  await effect.proved();
  await expect(effect.cell("proof")).not.toContainText(t.findings.verdict.holderUnknown);
});

test("milling tools: a second table with its own file", async ({ page }) => {
  const { tools, t } = await Turnwise.open(page);
  await tools.open();
  await tools.show("milling");
  await expect(page.getByText(t.tools.none)).toBeVisible();
  await tools.add.click();
  await expect(tools.cell("T")).toHaveValue("16");
  await tools.cell("NAME").fill("d16");
  await tools.cell("R").fill("8");
  await tools.cell("DR").fill("-0.02");
  await expect(tools.drawing).toContainText("15.96");
  await expect(tools.row(16)).toContainText("D16");
  const text = await tools.export("millText");
  expect(text.name).toBe("TOOL.T");
  expect(text.text).toMatch(/16 +D16 +8 +-0\.02/);
  await tools.remove.click();
  await tools.import("TOOL.T", text.text);
  await expect(tools.cell("R")).toHaveValue("8");
  const json = await tools.export("json");
  expect(JSON.parse(json.text).tools.at(-1)).toEqual({ T: 16, NAME: "D16", TYPE: "MILL", R: 8, DR: -0.02 });
  await tools.show("turning");
  await expect(tools.rowButton(1)).toBeVisible();
  await expect(tools.rowButton(16)).toHaveCount(0);
});

test("two tabs share one table", async ({ page, context }) => {
  const first = await Turnwise.open(page);
  await first.tools.open();
  const second = await Turnwise.open(await context.newPage());
  await second.tools.open();
  await first.tools.cell("NAME").fill("FROM-FIRST");
  await expect(second.tools.row(1)).toContainText("FROM-FIRST");
});

test("a damaged table is set aside with a message, and the default tools are used", async ({ page }) => {
  await page.addInitScript(() => localStorage.setItem("turnwise/tools", "{broken"));
  const { tools, t } = await Turnwise.open(page);
  await expect(page.getByText(t.page.notice.toolsDamaged)).toBeVisible();
  await tools.open();
  await expect(tools.rowButton(15)).toBeVisible();
});

test("the table in every language", async ({ page }) => {
  let shown = await Turnwise.open(page);
  for (const language of LANGUAGES) {
    await shown.settings.chooseLanguage(language);
    shown = Turnwise.at(page, language);
    const { tools } = shown;
    await tools.open();
    await tools.rowButton(1).click();
    await tools.cell("RS").fill("0.5");
    await expect(tools.row(1)).toContainText(formatNumber(language, 0.5));
    await tools.direction(3).check();
    await tools.duplicate.click();
    await tools.remove.click();
    await expect(tools.takeBack).toBeVisible();
    await expectAccessible(page);
    await tools.restore();
    await tools.close();
  }
});
