import { readFile } from "node:fs/promises";
import { encode } from "uqr";
import type { Locator } from "@playwright/test";
import { expect, test } from "./pages/test.ts";
import { expectAccessibleAndFits } from "./pages/layout-checks.ts";
import { Turnwise } from "./pages/turnwise.ts";

/** The bytes that a button of a dialog downloads. */
async function downloaded(button: Locator): Promise<string> {
  const waiting = button.page().waitForEvent("download");
  await button.click();
  return (await readFile(await (await waiting).path())).toString();
}

test("a shared work gives the same report, byte for byte, elsewhere, and its tools can be kept", async ({
  page,
  browser,
}) => {
  // The sender has another tool number 3.
  const sender = await Turnwise.open(page);
  await sender.tools.open();
  await sender.tools.rowButton(3).click();
  await sender.tools.cell("RS").fill("3");
  await sender.tools.close();
  await sender.editor.openExample("flange");
  const { words } = sender.sharing;
  const totals = ({ editor, t }: Turnwise) =>
    [t.page.effect.residual, t.findings.verdict.title].map((name) => editor.total(name));
  const [stays, verdict] = totals(sender);
  await expect(stays!).toContainText("1.74");
  await expect(verdict!).toContainText(sender.t.findings.verdict.notes);
  const said = [await stays!.textContent(), await verdict!.textContent()];
  await sender.sharing.openDialog();
  const link = await sender.sharing.link();
  await expectAccessibleAndFits(page);
  expect(link.length).toBeLessThan(1732);
  const code = sender.sharing.shareDialog.getByRole("img", { name: words.qrName("FLANGE.h"), exact: true });
  const drawn = await code.locator("path").getAttribute("d");
  const rows = encode(link, { ecc: "L", border: 0 }).data;
  expect((await code.getAttribute("viewBox"))?.split(" ")[2]).toBe(String(rows.length + 8));
  const black = [...(drawn ?? "").matchAll(/M(\d+) (\d+)h(\d+)/g)].reduce((sum, [, , , wide]) => sum + Number(wide), 0);
  expect(black).toBe(rows.flat().filter(Boolean).length);
  const report = await downloaded(sender.sharing.shareDialog.getByRole("button", { name: words.report, exact: true }));
  expect(JSON.parse(report)).toMatchObject({
    format: "turnwise-report/1",
    file: "FLANGE.h",
    proof: { verdict: "proved" },
  });

  // The receiver has the default tools and another work open.
  const context = await browser.newContext();
  const receiver = await Turnwise.open(await context.newPage());
  const other = receiver.page;
  await receiver.start.beginWithExample(812);
  await receiver.effect.proved();
  await other.goto(link);
  const inside = receiver.sharing.incoming("FLANGE.h");
  await expect(inside).toContainText("77");
  await expect(inside.getByRole("listitem").filter({ hasText: "T3" })).toContainText(words.state.differs);
  await expect(inside.getByRole("listitem").filter({ hasText: "T1 CNMG" })).toContainText(words.state.same);
  await expectAccessibleAndFits(other);
  // Nothing was opened: the other work is still there.
  await other.keyboard.press("Escape");
  await expect(receiver.dialog.question).toBeVisible();
  await other.goto("about:blank");
  await other.goto(link);
  await expect(
    receiver.sharing.incoming("FLANGE.h").getByRole("button", { name: words.open, exact: true }),
  ).toBeFocused();
  await other.keyboard.press("Enter");
  for (const [i, total] of totals(receiver).entries()) await expect(total).toHaveText(said[i] ?? "");
  await expect(receiver.sharing.toolsLine).toContainText("6");
  await receiver.sharing.openDialog();
  await receiver.sharing.link();
  expect(await downloaded(receiver.sharing.shareDialog.getByRole("button", { name: words.report, exact: true }))).toBe(
    report,
  );
  expect(await receiver.sharing.link()).toBe(link);
  await other.keyboard.press("Escape");

  // The tool that differs is added under another number, and the program calls that number.
  await receiver.sharing.toolsLine.getByRole("button").click();
  const { tools } = receiver.sharing;
  await expect(tools.getByRole("row").filter({ hasText: "RS" })).toContainText("0.4");
  for (const [width, height] of [
    [390, 844],
    [768, 1024],
    [1280, 800],
  ] as const) {
    await other.setViewportSize({ width, height });
    await expectAccessibleAndFits(other);
  }
  await tools.getByRole("combobox", { name: words.becomes("T3 DNMG-55-R04"), exact: true }).selectOption("free");
  await tools.getByRole("button", { name: words.keep, exact: true }).click();
  await expect(tools.getByText(words.moved(3, 16))).toBeVisible();
  await tools.getByRole("button", { name: words.changeCalls(1), exact: true }).click();
  await expect(tools.getByText(words.callsChanged)).toBeVisible();
  await tools.getByRole("button", { name: words.useMine, exact: true }).click();
  await expect(receiver.sharing.toolsLine).toBeHidden();
  const operations = other.getByRole("list", { name: receiver.t.operations.list, exact: true });
  await expect(operations).toContainText("T16 DNMG");
  for (const [i, total] of totals(receiver).entries()) await expect(total).toHaveText(said[i] ?? "");
  await receiver.tools.open();
  await receiver.tools.rowButton(3).click();
  await expect(receiver.tools.cell("RS")).toHaveValue("0.4");
  await receiver.tools.rowButton(16).click();
  await expect(receiver.tools.cell("RS")).toHaveValue("3");
  await receiver.tools.close();
  // Undo step by step: in the program the device table in use and the calls, in the table the tools that were kept.
  await receiver.undo();
  await expect(receiver.sharing.toolsLine).toBeVisible();
  await receiver.undo();
  await expect(operations).toContainText("T3 DNMG");
  await receiver.tools.open();
  await receiver.undo();
  await expect(receiver.tools.rowButton(16)).toHaveCount(0);
  await context.close();
});
