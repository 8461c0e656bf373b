import { onDevices } from "./pages/devices.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

onDevices(["desktop", "phone"], (expectFineHere) => {
  test("the states of the tool table pass axe, and fit", async ({ page }) => {
    const { tools } = await Turnwise.open(page);
    await tools.open();
    await expectFineHere(page, "the table");
    await tools.cell("RS").fill("x");
    await tools.cell("P-ANGLE").fill("99");
    await expectFineHere(page, "a tool that is wrong");
    await tools.choose({ name: "list.csv", content: "Nr;Art;Radius\n1;Spezial;0,8\n" });
    await expect(tools.sheet).toContainText("Spezial");
    await expectFineHere(page, "the columns of a sheet");
    await page.keyboard.press("Escape");
    await expect(tools.sheet).toHaveCount(0);
    await tools.add.click();
    await expectFineHere(page, "a new tool");
    await tools.show("milling");
    await tools.add.click();
    await tools.cell("R").fill("8");
    await expectFineHere(page, "milling tools");
    // Both kinds of tools show an empty table in the same way.
    await tools.remove.click();
    await expect(tools.table).toHaveCount(0);
    await expectFineHere(page, "the empty table");
  });
});
