import { expectAccessible } from "./pages/layout-checks.ts";
import { settledBox } from "./pages/picture.ts";
import { expect, test } from "./pages/test.ts";
import { Turnwise } from "./pages/turnwise.ts";

/** Turns, mills a slot across the face with a rapid that is too low, and turns again. */
const MIXED = `0 BEGIN PGM MIXED MM
1 BLK FORM CYLINDER Z D62.4 L70.3 DIST+1
2 FUNCTION MODE TURN
3 TOOL CALL 1
4 FUNCTION TURNDATA SPIN VCONST:OFF S700 M3
5 M136
6 L X+66.2 Z+3 R0 FMAX
7 L X+58.6 FMAX
8 L Z-20.7 F0.21
9 L X+66.2
10 M137
11 FUNCTION MODE MILL
12 TOOL DEF 1 L+0 R+5
13 TOOL CALL 1 Z S3000
14 L X-45 Y+0 Z+20 R0 FMAX
15 L Z-6 R0 FMAX M3
16 L X+0 F400
17 L Y+14 FMAX
18 L Z+50 FMAX
19 M30
20 END PGM MIXED MM
`;

/** A pocket with a 9 mm mouth, and a 10 mm tool. */
const NARROW = `0 BEGIN PGM NARROW MM
1 TOOL DEF 1 L+0 R+5
2 TOOL CALL 1 Z S4000
3 L Z+20 R0 FMAX
4 L X-40 Y-40 R0 F500
5 APPR LT X-30 Y-10 LEN10 RL F100
6 L X+0 Y+0
7 L X+10
8 L Y-6
9 L X+40
10 L Y+15
11 L X+10
12 L Y+9
13 L X+0
14 L X-30 Y+19
15 DEP LT LEN10
16 L Z+20 R0 FMAX M2
17 END PGM NARROW MM
`;

test("a milled program shows its plane and its stock; its approach is edited in every way", async ({ page }) => {
  const { editor, t } = await Turnwise.open(page);
  await editor.openExample("plate");
  const view = page.getByRole("region", { name: t.approach.view });
  await expect(view).toBeVisible();
  // The first approach is named before anything is chosen.
  await expect(view.locator(".plane-points text")).toHaveText(["PS", "X−10 Y−10", "PH", "X−5 Y−5", "PA", "X+5 Y+5"]);
  // Enter in the picture opens the block of the move, with the keyboard.
  await view.getByRole("group", { name: t.approach.view }).press("Enter");
  await expect(page.locator(".panel-block :focus")).toBeVisible();
  await editor.line("APPR LT").click();
  await editor.show("block");
  await expect(page.getByRole("img", { name: /PH at X−5 Y−5, PA at X\+5 Y\+5/ })).toBeVisible();
  await page.getByRole("button", { name: /^LEN length/ }).click();
  await page.keyboard.type("15");
  await expect(page.getByRole("img", { name: /PH at X−5 Y−10/ })).toBeVisible();
  await expect(editor.line("APPR LT")).toContainText("LEN15");
  const grip = await settledBox(page.locator('[data-handle="PH"]'));
  const [x, y] = [grip.x + grip.width / 2, grip.y + grip.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x, y + 30, { steps: 5 });
  await page.mouse.up();
  await expect(editor.line("APPR LT")).not.toContainText("LEN15");
  await page.getByRole("button", { name: t.approach.otherForm }).click();
  await expectAccessible(page);
  await page.getByRole("button", { name: /^APPR CT:/ }).click();
  await expect(editor.line("APPR CT")).toContainText("CCA90");
  await expectAccessible(page);

  // Milled stock is drawn, and its path leads to its block.
  await page.getByRole("link", { name: t.page.home, exact: true }).click();
  await editor.openExample("plate");
  const plane = page.getByRole("region", { name: t.approach.view }),
    stage = plane.getByRole("group", { name: t.approach.view });
  const depths = plane.getByRole("list", { name: t.approach.milled.title });
  await expect(depths.getByRole("listitem")).toHaveText([
    t.approach.milled.depth("-5"),
    t.approach.milled.depth("-10"),
  ]);
  await expect(stage.locator(".lathe-scales text", { hasText: /^100$/ })).not.toHaveCount(0);
  // A place of the plane on the screen, by the scales along its edges.
  const at = async (x: number, y: number) => {
    const box = await settledBox(stage);
    const of = (text: string, side: "x" | "y") =>
      stage.locator(".lathe-scales text").evaluateAll(
        (all, [wanted, axis]) =>
          all.flatMap((each) => {
            const place = { x: Number(each.getAttribute("x")), y: Number(each.getAttribute("y")) - 4 };
            const isMine = (axis === "x") === (each.getAttribute("text-anchor") === "middle");
            return each.textContent === wanted && isMine ? [place[axis as "x" | "y"]] : [];
          })[0] ?? Number.NaN,
        [text, side] as const,
      );
    const [x0, x1, y0, y1] = [await of("0", "x"), await of("100", "x"), await of("0", "y"), await of("100", "y")];
    return { x: box.x + x0 + (x / 100) * (x1 - x0), y: box.y + y0 + (y / 100) * (y1 - y0) };
  };
  const press = async (x: number, y: number) => {
    const spot = await at(x, y);
    await page.mouse.move(spot.x, spot.y);
    await page.mouse.click(spot.x, spot.y);
  };
  // The middle of the left side of the square, which its centre passes at X-5; then the end of the approach to it.
  await press(-5, 50);
  await expect(editor.line("L Y+95")).toHaveClass(/running|active/i);
  await expect(plane.locator(".shape-marked")).toHaveCount(1);
  await press(-5, 5);
  await expect(page.getByRole("heading", { name: /APPR LT/ })).toBeVisible();
  await stage.focus();
  await page.keyboard.press("End");
  await expect(plane.getByText(t.approach.milled.drawn)).toBeVisible();
  // The plate is removed around the square; the middle of the square is untouched.
  await expectAccessible(page);
});

test("the view follows what turns and what mills; a mouth narrower than the tool is reported at its place", async ({
  page,
}) => {
  const { editor, t } = await Turnwise.open(page);
  await editor.openFile("MIXED.H", new TextEncoder().encode(MIXED));
  const plane = page.getByRole("region", { name: t.approach.view });
  const lathe = page.getByRole("region", { name: t.lathe.title });
  await expect(lathe).toBeVisible();
  await editor.line("L X+0 F400").click();
  await expect(plane).toBeVisible();
  await expect(plane.getByText(t.approach.milled.rapid("17"))).toBeAttached();
  await editor.line("L Z-20.7").click();
  await expect(lathe).toBeVisible();
  await page.getByRole("button", { name: t.approach.view }).click();
  await expect(plane).toBeVisible();
  await editor.line("L X+58.6").click();
  await expect(lathe).toBeVisible();
  // Playback continues into the milled part, so the view changes to the plane.
  await page.getByRole("combobox", { name: t.lathe.speed }).selectOption("100");
  await lathe.getByRole("group", { name: t.lathe.title }).focus();
  await page.keyboard.press("Space");
  await expect(plane).toBeVisible();

  // A mouth narrower than the tool is reported at its place, with the largest radius that fits.
  await page.getByRole("link", { name: t.page.home, exact: true }).click();
  await editor.openFile("NARROW.h", Buffer.from(NARROW));
  await editor.show("findings");
  await expect(
    page.getByText(/Along element 1 the tool cuts 1\smm into element 8 at .*Y\s?\+?9.*4\.5/).first(),
  ).toBeVisible();
  const view = page.getByRole("region", { name: t.approach.view });
  await expect(view.getByRole("button", { name: /Along element 1 the tool cuts/ })).toBeVisible();
});
