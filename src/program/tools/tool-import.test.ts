import { describe, expect, test } from "vitest";
import { cellOf, type ToolEntry } from "./tool-entry.ts";
import { planImport, type IncomingTools } from "./tool-import.ts";
import { shippedList } from "./tool-list.ts";
import { readToolFile } from "./tool-table-json.ts";

function incoming(text: string): IncomingTools {
  const read = readToolFile(text);
  if (!("rows" in read)) throw new Error(read.problem);
  const origin = { name: "F", text, encoding: "utf-8" as const };
  return {
    rows: read.rows,
    lines: read.rows.map((_, i) => (read.table ? { origin, at: read.table.lines[i] ?? 0 } : undefined)),
    columns: read.rows.map(() => read.columns),
    names: read.table?.turning ?? new Map(),
  };
}
const of = (list: readonly ToolEntry[], T: string) => list.find((entry) => cellOf(entry, "T") === T) as ToolEntry;
const numbers = (list: readonly ToolEntry[]) => list.map((entry) => cellOf(entry, "T"));

describe("what a file does to the table", () => {
  const sheet =
    "T;NAME;RS;TYPE;TO\n1;CNMG-80-R08;1,2;ROUGH;1\n2;DNMG-55-R08;0,80;ROUGH;1\n31;NEW;x;ROUGH;1\n32;OTHER;0,4;FINISH;3\n";

  test("new, changed from what to what, the same, and with an error", () => {
    const plan = planImport(shippedList, incoming(sheet), "all");
    expect(numbers(plan.fresh)).toEqual(["31", "32"]);
    expect(plan.changed.map(({ tool, cells }) => [cellOf(tool, "T"), cells])).toEqual([
      ["1", [{ cell: "RS", from: "0.8", to: "1.2" }]],
    ]);
    expect(plan.same).toBe(1);
    expect(numbers(plan.wrong)).toEqual(["31"]);
    expect(plan.list).toHaveLength(17);
  });

  test("cells that the file has no column for stay, the holder among them", () => {
    const { list } = planImport(shippedList, incoming(sheet), "all");
    expect(of(list, "1").cells).toEqual({ ...of(shippedList, "1").cells, RS: "1.2" });
  });

  test("a file that has all columns replaces the whole row", () => {
    const json = '{ "tools": [ { "T": 1, "NAME": "BARE", "TYPE": "ROUGH", "TO": 1, "RS": 0.8 } ] }';
    expect(of(planImport(shippedList, incoming(json), "all").list, "1").cells).toEqual({
      T: "1",
      NAME: "BARE",
      TYPE: "ROUGH",
      TO: "1",
      RS: "0.8",
    });
  });

  test("only the new ones: nothing else changes", () => {
    const plan = planImport(shippedList, incoming(sheet), "new");
    expect(plan.list.slice(0, 15)).toEqual(shippedList);
    expect([plan.fresh.length, plan.changed.length, plan.same]).toEqual([2, 0, 0]);
  });

  test("the table of milling tools names turning tools that have no name, and only those", () => {
    const nameless = "BEGIN TOOLTURN.TRN MM\nT  TYPE    TO RS\n61 ROUGH   1  0.8\n62 ROUGH   1  0.8\n[END]\n";
    const { list } = planImport(shippedList, incoming(nameless), "all");
    const tool =
      "BEGIN TOOL.T MM\nT  NAME      L  R  TYP\n1  NOT-THIS  +0 +0 29\n61 VORDREHER +0 +0 29\n" +
      "62           +0 +0 TURN\n7  D16       +0 +8 0\n[END]\n";
    const plan = planImport(list, incoming(tool), "all");
    expect(plan.changed.map(({ tool: changed, cells }) => [cellOf(changed, "T"), cells])).toContainEqual([
      "61",
      [
        {
          cell: "NAME",
          from: "",
          to: "VORDREHER",
        },
      ],
    ]);
    expect(cellOf(of(plan.list, "1"), "NAME")).toBe("CNMG-80-R08");
    expect(cellOf(of(plan.list, "62"), "NAME")).toBe("");
  });
});
