import { cleanup, fireEvent, render, screen, waitFor, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { useState } from "react";
import { afterEach, beforeAll, expect, test } from "vitest";
import { catalogue } from "../../cycles/index.ts";
import { exampleJob, newRow, type ContourRow } from "../../program/job/job.ts";
import { fetchTexts } from "../../app/base/settings/loaded-texts.ts";
import { createDeferredStore } from "../../app/base/typing.ts";
import { chooseElement } from "../../app/place/contour-place.ts";
import { ContourTable } from "./ContourTable.tsx";

beforeAll(() => fetchTexts("en"));
afterEach(() => {
  cleanup();
  chooseElement(null);
});

const example = () => {
  const cycle = catalogue.find((c) => c.contour === "free" && c.evidence === "A");
  return cycle ? exampleJob(cycle).contour : [];
};

/** The table with a state of its own; `last` holds the rows after the newest change. */
function shown(start: readonly ContourRow[] = example()) {
  const last = { rows: start, places: [] as (string | null)[] };
  function Page() {
    const [rows, setRows] = useState(start);
    const take = (next: readonly ContourRow[], place: string | null) => {
      last.rows = next;
      last.places.push(place);
      setRows(next);
    };
    return <ContourTable rows={rows} onChange={take} language="en" />;
  }
  render(<Page />);
  return last;
}
const field = (name: string) => screen.getByRole<HTMLInputElement>("textbox", { name });

test("every element is a row whose fields have names, and omitted coordinates say what they stay at", () => {
  shown();
  expect(within(screen.getByRole("table", { name: "Contour subprogram" })).getAllByRole("row")).toHaveLength(7);
  expect(field("Element 1, X diameter").value).toBe("75");
  const omitted = field("Element 2, Z");
  expect(omitted.placeholder).toBe("-20");
  expect(document.getElementById(omitted.getAttribute("aria-describedby")?.split(" ")[1] ?? "")?.textContent).toBe(
    "-20",
  );
});

test("a sign that was just typed is as good as an empty field until it is left", async () => {
  const user = userEvent.setup();
  shown();
  const at = field("Element 4, X diameter");
  const said = () => [
    at.value,
    at.getAttribute("aria-invalid"),
    screen.queryByRole("list", { name: "Contour errors" })?.textContent,
  ];
  await user.clear(at);
  const empty = said();
  await user.type(at, "-");
  expect(said()).toEqual(["-", ...empty.slice(1)]);
  await user.type(at, "x");
  expect(said()[1]).toBe("true");
  await user.keyboard("{Backspace}");
  expect(said()).toEqual(["-", ...empty.slice(1)]);
  await user.tab();
  expect(said()[1]).toBe("true");
  expect(said()[2]).toContain("4! “-” is not a number.");
});

test("typing names its field for undo, and a sum is evaluated on leaving the field", async () => {
  const user = userEvent.setup();
  const last = shown();
  await user.clear(field("Element 4, X diameter"));
  await user.type(field("Element 4, X diameter"), "10+5/2");
  expect(new Set(last.places)).toEqual(new Set([`${last.rows[3]?.id} x`]));
  await user.tab();
  expect(last.rows[3]?.x).toBe("12.5");
});

test("keys: enter goes to the next field, arrows change the row, I makes incremental, alt and arrows move", async () => {
  const user = userEvent.setup();
  const last = shown();
  await user.click(field("Element 1, X diameter"));
  await user.keyboard("{Enter}");
  expect(document.activeElement).toBe(field("Element 1, Z"));
  await user.keyboard("{ArrowDown}i");
  expect(document.activeElement).toBe(field("Element 2, Z"));
  expect(last.rows[1]?.incrementalZ).toBe(true);
  await user.keyboard("{Alt>}{ArrowDown}{/Alt}");
  expect(last.rows.map((r) => r.kind)).toEqual(["L", "RND", "L", "L", "RND", "L"]);
  expect(document.activeElement).toBe(field("Element 3, Z"));
});

test("keys: insert, duplicate and delete; enter behind the last field adds an element", async () => {
  const user = userEvent.setup();
  const last = shown();
  await user.click(field("Element 6, Z"));
  await user.keyboard("{Enter}-5");
  expect(last.rows).toHaveLength(7);
  expect(last.rows[6]?.x).toBe("-5");
  await user.keyboard("{Control>}d{/Control}");
  expect(last.rows).toHaveLength(8);
  await user.keyboard("{Control>}{Delete}{/Control}{Control>}{Delete}{/Control}");
  expect(last.rows).toHaveLength(6);
  await user.keyboard("{Insert}");
  expect(last.rows[5]?.x).toBe("");
  expect(screen.getByRole("status").textContent).toBe("Element added");
});

test("buttons name the element they change", async () => {
  const user = userEvent.setup();
  const last = shown();
  await user.click(field("Element 3, radius"));
  await user.click(screen.getByRole("button", { name: "Delete element 3" }));
  expect(last.rows.map((r) => r.kind)).toEqual(["L", "L", "L", "RND", "L"]);
  await user.click(screen.getByRole("button", { name: "Move element 3 up" }));
  expect(last.rows[1]?.x).toBe("20");
});

test("a fault is shown at its field and in the drawing", async () => {
  const user = userEvent.setup();
  shown();
  await user.clear(field("Element 3, radius"));
  expect(field("Element 3, radius").getAttribute("aria-invalid")).toBe("false");
  await user.type(field("Element 3, radius"), "200");
  expect(field("Element 3, radius").getAttribute("aria-invalid")).toBe("true");
  const wrong = field("Element 3, radius").getAttribute("aria-describedby") ?? "";
  expect(document.getElementById(wrong)?.textContent).toContain("200");
  expect(document.querySelectorAll(".contour-drawing .faulty").length).toBeGreaterThan(0);
  expect(screen.getByRole("img").getAttribute("aria-label")).toBe(
    "Drawing of the contour with 6 elements, element 3 is highlighted",
  );
});

test("minus anywhere in a number changes its sign", async () => {
  const user = userEvent.setup();
  const last = shown();
  const z = field("Element 4, Z");
  await user.click(z);
  z.setSelectionRange(3, 3);
  await user.keyboard("-");
  expect(last.rows[3]?.z).toBe("25");
});

test("a new element is selected and asks for values without red before the first digit", async () => {
  const user = userEvent.setup();
  shown([]);
  await user.click(screen.getByRole("button", { name: "Add element" }));
  expect(document.activeElement).toBe(field("Element 1, X diameter"));
  expect(document.querySelectorAll(".field-message.error, [aria-invalid=true]")).toHaveLength(0);
  await user.keyboard("17.4");
  expect(field("Element 1, Z").getAttribute("aria-invalid")).toBe("true");
  await user.click(screen.getByRole("button", { name: "Add element" }));
  expect(document.querySelector("tr.active .contour-number")?.textContent).toBe("2");
});

test("an empty table asks for the start point", async () => {
  const user = userEvent.setup();
  const last = shown([]);
  await user.click(screen.getByRole("button", { name: "Add element" }));
  expect(last.rows).toHaveLength(1);
});

test("polar elements have distance and angle with an I key each, and say what they stay at", async () => {
  const user = userEvent.setup();
  const last = shown([
    newRow("e1", { x: "20", z: "0" }),
    newRow("e2", { kind: "CC", x: "20", z: "-30" }),
    newRow("e3"),
  ]);
  await user.selectOptions(screen.getByRole("combobox", { name: "Element 3, kind" }), "LP");
  expect(field("Element 3, polar radius PR").placeholder).toBe("30");
  await user.type(field("Element 3, polar angle PA"), "60");
  expect(last.rows[2]).toMatchObject({ kind: "LP", words: { PA: "60" } });
  await user.keyboard("i");
  expect(last.rows[2]?.words).toEqual({ IPA: "60" });
  await user.selectOptions(screen.getByRole("combobox", { name: "Element 3, kind" }), "CP");
  expect(screen.queryByRole("textbox", { name: "Element 3, polar radius PR" })).toBeNull();
  expect(screen.getByRole("combobox", { name: "Element 3, direction of rotation" })).toBeTruthy();
});

test("a polar element without a pole says so, also under the drawing", () => {
  shown([newRow("e1", { x: "20", z: "0" }), newRow("e2", { kind: "LP", words: { PR: "30", PA: "0" } })]);
  expect(screen.getAllByText("The block requires a pole CC before it.", { exact: false })).toHaveLength(2);
});

/** A table so long that its digits are painted before the table gets them. */
function shownLong() {
  const begun = Array.from({ length: 120 }, (_, i) => newRow(`e${i}`, { x: String(10 + i), z: String(-i) }));
  const useRows = createDeferredStore<{ readonly rows: readonly ContourRow[] }>(() => ({ rows: begun }));
  const Table = () => (
    <ContourTable
      rows={useRows((s) => s.rows)}
      onChange={(rows) => useRows.setState({ rows })}
      language="en"
      isDrawingElsewhere
    />
  );
  render(<Table />);
  return () => useRows.getState().rows;
}

test("in a long table a digit is in its field at once, and the other rows stay unchanged", async () => {
  const rows = shownLong(),
    before = rows(),
    x = field("Element 60, X diameter");
  fireEvent.change(x, { target: { value: "705" } });
  fireEvent.change(x, { target: { value: "70" } });
  fireEvent.change(x, { target: { value: "704" } });
  expect([x.value, rows()[59]?.x]).toEqual(["704", "704"]);
  await expect.poll(() => x.getAttribute("value")).toBe("704");
  expect(rows().filter((row, i) => row !== before[i])).toHaveLength(1);
});

test("in a long table a letter right after a digit loses nothing: I, and C for a corner", () => {
  const rows = shownLong(),
    x = field("Element 60, X diameter");
  fireEvent.focus(x);
  fireEvent.change(x, { target: { value: "7" } });
  fireEvent.keyDown(x, { key: "i" });
  expect(rows()[59]).toMatchObject({ x: "7", incrementalX: true });
  fireEvent.change(x, { target: { value: "71" } });
  fireEvent.keyDown(x, { key: "c" });
  expect(rows()).toHaveLength(121);
  expect(rows()[59]).toMatchObject({ x: "71", incrementalX: true });
});

test("an undercut is put into a corner and filled by its designation; its words have that name", async () => {
  const user = userEvent.setup();
  const last = shown([newRow("e1", { x: "40", z: "0" }), newRow("e2", { z: "-30" }), newRow("e3", { x: "60" })]);
  await user.click(field("Element 2, Z"));
  await user.click(screen.getByRole("button", { name: "Undercut in the corner after element 2" }));
  const name = await screen.findByRole("combobox", { name: "Element 3, undercut by name" });
  await waitFor(() => expect(document.activeElement).toBe(name));
  expect(screen.getAllByRole("option", { name: /^DIN 509/ }).length).toBeGreaterThan(6);
  await user.keyboard("freistich f1,2x0,2{Enter}");
  expect(last.rows[2]).toMatchObject({
    kind: "UDC",
    form: "F",
    words: { R: "1.2", DEPTH: "0.2", BREADTH: "2.5", ANGLE: "15", FACEDEPTH: "0.1", FACEANGLE: "8" },
  });
  expect(name.getAttribute("placeholder")).toBe("DIN 509-F 1.2×0.2");
  expect(screen.queryAllByRole("option", { name: /^DIN 509/ })).toEqual([]);
  // A letter of a designation is no command of the table.
  await user.keyboard("DIN 76-C 2");
  expect(last.rows).toHaveLength(4);
  await user.keyboard("{Enter}");
  expect(last.rows[2]).toMatchObject({ form: "THREAD", words: { PITCH: "2", DEPTH: "1.5", BREADTH: "7" } });
});

test("a size typed with its tolerance proposes the middle; a letter of its class is no command", async () => {
  await fetchTexts("en", "cutting-values");
  const user = userEvent.setup();
  const last = shown();
  const at = field("Element 4, X diameter");
  await user.clear(at);
  await user.type(at, "40 c11");
  expect(last.rows).toHaveLength(6);
  expect(at.value).toBe("40 c11");
  await user.clear(at);
  await user.type(at, "40 k6");
  await screen.findByText("40 k6: +0.018 / +0.002 mm. Middle: 40 + (0.018 + 0.002) / 2 = 40.01");
  await user.click(screen.getByRole("button", { name: "Use 40.01" }));
  expect(last.rows[3]?.x).toBe("40.01");
  expect(last.places.at(-1)).toBeNull();
  expect(document.activeElement).toBe(at);
  expect(screen.queryByRole("button", { name: "Use 40.01" })).toBeNull();
  await user.clear(at);
  await user.type(at, "40 h99");
  await screen.findAllByText(/is not a number/);
  expect(screen.queryByRole("button", { name: /^Use / })).toBeNull();
});
