import { describe, expect, test } from "vitest";
import { nearestWord, unknownToolKeys } from "./tool-keys.ts";
import { readTableJson, writeTableJson } from "./tool-table-json.ts";
import { readTools } from "./read-tools.ts";
import { shippedTools } from "./shipped-tools.ts";

test.each<readonly [object, readonly (readonly [string, string, string | null])[]]>([
  [{ tools: [{ T: 1, Rs: 0.8 }] }, [["tools.0", "Rs", "RS"]]],
  [
    { tools: [{ T: 1, CUTLENGHT: 12, holder: { widht: 25 } }] },
    [
      ["tools.0", "CUTLENGHT", "CUTLENGTH"],
      ["tools.0.holder", "widht", "width"],
    ],
  ],
  [
    { tools: [{ T: 1 }, { T: 2, R: 5, T_ANGLE: 118, holder: null }] },
    [
      ["tools.1", "T_ANGLE", "T-ANGLE"],
      ["tools.1", "holder", null],
    ],
  ],
  [
    { tools: [{ T: 1, COLOUR: "red" }], unit: "mm" },
    [
      ["", "unit", null],
      ["tools.0", "COLOUR", null],
    ],
  ],
  [{ tools: [{ T: 1, R: 2, TYPE: "ROUGH" }] }, [["tools.0", "R", null]]],
])("%j", (json, found) => {
  expect(unknownToolKeys(json).map(({ at, key, nearest }) => [at, key, nearest])).toEqual(found);
});

describe("known keys", () => {
  test("what the page writes has no unknown key", () => {
    const mill = { T: 30, NAME: "D", R: 4, TYPE: "DRILL", "T-ANGLE": 118, LCUTS: 40, PL: 2 } as const;
    expect(unknownToolKeys(JSON.parse(writeTableJson(shippedTools, [mill])))).toEqual([]);
  });
  test.each([null, 5, "x", [], { tools: 5 }, { tools: [null, 5, []] }])("%j has none", (json) => {
    expect(unknownToolKeys(json).filter(({ key }) => key !== "tools")).toEqual([]);
  });
});

test("the import names an unknown key once, with the known one", () => {
  const read = readTableJson('{ "tools": [{ "T": 1, "Rs": 1 }, { "T": 2, "Rs": 1, "holder": { "lenght": 3 } }] }');
  expect(read).toMatchObject({ leftOut: ["Rs (RS?)", "holder.lenght (length?)"] });
});

test("a value of a wrong type is named with its place", () => {
  const text = (row: object) => readTools(JSON.stringify({ tools: [row] }));
  expect(text({ T: 1, TYPE: "ROUGH", RS: "0.8" })).toMatchObject({
    problem: expect.stringMatching(/^tools\.0\.RS: .*number/),
  });
  expect(text({ T: 1, R: "4" })).toMatchObject({ problem: expect.stringMatching(/^tools\.0\.R: .*number/) });
});

test("a word that is far from all has no nearest", () => {
  expect(nearestWord("x".repeat(1000), ["RS"])).toBeNull();
  expect(nearestWord("WEIGHT", ["width", "length"])).toBeNull();
});
