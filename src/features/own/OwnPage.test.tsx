import { useNotices } from "../../app/base/notices.ts";
import { cleanup, render, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { parse } from "../../nc/parse.ts";
import { newParameter, OWN_SIZES, type OwnEntry } from "../../program/edits/own-cycle.ts";
import { declareActions, onActionKey } from "../../app/base/actions.ts";
import { historyActions } from "../../app/document/history.ts";
import { changeSettings } from "../../app/base/settings/settings.ts";
import { asideRows } from "../../app/base/set-aside.ts";
import { redo, undo, historyOf } from "../../app/document/steps.ts";
import { describeBlock } from "../../app/fields/blocks/own-edits.ts";
import { importOwnFile } from "./own-files.ts";
import { showOwn, usePlace } from "../../app/place/place.ts";
import { editOwn, ownRecord, useOwn } from "../../app/document/own-store.ts";
import { OwnPage } from "./OwnPage.tsx";
import { texts } from "../../i18n/index.ts";

const t = texts("en").own;
const field = (name: string) => screen.getByRole<HTMLInputElement>("textbox", { name });
const list = () => useOwn.getState().list;
const steps = () => historyOf("own-cycles").past.length;
const entry = (id: string, number: string, name = "BAR PULLER"): OwnEntry => ({
  id,
  number,
  name,
  parameters: [newParameter("p1", { q: "Q1711", prompt: "PULL LENGTH", kind: "length", first: "31.7" })],
});

beforeEach(() => {
  changeSettings({ language: "en" });
  localStorage.removeItem("turnwise/own-cycles");
  localStorage.removeItem("turnwise/own-cycles/damaged");
  useNotices.setState({ notices: [] });
  ownRecord.replace([]);
  showOwn();
  usePlace.setState({ own: { row: null, focus: 0 } });
});
afterEach(cleanup);

test("a cycle is described by keyboard: the number is asked first, Enter goes on, the text shows when all is there", async () => {
  render(<OwnPage />);
  const user = userEvent.setup();
  expect(screen.getByText(t.none)).toBeTruthy();
  await user.click(screen.getByRole("button", { name: t.add }));
  expect(document.activeElement).toBe(field(t.number));
  await user.keyboard("317{Enter}BAR PULLER{Enter}Q1711{Enter}");
  expect(document.activeElement).toBe(screen.getByRole("combobox", { name: `Q1711: ${t.kind}` }));
  await user.selectOptions(screen.getByRole("combobox", { name: `Q1711: ${t.kind}` }), "length");
  expect(screen.queryByRole("figure", { name: t.text })).toBeNull();
  await user.type(field(`Q1711: ${t.cells.prompt}`), "PULL LENGTH");
  await user.type(field(`Q1711: ${t.cells.first}`), "15*2+1.7{Enter}");
  expect(screen.getByRole("figure", { name: t.text }).textContent).toContain(
    "CYCL DEF 317 BAR PULLER ~\nQ1711=+31.7 ;PULL LENGTH",
  );
  await user.keyboard("{Enter}");
  expect(document.activeElement).toBe(field(`Q1712: ${t.cells.q}`));
});

test("a fault is shown at its field, and the list names the unusable cycle", async () => {
  ownRecord.replace([entry("c1", "317"), entry("c2", "812")]);
  showOwn("c2");
  render(<OwnPage />);
  const user = userEvent.setup();
  expect(screen.getByText(t.problems.known("812"))).toBeTruthy();
  expect(
    screen.getByRole("button", { name: `${t.select(t.cycleName("812", "BAR PULLER"))}, ${t.hasError}` }),
  ).toBeTruthy();
  await user.clear(field(t.number));
  await user.type(field(t.number), "317");
  expect(screen.getByText(t.problems.twice("317"))).toBeTruthy();
  expect(field(t.number).getAttribute("aria-invalid")).toBe("true");
});

test("typing in one field is one step of undo; the history keys work here and leave focus where it is", async () => {
  ownRecord.replace([entry("c1", "317")]);
  const undeclare = declareActions(historyActions);
  document.addEventListener("keydown", onActionKey);
  render(<OwnPage />);
  const user = userEvent.setup();
  await user.type(field(t.name), " 2");
  await user.click(screen.getByRole("button", { name: t.addParameter }));
  expect(steps()).toBe(2);
  await user.click(field(t.name));
  await user.keyboard("{Control>}zz{/Control}");
  expect(list()).toEqual([entry("c1", "317")]);
  expect(document.activeElement).toBe(field(t.name));
  redo("own-cycles");
  expect(list()[0]?.name).toBe("BAR PULLER 2");
  document.removeEventListener("keydown", onActionKey);
  undeclare();
});

test("duplicate, delete, and undo next to the status", async () => {
  ownRecord.replace([entry("c1", "317")]);
  render(<OwnPage />);
  const user = userEvent.setup();
  await user.click(screen.getByRole("button", { name: t.duplicateLong(t.cycleName("317", "BAR PULLER")) }));
  expect(list().map(({ number }) => number)).toEqual(["317", "318"]);
  await user.click(screen.getByRole("button", { name: t.removeLong(t.cycleName("318", "BAR PULLER")) }));
  expect(list()).toHaveLength(1);
  const status = screen.getAllByRole("status").find((each) => each.textContent?.includes("318"));
  await user.click(within(status as HTMLElement).getByRole("button", { name: new RegExp(`^${t.undo} – `) }));
  expect(list()).toHaveLength(2);
});

test("parameters are moved and deleted; a choice asks for its values instead of bounds", async () => {
  ownRecord.replace([
    {
      ...entry("c1", "317"),
      parameters: [newParameter("p1", { q: "Q1", prompt: "A" }), newParameter("p2", { q: "Q2", prompt: "B" })],
    },
  ]);
  render(<OwnPage />);
  const user = userEvent.setup();
  await user.click(screen.getByRole("button", { name: t.raise("Q2") }));
  expect(list()[0]?.parameters.map(({ q }) => q)).toEqual(["Q2", "Q1"]);
  await user.click(screen.getByRole("button", { name: t.removeParameter("Q1") }));
  expect(list()[0]?.parameters.map(({ q }) => q)).toEqual(["Q2"]);
  await user.selectOptions(screen.getByRole("combobox", { name: `Q2: ${t.kind}` }), "choice");
  expect(screen.queryByRole("textbox", { name: `Q2: ${t.cells.min}` })).toBeNull();
  expect(field(`Q2: ${t.cells.choices}`)).toBeTruthy();
  undo("own-cycles");
  expect(await screen.findByRole("textbox", { name: `Q2: ${t.cells.min}` })).toBeTruthy();
});

test("a block is described only once", () => {
  const s = parse("CYCL DEF 0317 X ~\nQ5=+1 ;A\n").blocks[0]?.statement;
  if (s?.kind !== "cycle") throw new Error("no cycle");
  expect(describeBlock(s)).toBe("c1");
  expect(describeBlock(s)).toBe("c1");
  expect(list()).toHaveLength(1);
  expect(steps()).toBe(1);
});

test("a file is imported as one step, or not at all", async () => {
  ownRecord.replace([entry("c1", "317")]);
  const file = (text: string) => new File([text], "a.json");
  const said = await importOwnFile(
    file('{"cycles":[{"number":317,"name":"NEW"},{"number":812,"name":"B","depth":1}]}'),
    t,
  );
  expect(said.sentences).toEqual([
    t.files.imported("a.json", 1, 1),
    t.files.importedWrong(1),
    t.files.leftOut("depth"),
  ]);
  expect(list().map(({ id, name }) => `${id} ${name}`)).toEqual(["c1 NEW", "c2 B"]);
  undo("own-cycles");
  expect(list()).toEqual([entry("c1", "317")]);
  expect((await importOwnFile(file("Dear sirs"), t)).sentences).toEqual([t.files.notALibrary("a.json")]);
  const full = Array.from({ length: OWN_SIZES.cycles }, (_, i) => ({ number: 1000 + i, name: "A" }));
  expect((await importOwnFile(file(JSON.stringify({ cycles: full })), t)).sentences).toEqual([
    t.files.tooMany("a.json", OWN_SIZES.cycles),
  ]);
  const big = file(" ");
  vi.spyOn(big, "size", "get").mockReturnValue(2_000_001);
  expect((await importOwnFile(big, t)).sentences).toEqual([t.files.tooLarge("a.json")]);
  expect(list()).toEqual([entry("c1", "317")]);
});

test("stored descriptions are loaded; damaged data are not", () => {
  const own = [entry("c1", "31x"), entry("c2", "317", "")];
  expect(ownRecord.read(ownRecord.write(own))).toEqual(own);
  for (const damaged of [undefined, [], { version: 2, cycles: [] }, { version: 1, cycles: "c1" }])
    expect(ownRecord.read(damaged)).toBeNull();
  // A row that is damaged, or there twice, costs itself only.
  const wrongKind = JSON.parse(JSON.stringify(own[0]).replace('"length"', '"depth"')) as unknown;
  const partly = { version: 1, cycles: [wrongKind, own[1], own[1]] };
  expect(ownRecord.read(partly)).toEqual([own[1]]);
  expect(ownRecord.unread(partly).map(({ raw }) => raw)).toEqual([wrongKind, own[1]]);
});

test("changes are stored on the device, damaged lists are set aside, other tabs are followed", () => {
  const fromOtherTab = (newValue: string) =>
    dispatchEvent(new StorageEvent("storage", { key: "turnwise/own-cycles", newValue, storageArea: localStorage }));
  localStorage.setItem("turnwise/own-cycles", "{broken");
  fromOtherTab("{broken");
  expect(useNotices.getState().notices).toEqual(["ownDamaged"]);
  expect(asideRows()).toEqual([{ record: "own-cycles", at: 0, name: "own-cycles", raw: "{broken" }]);
  expect(localStorage.getItem("turnwise/own-cycles")).toBeNull();
  ownRecord.put([entry("c1", "317")]);
  dispatchEvent(new Event("pagehide"));
  expect(JSON.parse(localStorage.getItem("turnwise/own-cycles") ?? "")).toEqual({
    version: 1,
    cycles: [entry("c1", "317")],
  });
  editOwn(() => [entry("c1", "318")]);
  const foreign = [entry("c7", "320")];
  fromOtherTab(JSON.stringify(ownRecord.write(foreign)));
  expect(list()).toEqual(foreign);
  expect(steps()).toBe(0);
  ownRecord.put([]);
  dispatchEvent(new Event("pagehide"));
  expect(localStorage.getItem("turnwise/own-cycles")).toBeNull();
});
