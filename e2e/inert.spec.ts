import { readFile } from "node:fs/promises";
import type { Locator, Page } from "@playwright/test";
import { usualTable } from "../src/program/tools/cutting-table.ts";
import { MACHINE_FORMAT } from "../src/program/machine/machine-file.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

/** A name that is markup; in a CSV cell it is a formula, too. */
const evil = (of: string) => `=${of}<img src=x onerror="ran=1">`;

const OWN = {
  version: 1,
  cycles: [{ id: "c1", number: "317", name: evil("own"), parameters: [] }],
};
const SETTINGS = {
  machine: JSON.stringify({ format: MACHINE_FORMAT, name: evil("machine") }),
  cutting: JSON.stringify({
    ...usualTable,
    materials: usualTable.materials.map((each) => (each.id === "c45" ? { ...each, name: evil("steel") } : each)),
  }),
};
const TOOLS = `T;NAME;TYPE;TO;RS;T-ANGLE;P-ANGLE;CUTLENGTH\n1;"'=T<img src=x onerror=a()>";ROUGH;1;0,8;95;80;12\n`;
const PROGRAM = [
  "BEGIN PGM A<img/src=x> MM",
  "BLK FORM CYLINDER Z D75 L100 DIST+0",
  "FUNCTION MODE TURN",
  `* - ${evil("operation")}`,
  `; ${evil("comment")}`,
  "TOOL CALL 1",
  "FUNCTION TURNDATA SPIN VCONST:ON VC:180 SMAX2500",
  "M136",
  "L X+95 Z+52 R0 FMAX",
  "CYCL DEF 811 TURN SHOULDER LONG ~",
  ...["Q215=+0", "Q460=+2", "Q493=+50", "Q494=-55", "Q463=+3", "Q478=+0.3", "Q483=+0.4", "Q484=+0.2", "Q505=+0.2"].map(
    (value, i, all) => `${value} ;<script>ran=1</script>${i < all.length - 1 ? " ~" : ""}`,
  ),
  "Q506=+0 ;X",
  "L X+75 Z+2 FMAX M303",
  "CYCL CALL",
  "END PGM A<img/src=x> MM",
  "",
].join("\n");
const result = (name: string) => ({
  format: "turnwise-result/1",
  name,
  group: evil("class"),
  made: 1_795_000_000_123,
  set: { id: "s1", title: evil("set") },
  tasks: [
    {
      id: "t1",
      title: evil("task"),
      tries: 2,
      hints: 0,
      solution: false,
      passed: null,
      seconds: null,
      score: null,
      worked: 97,
      steps: 13,
      program: null,
      verdict: null,
    },
  ],
});

/** Nothing of a name has become an element, and none has run. */
async function expectText(page: Page, where: string): Promise<void> {
  const found = () =>
    page.evaluate(() => [
      (window as { ran?: unknown }).ran,
      document.querySelectorAll("img[src=x], [onerror], body script:not([src])").length,
    ]);
  expect(await found(), where).toEqual([undefined, 0]);
}

/** Name and text of the file that a button downloads. */
async function downloaded(button: Locator): Promise<readonly [string, string]> {
  const waiting = button.page().waitForEvent("download");
  await button.click();
  const file = await waiting;
  return [file.suggestedFilename(), (await readFile(await file.path())).toString()];
}

test("markup in every name stays text: tools, programs, comments, machine, material, learners and tasks", async ({
  page,
}) => {
  await page.addInitScript(
    ([own, settings]) => {
      localStorage.setItem("turnwise/own-cycles", own ?? "");
      if (!localStorage.getItem("turnwise/settings")) localStorage.setItem("turnwise/settings", settings ?? "");
    },
    [JSON.stringify(OWN), JSON.stringify(SETTINGS)],
  );
  const turnwise = await Turnwise.open(page);
  const { comparison, editor, menus, own, settings, sharing, sheet, t, teaching, tools } = turnwise;

  await settings.open();
  await expect(settings.machine.getByRole("combobox")).toHaveValue("own");
  await expectText(page, "settings");
  await page.keyboard.press("Escape");
  await page.goto("./#/own");
  await expect(own.row(317, "=own<img")).toBeVisible();
  await expectText(page, "own cycles");

  await page.goto("./#/tools");
  await tools.import("tools.csv", TOOLS);
  await expect(tools.status).not.toBeEmpty();
  await expectText(page, "tools");
  const { text } = await tools.export("csv");
  expect(text).toContain("'=T<img src=x onerror=a()>");

  await page.goto("./#/");
  await editor.openFile("<img src=x onerror=a()>.h", Buffer.from(PROGRAM));
  for (const section of ["text", "structure", "block", "findings"] as const) {
    await editor.show(section);
    await expectText(page, `program: ${section}`);
  }
  await expect(page).toHaveTitle(/<img src=x/);
  await comparison.open();
  await comparison.withOpened();
  await expect(comparison.summary).not.toBeEmpty();
  await expectText(page, "comparison");
  await comparison.close();
  await sharing.openDialog();
  await expect(sharing.shareDialog).toContainText("=T<img");
  await expectText(page, "share");
  await page.keyboard.press("Escape");
  await menus.choose("export", t.page.text.setupSheet);
  await expect(sheet.preview).toContainText("=operation<img");
  await expectText(page, "setup sheet");
  await sheet.close();
  await page.goto("./#/works");
  await expect(turnwise.works.rows).toHaveCount(1);
  await expectText(page, "programs");

  await page.goto("./#/");
  await editor.drop({ "a.json": JSON.stringify(result(evil("ada"))), "b.json": JSON.stringify(result(evil("bob"))) });
  const results = teaching.classOf(2);
  await expect(results).toContainText("=ada<img");
  await expectText(page, "results");
  const [name, csv] = await downloaded(results.getByRole("button", { name: teaching.words.results.csv }).first());
  expect(name).not.toMatch(/[<>"/\\|?*]/);
  for (const cell of ["ada", "bob", "task"]) expect(csv).toContain(`"'=${cell}<img src=x onerror=""ran=1"">`);
});
