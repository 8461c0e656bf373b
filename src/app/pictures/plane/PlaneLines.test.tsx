import { act, cleanup, render } from "@testing-library/react";
import { afterEach, beforeAll, expect, test } from "vitest";
import { parse } from "../../../nc/parse.ts";
import { run } from "../../../program/run/run.ts";
import { forgetOutcome, takePlanned } from "../../calculation/outcome.ts";
import { fetchTexts } from "../../base/settings/loaded-texts.ts";
import { whileTyping } from "../../base/typing.ts";
import { PlaneLines } from "./PlaneLines.tsx";

beforeAll(() => fetchTexts("en"));
afterEach(() => {
  cleanup();
  forgetOutcome();
});

/** A milled program whose approach has a length. */
function planned(version: number, length: number) {
  const text = `0 BEGIN PGM P MM
1 TOOL DEF 1 L+0 R+10
2 TOOL CALL 1 Z S4000
3 L X-10 Y-10 R0 FMAX
4 APPR LT X+5 Y+5 LEN${length} RL F300
5 L Y+95
6 DEP LT LEN10
7 END PGM P MM
`;
  return { version, text, run: run(parse(text), { tools: [], rapid: 10_000 }), simulation: null };
}

test("the lines of the path are drawn with the key, before the rest of the picture updates", () => {
  const before = planned(1, 10),
    after = planned(2, 25);
  takePlanned(before);
  const { container } = render(
    <svg>
      <PlaneLines of={before.run} />
    </svg>,
  );
  const lead = () => container.querySelector(".plane-lead")?.getAttribute("d"),
    edge = () => container.querySelector(".plane-under");
  expect(lead()).toContain("M-5 -5L-5 5");
  act(() => void whileTyping(() => takePlanned(after)));
  expect(lead()).toContain("M-5 -20L-5 5");
  expect(edge()?.getAttribute("d")).toContain("M-5 -20L-5 5");
});
