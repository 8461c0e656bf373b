import { expect, test } from "vitest";
import { holderOutlines } from "../../kernel/cutter/holder.ts";
import { radius, toDiameter } from "../../kernel/units.ts";
import { over, readTools, type ShopTools } from "../tools/read-tools.ts";
import { shippedTools } from "../tools/shipped-tools.ts";
import { readList, shippedList } from "../tools/tool-list.ts";
import { standardBars } from "./standard-bars.ts";
import { standardBlades } from "./standard-blades.ts";
import { builtInTools, usualTools } from "./usual-tools.ts";

const bars = readList(standardBars([]).map((cells, i) => ({ id: `b${i}`, cells })));

test.each(bars.table.tools.map((tool) => [tool.NAME, tool] as const))("%s enters its least bore", (_, tool) => {
  // From the tip to the far side of the bar, without the sleeve of a short neck.
  const across = Math.max(...(holderOutlines(tool).at(-1) ?? []).map(({ r }) => -r));
  expect(across).toBeGreaterThan(0);
  expect(across).toBeLessThan(tool.DMIN ?? 0);
});

const blades = readList(standardBlades([]).map((cells, i) => ({ id: `o${i}`, cells })));

test.each([
  ["bar", bars],
  ["blade", blades],
] as const)("every usual %s is a valid tool", (_, { table, rows }) => {
  expect([...table.refused]).toEqual([]);
  expect([...rows.values()].flatMap(({ issues }) => issues.filter(({ severity }) => severity !== "info"))).toEqual([]);
});

test.each(blades.table.tools.map((tool) => [tool.NAME, tool] as const))(
  "%s cuts as deep as its edge says",
  (_, tool) => {
    const [shank, blade] = [holderOutlines(tool).at(-1) ?? [], holderOutlines(tool)[0] ?? []];
    expect(Math.min(...shank.map(({ r }) => r))).toBeCloseTo(tool.CUTLENGTH ?? NaN, 6);
    expect(Math.max(...blade.map(({ z }) => z)) * 2).toBeLessThan(tool.CUTWIDTH ?? 0);
  },
);

test("a table with a shallow parting blade still lacks the deep one", () => {
  const deep = usualTools([]).find(({ cells }) => cells.NAME === "PARTING-3")?.cells ?? {};
  const shallow = { id: "a", cells: { ...deep, T: "1", NAME: "MINE", CUTLENGTH: "30" } };
  const names = (own: Parameters<typeof usualTools>[0]) => usualTools(own).map(({ cells }) => cells.NAME);
  expect(names([shallow])).toContain("PARTING-3");
  expect(names([{ ...shallow, cells: { ...deep, T: "1", NAME: "MINE" } }])).not.toContain("PARTING-3");
});

test("usual tools have numbers and names of their own", () => {
  const { tools, mills = [] } = builtInTools.table;
  const all = [...tools, ...mills];
  expect(new Set(all.map(({ T }) => T)).size).toBe(all.length);
  expect(new Set(all.map(({ NAME }) => NAME)).size).toBe(all.length);
  expect(usualTools(shippedList).map(({ cells }) => Number(cells.T))).toEqual(builtInTools.usual);
});

test("a table that has a tool of the same shape or name lacks it no more", () => {
  const named = (entries: ReturnType<typeof usualTools>) => entries.map(({ cells }) => cells.NAME);
  const own = [
    { id: "a", cells: { T: "1", NAME: "MINE", TYPE: "DRILL", R: "13", "T-ANGLE": "140" } },
    { id: "b", cells: { T: "2", NAME: "TAP-M8", TYPE: "TAP", R: "4", PITCH: "1.25" } },
  ];
  const lacked = named(usualTools([])).filter((name) => !named(usualTools(own)).includes(name));
  expect(lacked).toEqual(["DRILL-D26", "TAP-M8"]);
  expect(named(usualTools(shippedList))).not.toContain("BORE-CCMT09T304-A20S");
});

test("a table of the shop replaces shipped drills by number, and the others stay", () => {
  const own = readTools('{"tools":[{"T":31,"NAME":"MINE","R":3},{"T":37,"NAME":"BAR","TYPE":"ROUGH"}]}') as ShopTools;
  const { mills = [] } = over(builtInTools.table, own);
  expect(mills).toHaveLength((builtInTools.table.mills ?? []).length - 1);
  expect(mills.filter(({ T }) => T === 31 || T === 37).map(({ NAME }) => NAME)).toEqual(["MINE"]);
});

test("a shipped boring bar goes into the hole of the largest drill", () => {
  const bar = shippedTools.find(({ NAME }) => NAME === "BORE-CCMT-80-R04")?.holder;
  // From the tip to the far side of the bar.
  const across = -(bar?.offsetX ?? NaN) + (bar?.width ?? NaN);
  const largest = Math.max(...(builtInTools.table.mills ?? []).flatMap((row) => (row.TYPE === "DRILL" ? [row.R] : [])));
  expect(toDiameter(radius(largest))).toBeGreaterThan(across + 1);
});
