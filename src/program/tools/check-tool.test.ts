import { describe, expect, test } from "vitest";
import { checkTool, type ToolRow } from "./check-tool.ts";
import { shippedTools } from "./shipped-tools.ts";

const turning: ToolRow = {
  T: 1,
  NAME: "TURN",
  TYPE: "ROUGH",
  TO: 1,
  RS: 0.8,
  "T-ANGLE": 95,
  "P-ANGLE": 80,
  CUTLENGTH: 12,
};
const recessing: ToolRow = { T: 8, NAME: "GROOVE", TYPE: "RECTURN", TO: 8, RS: 0.2, CUTWIDTH: 3, CUTLENGTH: 35 };
const columns = (row: ToolRow) => checkTool(row).map((found) => found.at);

describe("checkTool", () => {
  test.each(shippedTools.map((tool) => [tool.NAME, tool] as const))("shipped tool %s is sound", (_, tool) =>
    expect(checkTool(tool)).toEqual([]),
  );

  test("RS must be there and not negative", () => {
    expect(columns({ ...turning, RS: -0.1 })).toEqual(["RS"]);
    expect(columns({ ...turning, RS: null })).toEqual(["RS"]);
    expect(columns({ ...turning, RS: 0 })).toEqual([]);
    expect(columns({ ...turning, RS: 0.4, DRS: -0.5 })).toEqual(["DRS"]);
    expect(columns({ ...turning, TYPE: "BUTTON", RS: 0 })).toEqual(["RS"]);
  });

  test("TO must be 1 to 9", () => {
    expect(columns({ ...turning, TO: null })).toEqual(["TO"]);
    expect(columns({ ...turning, TO: 0 })).toEqual(["TO"]);
    expect(columns({ ...turning, TO: 1.5 })).toEqual(["TO"]);
    expect(columns({ ...turning, TO: 9 })).toEqual([]);
  });

  test("CUTWIDTH must be more than twice RS for recessing tools", () => {
    expect(checkTool({ ...recessing, CUTWIDTH: 0.4 })).toMatchObject([
      {
        code: "toolColumn",
        at: "CUTWIDTH",
        data: { value: 0.4, min: 0.4 },
      },
    ]);
    expect(columns({ ...recessing, CUTWIDTH: null })).toEqual(["CUTWIDTH"]);
    expect(columns({ ...recessing, CUTWIDTH: 0.5, DCW: -0.2 })).toEqual(["CUTWIDTH"]);
    expect(columns({ ...recessing, CUTWIDTH: 0.41 })).toEqual([]);
    expect(columns({ ...turning, CUTWIDTH: 0 })).toEqual([]);
  });

  test("T-ANGLE plus P-ANGLE must be less than 180", () => {
    expect(checkTool({ ...turning, "P-ANGLE": 85 })).toMatchObject([{ at: "P-ANGLE", data: { value: 85, max: 85 } }]);
    expect(columns({ ...turning, "P-ANGLE": 84.9 })).toEqual([]);
    expect(columns({ ...turning, "T-ANGLE": null, "P-ANGLE": null })).toEqual([]);
    expect(columns({ ...turning, "T-ANGLE": -1 })).toEqual(["T-ANGLE"]);
  });

  test("TYPE must be known and CUTLENGTH not negative", () => {
    expect(columns({ ...turning, TYPE: "DRILL" })).toEqual(["TYPE"]);
    expect(columns({ ...turning, CUTLENGTH: -1 })).toEqual(["CUTLENGTH"]);
    expect(columns({ ...turning, CUTLENGTH: null })).toEqual([]);
  });

  test("no row makes it throw", () => {
    expect(columns({})).toEqual(["TYPE", "TO", "RS"]);
    expect(columns({ ...turning, RS: NaN, TO: Infinity })).toEqual(["TO", "RS"]);
  });
});
