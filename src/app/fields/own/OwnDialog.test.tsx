import { cleanup, render, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { useState } from "react";
import { afterEach, beforeEach, expect, test } from "vitest";
import { texts } from "../../../i18n/index.ts";
import { parse } from "../../../nc/parse.ts";
import { print } from "../../../nc/program.ts";
import { newParameter } from "../../../program/edits/own-cycle.ts";
import { withPrompt } from "../blocks/block-prompts.ts";
import { entryAt } from "../../findings/entry.ts";
import { openPrompt } from "../../place/place.ts";
import { changeSettings } from "../../base/settings/settings.ts";
import { readingOfOwn } from "../blocks/own-block.ts";
import { libraryOf } from "../../document/own-reading.ts";
import { ownRecord, useOwn } from "../../document/own-store.ts";
import { OwnDialog } from "./OwnDialog.tsx";

const t = texts("en");
const TEXT =
  "0 BEGIN PGM A MM\r\n1 Q5 = 3.25\r\n2 CYCL DEF 317  BAR PULLER ~\r\n\tQ1711=+31.70  ;PULL LENGTH   ~\r\n\tQ1713 = F AUTO ;FEED ~\r\n" +
  "\tQ1790=-4 ;MORE\r\n3 END PGM A MM\r\n";
const program = parse(TEXT);
const cycles = () => libraryOf(useOwn.getState().list).cycles;
const reading = (typed: Record<string, string> = {}) => readingOfOwn(program, 2, typed, cycles());

beforeEach(() => {
  changeSettings({ language: "en" });
  ownRecord.replace([
    {
      id: "c1",
      number: "317",
      name: "BAR PULLER",
      parameters: [
        newParameter("p1", { q: "Q1711", prompt: "PULL LENGTH", kind: "length", min: "0.5", max: "187.25" }),
        newParameter("p2", { q: "Q1712", prompt: "GRIP", kind: "choice", choices: "0 open, 1 closed" }),
        newParameter("p3", { q: "Q1713", prompt: "FEED", kind: "feed" }),
      ],
    },
  ]);
});
afterEach(cleanup);

test("a block is read by its description, with missing and additional parameters", () => {
  const read = reading();
  expect(read?.parameters.map(({ q, described }) => `${q} ${described}`)).toEqual([
    "Q1711 true",
    "Q1712 true",
    "Q1713 true",
    "Q1790 false",
  ]);
  expect(read?.draft).toEqual({ Q1711: "31.7", Q1713: "FAUTO", Q1790: "-4" });
  expect(read?.issues.map(({ code, at }) => `${code} ${at}`)).toEqual(["missing Q1712"]);
  expect(reading({ Q1711: "Q5", Q1712: "1" })?.issues).toEqual([]);
  expect(reading({ Q1711: "Q5/10", Q1712: "2" })?.issues.map(({ code }) => code)).toEqual(["outOfRange", "notAChoice"]);
  expect(readingOfOwn(program, 1, {}, cycles())).toBeNull();
  ownRecord.replace([]);
  expect(reading()).toBeNull();
});

test("a value changes only its own characters, and a missing one is inserted in order with its prompt text", () => {
  expect(print(withPrompt(program, 2, "Q1711", "44.5"))).toBe(TEXT.replace("+31.70", "+44.5"));
  expect(print(withPrompt(program, 2, "Q1713", "fmax"))).toBe(TEXT.replace("= F AUTO", "= FMAX"));
  expect(print(withPrompt(program, 2, "Q1790", "7"))).toBe(TEXT.replace("Q1790=-4", "Q1790=+7"));
  const grip = print(withPrompt(program, 2, "Q1712", "1"));
  expect(grip.replaceAll(/\s+/g, " ")).toContain("~ Q1712=+1 ;GRIP ~ Q1713");
  expect(parse(grip).blocks).toHaveLength(4);
});

/** The dialog with what is typed into it. */
function Typed() {
  const [draft, setDraft] = useState<Record<string, string>>({});
  const block = readingOfOwn(program, 2, draft, cycles());
  const problems = (block?.issues ?? []).map((issue) => entryAt(issue, issue.at ?? null, 2));
  return (
    block && <OwnDialog block={block} problems={problems} set={(q, text) => setDraft((d) => ({ ...d, [q]: text }))} />
  );
}

test("it asks one prompt at a time with range and choices, offers the nearest value, and says that the cycle is not simulated", async () => {
  openPrompt("Q1711", "31.7");
  render(<Typed />);
  const user = userEvent.setup();
  expect(screen.getByRole("heading", { name: "PULL LENGTH" })).toBeTruthy();
  expect(screen.getByText(t.dialog.range("0.5", "187.25"))).toBeTruthy();
  expect(screen.getByText(t.editor.ownUnproved)).toBeTruthy();
  expect(screen.getByText(t.own.unprovedLong)).toBeTruthy();
  await user.keyboard("200");
  await user.click(screen.getByRole("button", { name: t.dialog.takeNearest("187.25") }));
  expect(screen.getByRole<HTMLInputElement>("textbox").value).toBe("187.25");
  await user.keyboard("{Enter}");
  expect(screen.getByRole("heading", { name: "GRIP" })).toBeTruthy();
  await user.click(screen.getByRole("radio", { name: /closed/ }));
  await user.keyboard("{Enter}");
  expect(screen.getByRole("button", { name: t.dialog.autoLong })).toBeTruthy();
  await user.keyboard("{Enter}");
  expect(screen.getByText(t.own.notDescribed)).toBeTruthy();
});
