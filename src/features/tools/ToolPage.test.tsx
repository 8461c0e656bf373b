import { useNotices } from "../../app/base/notices.ts";
import { cleanup, render, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { afterEach, beforeAll, beforeEach, expect, test, vi } from "vitest";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { cellOf, tableOrigin } from "../../program/tools/tool-entry.ts";
import { shippedList } from "../../program/tools/tool-list.ts";
import { writeTableText } from "../../program/tools/tool-table-text.ts";
import { declareActions, onActionKey } from "../../app/base/actions.ts";
import { historyActions } from "../../app/document/history.ts";
import { fetchShownTexts } from "../../app/base/settings/use-texts.ts";
import { changeSettings } from "../../app/base/settings/settings.ts";
import { asideRows } from "../../app/base/set-aside.ts";
import { undo, historyOf } from "../../app/document/steps.ts";
import { showToolKind, showTools, usePlace } from "../../app/place/place.ts";
import { showToolNumber } from "../../app/document/tool-row.ts";
import { editTools, toolRecord, toolsOnDevice, useTools } from "../../app/document/tool-store.ts";
import { toolTable } from "../../app/document/work-tools.ts";
import { ToolPage } from "./ToolPage.tsx";

const field = (name: string) => screen.getByRole<HTMLInputElement>("textbox", { name });
const list = () => useTools.getState().list;
const row = (n: number) => list().find((entry) => entry.id === `r${n}`);
const steps = () => historyOf("tools").past.length;

// jsdom has no modal dialogs: this stub opens and closes them.
HTMLDialogElement.prototype.showModal = function open(this: HTMLDialogElement) {
  this.open = true;
};
HTMLDialogElement.prototype.close = function close(this: HTMLDialogElement) {
  this.open = false;
};

const fetchAllTexts = () => fetchShownTexts("tables", "tool-files", "tool-sheets", "tool-codes");
beforeAll(fetchAllTexts);
beforeEach(() => {
  changeSettings({ language: "en" });
  localStorage.removeItem("turnwise/tools");
  localStorage.removeItem("turnwise/tools/damaged");
  useNotices.setState({ notices: [] });
  toolRecord.replace(shippedList);
  showTools();
  showToolKind("turning");
});
afterEach(cleanup);

test("typing in one cell is one step of undo, and other tools stay as they are", async () => {
  render(<ToolPage />);
  const user = userEvent.setup();
  await user.clear(field("RS: tool nose radius"));
  await user.type(field("RS: tool nose radius"), "1.25");
  expect(toolTable().tools[0]?.RS).toBe(1.25);
  expect(toolTable().tools.slice(1)).toEqual(shippedTools.slice(1));
  expect(steps()).toBe(1);
  undo("tools");
  expect(toolTable().tools).toEqual(shippedTools);
});

test("the history keys work on the table while it is shown, and open the changed row", async () => {
  render(<ToolPage />);
  const undeclare = declareActions(historyActions);
  document.addEventListener("keydown", onActionKey);
  const user = userEvent.setup();
  await user.type(field("NAME: tool name"), "x");
  expect(cellOf(row(1) ?? shippedList[0]!, "NAME")).toBe("CNMG-80-R08X");
  await user.click(screen.getByRole("button", { name: "Edit tool 4 VNMG-35-R04" }));
  await user.keyboard("{Control>}z{/Control}");
  expect(row(1)).toEqual(shippedList[0]);
  expect(usePlace.getState().tools.row).toBe("r1");
  document.removeEventListener("keydown", onActionKey);
  undeclare();
});

test("an invalid cell is marked at its column, refused for programs, and its last valid insert stays", async () => {
  render(<ToolPage />);
  const user = userEvent.setup();
  await user.clear(field("P-ANGLE: point angle"));
  await user.type(field("P-ANGLE: point angle"), "85");
  expect(field("P-ANGLE: point angle").getAttribute("aria-invalid")).toBe("true");
  const described = field("P-ANGLE: point angle")
    .getAttribute("aria-describedby")
    ?.split(" ")
    .map((id) => document.getElementById(id)?.textContent ?? "")
    .join(" ");
  expect(described).toContain("The value must be less than 85.");
  expect(within(screen.getByRole("figure")).getByText(/Last valid insert/)).toBeTruthy();
  expect([...toolTable().refused.keys()]).toEqual([1]);
  expect(screen.getByText("1 with an error")).toBeTruthy();
});

test("columns unused by a type are read-only and keep their values", async () => {
  render(<ToolPage />);
  const user = userEvent.setup();
  await user.selectOptions(screen.getByRole("combobox", { name: "TYPE: tool type" }), "BUTTON");
  for (const name of [
    "T-ANGLE: setting angle",
    "P-ANGLE: point angle",
    "CUTLENGTH: edge length",
    "CUTWIDTH: edge width",
    "DCW: oversize of the width",
  ])
    expect(field(name).disabled).toBe(true);
  expect(field("T-ANGLE: setting angle").value).toBe("95");
  await user.selectOptions(screen.getByRole("combobox", { name: "TYPE: tool type" }), "ROUGH");
  expect(toolTable().tools).toEqual(shippedTools);
});

test("TO by arrow keys goes in the direction of the arrow", async () => {
  render(<ToolPage />);
  const user = userEvent.setup();
  screen.getByRole("radio", { name: "TO 1: −Z −X" }).focus();
  await user.keyboard("{ArrowUp}");
  expect(toolTable().tools[0]?.TO).toBe(8);
  await user.keyboard("{ArrowRight}");
  expect(toolTable().tools[0]?.TO).toBe(9);
  await user.keyboard("{ArrowUp}{ArrowRight}");
  expect(toolTable().tools[0]?.TO).toBe(5);
});

test("numbers are shown in the format of the screen language", async () => {
  changeSettings({ language: "de" });
  await fetchAllTexts();
  render(<ToolPage />);
  const user = userEvent.setup();
  expect(field("RS: Schneidenradius").value).toBe("0,8");
  await user.clear(field("RS: Schneidenradius"));
  await user.type(field("RS: Schneidenradius"), "1,2/2{Tab}");
  expect(toolTable().tools[0]?.RS).toBe(0.6);
});

test("a file is imported as one step, and missing values are reported", async () => {
  render(<ToolPage />);
  const user = userEvent.setup();
  const text = writeTableText(shippedTools.slice(0, 2)).replace("CNMG", "SHOP").replace("[END]", "77      HALF");
  await screen.findByRole("button", { name: /^Import tools/ });
  const input = document.querySelector<HTMLInputElement>("input[type=file]");
  await user.upload(input as HTMLInputElement, new File([text], "T.TRN"));
  const all = await screen.findByRole("button", { name: "Import all (3)" });
  expect(screen.getByText("NAME CNMG-80-R08 → SHOP-80-R08")).toBeTruthy();
  expect(document.activeElement).toBe(all);
  await user.keyboard("{Enter}");
  await vi.waitFor(
    () => expect(screen.getByText(/T\.TRN: 1 new, 1 changed\. 1 row has an error\..*\[END\] is missing/)).toBeTruthy(),
    {
      timeout: 60_000,
    },
  );
  expect(toolTable().tools[0]?.NAME).toBe("SHOP-80-R08");
  expect(steps()).toBe(1);
  await user.click(
    within(screen.getByText(/T\.TRN/).closest("p") as HTMLElement).getByRole("button", { name: /^Undo – / }),
  );
  expect(toolTable().tools).toEqual(shippedTools);
});

test("the row of a tool is opened by its number", () => {
  showToolNumber(8);
  render(<ToolPage />);
  expect(field("NAME: tool name").value).toBe("FACE-RECTURN-3");
  showTools();
  expect(usePlace.getState().tools.row).toBe("r8");
});

test("the stored table is loaded; the default table is not stored, so that it can be improved later", () => {
  const changed = list().map((entry) =>
    entry.id === "r2" ? { ...entry, cells: { ...entry.cells, RS: "abc" } } : entry,
  );
  expect(toolRecord.read(toolRecord.write(changed))).toEqual(changed);
  for (const damaged of [
    undefined,
    [],
    { version: 3, rows: [] },
    { version: 0, rows: [] },
    { rows: [] },
    { version: 1, rows: null },
  ])
    expect(toolRecord.read(damaged)).toBeNull();
  // A row that is damaged, or there twice, costs itself only.
  const plain = (id: string, T: string) => ({ id, cells: { T } });
  const partly = { version: 2, rows: [plain("a", "31"), { id: "b", cells: { RS: 1 } }, plain("a", "33")] };
  expect(toolRecord.read(partly)).toEqual([plain("a", "31")]);
  expect(toolRecord.unread(partly).map(({ raw }) => raw)).toEqual(partly.rows.slice(1));
  expect(toolRecord.read({ version: 1, rows: [] })).toEqual([]);
  const bare = shippedList.map(
    ({ id, cells: { width: _w, length: _l, offsetZ: _z, offsetX: _x, axis: _a, head: _h, ...cells } }) => ({
      id,
      cells,
    }),
  );
  const [first, second, ...others] = bare;
  const older = [first, { ...second, cells: { ...second?.cells, RS: "0.85" } }, ...others];
  const [one, two, ...rest] = toolRecord.read({ version: 1, rows: older }) ?? [];
  expect([one, ...rest]).toEqual([shippedList[0], ...shippedList.slice(2)]);
  expect(two).toEqual(older[1]);
  expect(toolRecord.read({ version: 2, rows: older })).toEqual(older);
});

test("changes are stored on the device, damaged tables are set aside, other tabs are followed", () => {
  const fromOtherTab = (newValue: string) =>
    dispatchEvent(new StorageEvent("storage", { key: "turnwise/tools", newValue, storageArea: localStorage }));
  localStorage.setItem("turnwise/tools", "{broken");
  fromOtherTab("{broken");
  expect(useNotices.getState().notices).toEqual(["toolsDamaged"]);
  expect(asideRows()).toEqual([{ record: "tools", at: 0, name: "tools", raw: "{broken" }]);
  expect(localStorage.getItem("turnwise/tools")).toBeNull();
  expect(list()).toEqual(shippedList);
  const changed = shippedList.slice(0, 3);
  toolRecord.put(changed);
  dispatchEvent(new Event("pagehide"));
  expect(toolRecord.read(JSON.parse(localStorage.getItem("turnwise/tools") ?? ""))).toEqual(changed);
  editTools((rows) => rows.slice(0, 2));
  const foreign = shippedList.slice(0, 5);
  fromOtherTab(JSON.stringify(toolRecord.write(foreign)));
  expect(list()).toEqual(foreign);
  expect(steps()).toBe(0);
  expect(toolsOnDevice(list()).table.tools).toEqual(shippedTools.slice(0, 5));
  toolRecord.put(shippedList);
  dispatchEvent(new Event("pagehide"));
  expect(localStorage.getItem("turnwise/tools")).toBeNull();
});

test("a drill shows only the columns it uses, is listed among the milling tools, and gives programs its point", async () => {
  render(<ToolPage />);
  const user = userEvent.setup();
  await user.click(screen.getByRole("button", { name: "Milling and drilling" }));
  await user.click(screen.getByRole("button", { name: "New tool" }));
  await user.selectOptions(screen.getByRole("combobox", { name: "TYPE: tool type" }), "DRILL");
  const names = screen
    .getAllByRole<HTMLInputElement>("textbox")
    .map((each) => each.getAttribute("aria-label")?.split(":")[0]);
  expect(names).toEqual(["T", "NAME", "R", "DR", "L", "DL", "T-ANGLE", "LCUTS", "PL"]);
  await user.type(field("R: tool radius"), "4,25");
  await user.type(field("T-ANGLE: point angle"), "118");
  await user.type(field("LCUTS: edge length"), "47");
  expect(toolTable().mills).toEqual([{ T: 16, NAME: "", TYPE: "DRILL", R: 4.25, "T-ANGLE": 118, LCUTS: 47 }]);
  expect(screen.getByRole("figure", { name: "Tool to scale" }).textContent).toContain("8.5 mm · 118°");
  await user.selectOptions(screen.getByRole("combobox", { name: "TYPE: tool type" }), "TAP");
  await user.type(field("PITCH: thread pitch"), "1.25");
  expect(toolTable().mills).toEqual([{ T: 16, NAME: "", TYPE: "TAP", R: 4.25, LCUTS: 47, PITCH: 1.25 }]);
  await user.selectOptions(screen.getByRole("combobox", { name: "TYPE: tool type" }), "MILL");
  expect(screen.queryByRole("textbox", { name: "PITCH: thread pitch" })).toBeNull();
  expect(toolTable().mills).toEqual([{ T: 16, NAME: "", R: 4.25 }]);
});

test("a code is parsed at each keystroke, and Enter fills its columns as one step", async () => {
  render(<ToolPage />);
  const user = userEvent.setup();
  await user.click(screen.getByRole("button", { name: "New tool" }));
  const code = await screen.findByRole<HTMLInputElement>("textbox", { name: "Code of insert or holder" });
  const before = steps();
  await user.type(code, "dnmg 15 06 08");
  const said = within(screen.getByRole("list", { name: "Meaning of the code" }))
    .getAllByRole("listitem")
    .map((item) => item.textContent);
  expect(said[0]).toBe("D Shape: rhombic, 55°");
  expect(said[6]).toBe("08 Corner radius: 0.8 mm");
  await user.type(code, "{Enter}");
  expect(steps()).toBe(before + 1);
  expect(code.value).toBe("");
  await user.type(code, "PDJNL 2525M15{Enter}");
  expect(toolTable().tools.at(-1)).toMatchObject({
    T: 16,
    NAME: "DNMG150608",
    TYPE: "ROUGH",
    TO: 3,
    RS: 0.8,
    "T-ANGLE": 93,
    "P-ANGLE": 55,
    CUTLENGTH: 15.5,
    holder: { width: 25, offsetZ: -7 },
  });
  undo("tools");
  undo("tools");
  expect(toolTable().tools.at(-1)?.NAME).toBe("FACE-DNMG-55-R08");
});

test("an unsupported code says so, one that contradicts the row too, and a name that is a code can be parsed", async () => {
  render(<ToolPage />);
  const user = userEvent.setup();
  const code = await screen.findByRole<HTMLInputElement>("textbox", { name: "Code of insert or holder" });
  await user.type(code, "GTN-3");
  expect(screen.getByText(/of this family is not known/)).toBeTruthy();
  await user.type(code, "{Escape}PDJNR 2525M15");
  expect(screen.getByText("P-ANGLE is 80°; the holder takes inserts of 55°. P-ANGLE unchanged.")).toBeTruthy();
  await user.type(code, "{Escape}");
  await user.clear(field("NAME: tool name"));
  await user.type(field("NAME: tool name"), "ccmt 09t304");
  await user.click(screen.getByRole("button", { name: "Read the name CCMT 09T304 as a code" }));
  expect(code.value).toBe("CCMT 09T304");
  expect(
    within(screen.getByRole("list", { name: "Fields to be set" }))
      .getAllByRole("listitem")
      .map((item) => item.textContent),
  ).toEqual(["CUTLENGTH 12 → 9.67", "RS 0.8 → 0.4"]);
});

test("the source file of tools is stored on the device once, with the line of each", () => {
  const origin = tableOrigin("T.TRN", "BEGIN T.TRN MM\r\nträger", "windows-1252");
  const kept = shippedList.map((entry, at) => (at < 2 ? { ...entry, line: { origin, at: at + 2 } } : entry));
  const text = JSON.stringify(toolRecord.write(kept));
  expect(text.split("träger")).toHaveLength(2);
  const read = toolRecord.read(JSON.parse(text));
  expect(read).toEqual(kept);
  expect(read?.[1]?.line?.origin.text).toBe(origin.text);
  expect(JSON.stringify(read)).not.toContain("träger");
  const apart = JSON.parse(JSON.stringify(kept)) as typeof kept;
  expect(toolRecord.read(toolRecord.write(apart))).toEqual(apart.map(({ id, cells }) => ({ id, cells })));
});

test("tools of another system show what is proposed and why, ask for their unit, and undo takes them out", async () => {
  render(<ToolPage />);
  const user = userEvent.setup({ applyAccept: false });
  await screen.findByRole("button", { name: /^Import tools/ });
  const input = document.querySelector<HTMLInputElement>("input[type=file]") as HTMLInputElement;
  await user.upload(input, new File(["T20 P1 D0.03 I85 J25 Q2 ;rough\nT21 P2 D0.1 Q6 ;groove\n"], "tool.tbl"));
  const dialog = await screen.findByRole("dialog", { name: "Import from tool.tbl" });
  expect(await within(dialog).findByText("2 tools from LinuxCNC")).toBeTruthy();
  expect(within(dialog).getByText(/CUTWIDTH 0.1:/).textContent).toContain("D is the nose ⌀ in LinuxCNC");
  expect(within(dialog).getByText("Missing: RS")).toBeTruthy();
  await user.click(within(dialog).getByRole("radio", { name: "inch" }));
  expect(within(dialog).getByText(/CUTWIDTH 2.54:/)).toBeTruthy();
  await user.click(within(dialog).getByRole("button", { name: "Import all (2)" }));
  expect(toolTable().tools.at(-1)).toMatchObject({
    T: 20,
    TYPE: "ROUGH",
    TO: 1,
    RS: 0.381,
    "T-ANGLE": 95,
    "P-ANGLE": 60,
  });
  expect(list().at(-1)?.cells).toMatchObject({ T: "21", TYPE: "RECESS", CUTWIDTH: "2.54" });
  undo("tools");
  expect(toolTable().tools).toEqual(shippedTools);
});

test("the columns of a sheet are assigned once: proposals, words, and the same sheet again", async () => {
  render(<ToolPage />);
  const user = userEvent.setup({ applyAccept: false });
  const file = () => new File(["Nr;Name;Art;Wert;Lage\n61;X;Spezial;0,4;1\n"], "list.csv");
  const input = document.querySelector<HTMLInputElement>("input[type=file]");
  if (!input) throw new Error("no input");
  await screen.findByRole("button", { name: "Paste tools copied from a spreadsheet" });
  await user.upload(input, file());
  const meaning = await screen.findByRole<HTMLSelectElement>("combobox", { name: "Meaning of Wert" });
  expect(meaning.value).toBe("");
  expect(screen.getByRole<HTMLSelectElement>("combobox", { name: "Meaning of Art" }).value).toBe("TYPE");
  await user.selectOptions(meaning, "RS");
  await user.selectOptions(screen.getByRole("combobox", { name: "“Spezial” means" }), "BUTTON");
  await user.selectOptions(screen.getByRole("combobox", { name: "Unit of Wert" }), "diameter, mm");
  await user.click(screen.getByRole("button", { name: "Continue" }));
  await user.click(await screen.findByRole("button", { name: "Import all (1)" }));
  expect(useTools.getState().list.at(-1)?.cells).toEqual({ T: "61", NAME: "X", TYPE: "BUTTON", RS: "0.2", TO: "1" });
  await user.upload(input, file());
  expect(await screen.findByText(/Columns assigned as on \d{4}-/)).toBeTruthy();
  await user.click(screen.getByRole("button", { name: "Change columns" }));
  expect((await screen.findByRole<HTMLSelectElement>("combobox", { name: "Meaning of Wert" })).value).toBe("RS");
});
