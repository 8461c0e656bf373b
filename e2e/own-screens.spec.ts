import { onDevices } from "./pages/devices.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

const parameter = (id: string, q: string, prompt: string, more: object) => ({
  id,
  q,
  prompt,
  min: "",
  max: "",
  first: "",
  choices: "",
  ...more,
});
/** One usable description, and one with errors. */
const KEPT = JSON.stringify({
  version: 1,
  cycles: [
    {
      id: "c1",
      number: "317",
      name: "BAR PULLER",
      parameters: [
        parameter("p1", "Q1711", "PULL LENGTH", { kind: "length", min: "0.5", max: "187.25" }),
        parameter("p2", "Q1712", "GRIP", { kind: "choice", choices: "0 open, 1 closed" }),
      ],
    },
    {
      id: "c2",
      number: "812",
      name: "A VERY LONG NAME OF A CYCLE THAT WRAPS",
      parameters: [parameter("p1", "R1", "", { kind: "feed", first: "x" })],
    },
  ],
});
const PROGRAM =
  "BEGIN PGM A MM\nCYCL DEF 317 BAR PULLER ~\nQ1711=+200 ;PULL LENGTH ~\nQ1712=+1 ;GRIP\nCYCL CALL\nEND PGM A MM\n";

onDevices(["desktop", "phone"], (expectFineHere) => {
  test("own cycles: the list, a description with errors and the dialog of a block pass axe, and fit", async ({
    page,
  }) => {
    await page.addInitScript((kept) => localStorage.setItem("turnwise/own-cycles", kept), KEPT);
    const { dialog, editor, own, settings, t } = await Turnwise.open(page);
    await settings.open();
    await page.getByRole("dialog").getByRole("button", { name: t.page.own.title, exact: true }).click();
    await own.row(812, "A VERY LONG NAME").click();
    await expect(page.getByText(t.own.problems.noParameter("R1"))).toBeVisible();
    await expectFineHere(page, "a description with errors");
    await page.goto("./#/");
    await editor.openFile("A.H", Buffer.from(PROGRAM));
    await editor.line("Q1711").click();
    await editor.show("block");
    await expect(dialog.messages).toContainText("200");
    await expectFineHere(page, "the dialog of a block");
    await dialog.open("Q1712");
    await expect(page.getByText(t.editor.ownUnproved)).toBeVisible();
    await expectFineHere(page, "a choice of a block");
  });
});
