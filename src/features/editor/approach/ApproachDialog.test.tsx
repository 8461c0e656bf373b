import { cleanup, fireEvent, render, screen, waitFor } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { useState } from "react";
import { afterEach, beforeAll, expect, test } from "vitest";
import { withBlock } from "../../../nc/edit.ts";
import { parse } from "../../../nc/parse.ts";
import { approachContext } from "../../../program/edits/approach-context.ts";
import { run } from "../../../program/run/run.ts";
import { fetchTexts } from "../../../app/base/settings/loaded-texts.ts";
import { ApproachDialog } from "./ApproachDialog.tsx";

beforeAll(() => fetchTexts("en"));
afterEach(cleanup);

const TEXT = `0 BEGIN PGM P MM
1 TOOL DEF 1 L+0 R+10
2 TOOL CALL 1 Z S4000
3 L X-10 Y-10 R0 FMAX
4 APPR LT X+5 Y+5 LEN10 RL F300
5 L Y+95
6 L X+95
7 DEP LT LEN10
8 END PGM P MM
`;

/** Renders the dialog of one block of a program; `now` is the text after the newest change. */
function shown(index: number) {
  const now = { block: "" };
  function Page() {
    const [program, change] = useState(() => parse(TEXT));
    now.block = program.blocks[index]?.raw.trim() ?? "";
    const statement = program.blocks[index]?.statement;
    if (statement?.kind !== "approach") return null;
    const context = approachContext(program, index, run(program, { tools: [], rapid: 10_000 }), {});
    return (
      <ApproachDialog
        statement={statement}
        context={context}
        onChange={(next) => change(withBlock(program, index, next))}
      />
    );
  }
  render(<Page />);
  return now;
}
const open = () => screen.getByRole<HTMLInputElement>("textbox");

test("the drawing names its points with their coordinates, and follows what is typed", async () => {
  const now = shown(4);
  expect(screen.getByRole("img", { name: /PS at X−10 Y−10, PH at X−5 Y−5, PA at X\+5 Y\+5/ })).toBeDefined();
  await userEvent.click(screen.getByRole("button", { name: /^LEN length/ }));
  expect(document.activeElement).toBe(open());
  await userEvent.clear(open());
  await userEvent.type(open(), "15");
  expect(now.block).toBe("4 APPR LT X+5 Y+5 LEN15 RL F300");
  expect(await screen.findByRole("img", { name: /PH at X−5 Y−10/ })).toBeDefined();
});

test("an error is shown at its prompt and leaves the block unchanged", async () => {
  const now = shown(4);
  await userEvent.click(screen.getByRole("button", { name: /^LEN length/ }));
  await userEvent.clear(open());
  await userEvent.type(open(), "1x");
  await waitFor(() => expect(open().getAttribute("aria-invalid")).toBe("true"));
  expect(now.block).toContain("LEN1 ");
  await userEvent.keyboard("{Escape}");
  expect(open().value).toBe("10");
  expect(now.block).toContain("LEN10");
});

test("typing before the previous key is rendered uses the newest block", async () => {
  const program = { now: parse(TEXT) };
  const blockOf = () => program.now.blocks[4]?.statement;
  const shownBlock = blockOf();
  if (shownBlock?.kind !== "approach") throw new Error("block 4 is no approach");
  const context = approachContext(program.now, 4, run(program.now, { tools: [], rapid: 10_000 }), {});
  const newest = () => {
    const block = blockOf();
    return block?.kind === "approach" ? block : shownBlock;
  };
  render(
    <ApproachDialog
      statement={shownBlock}
      newest={newest}
      context={context}
      onChange={(next) => (program.now = withBlock(program.now, 4, next))}
    />,
  );
  await userEvent.click(screen.getByRole("button", { name: /^LEN length/ }));
  const type = (text: string) => fireEvent.change(open(), { target: { value: text } });
  type("3");
  type("3x");
  expect(program.now.blocks[4]?.raw).toContain("LEN3 ");
  type("10");
  expect(program.now.blocks[4]?.raw).toContain("LEN10 ");
});

test("the keys of the control walk through the prompts to the end", async () => {
  const now = shown(7);
  expect(screen.getByRole("textbox", { name: /^Z/ })).toBeDefined();
  await userEvent.click(open());
  await userEvent.keyboard("{Delete}{Enter}{Enter}{Enter}");
  expect(screen.getByRole("button", { name: "Back to the first prompt" })).toBeDefined();
  expect(now.block).toBe("7 DEP LT LEN10");
});

test("another form is chosen from all eight at the same contour; common values stay", async () => {
  const now = shown(4);
  await userEvent.click(screen.getByRole("button", { name: "Change function" }));
  expect(screen.getAllByRole("button", { name: /^(APPR|DEP) L?[CLT][NT]?T?:/ })).toHaveLength(8);
  await userEvent.click(screen.getByRole("button", { name: /^APPR CT:/ }));
  expect(now.block).toBe("4 APPR CT X+5 Y+5 CCA90 R+10 RL F300");
});
