import { cleanup, fireEvent, render, screen } from "@testing-library/react";
import { afterEach, beforeEach, expect, test } from "vitest";
import { cycleByNumber } from "../cycles/index.ts";
import { never } from "../kernel/never.ts";
import { exampleJob } from "../program/job/job.ts";
import { changeSettings } from "../app/base/settings/settings.ts";
import { open } from "../app/document/store.ts";
import { useOpenCall } from "../app/place/open-call.ts";
import { HelpMenu } from "./HelpMenu.tsx";

const job = exampleJob(cycleByNumber(852) ?? never("no such cycle"));
const program = { name: "TWO.H", text: "0 BEGIN PGM TWO MM\n1 END PGM TWO MM\n", encoding: "utf-8" as const };

/** Addresses in the opened menu. */
function openMenu(): readonly (string | null)[] {
  render(<HelpMenu />);
  fireEvent.click(screen.getByRole("button", { name: "Help" }));
  return screen.getAllByRole("menuitem", { hidden: true }).flatMap((item) => item.getAttribute("href") ?? []);
}

beforeEach(() => {
  changeSettings({ language: "en" });
  useOpenCall.setState({ call: null });
  open(null, null);
});
afterEach(cleanup);

const ALWAYS = ["#/guide", "#/guide/advice", "#/glossary", "#/course"];

test("without a work it leads to the guide, cutting data, glossary and course", () => {
  expect(openMenu()).toEqual(ALWAYS);
});

test("on a phone it is the header's menu: the buttons that have no room come first, the guide follows", () => {
  let shown = 0;
  render(<HelpMenu folded={[{ name: "Settings", icon: "settings", go: () => (shown += 1) }]} />);
  fireEvent.click(screen.getByRole("button", { name: "Menu" }));
  const [first, ...others] = screen.getAllByRole("menuitem", { hidden: true });
  expect(others.slice(0, ALWAYS.length).map((item) => item.getAttribute("href"))).toEqual(ALWAYS);
  if (first) fireEvent.click(first);
  expect([first?.textContent, shown]).toEqual(["Settings", 1]);
});

test("with a job, to the steps of its cycle", () => {
  open(job, "w");
  expect(openMenu()).toEqual(["#/guide/852", ...ALWAYS]);
});

test("in a program, to the cycle whose block was open last there", () => {
  open(program, "w");
  useOpenCall.setState({ call: { work: "w", cycle: 812, line: 7 } });
  expect(openMenu()).toEqual(["#/guide/812", ...ALWAYS]);
});

test("a block of another program does not count", () => {
  open(program, "w");
  useOpenCall.setState({ call: { work: "other", cycle: 812, line: 7 } });
  expect(openMenu()).toEqual(ALWAYS);
});
