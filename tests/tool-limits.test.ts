import { describe, expect, test } from "vitest";
import { verified } from "../scripts/verify.ts";
import { over, readTools } from "../src/program/tools/read-tools.ts";
import { shippedTools } from "../src/program/tools/shipped-tools.ts";

/** The limits that a tool's row states are checked in the stock, at the place where they are exceeded. */

const files = import.meta.glob<string>(["./cases/face-groove-small.h", "./cases/bar-stop-after-part-off.h"], {
  query: "?raw",
  import: "default",
  eager: true,
});
const fileOf = (name: string) => files[`./cases/${name}.h`] ?? "";

const program = (blank: string, tool: number, moves: readonly string[]) =>
  [
    "BEGIN PGM CASE MM",
    `BLK FORM CYLINDER Z ${blank}`,
    "FUNCTION MODE TURN",
    `TOOL CALL ${tool}`,
    "FUNCTION TURNDATA SPIN VCONST:ON VC:100 SMAX1200",
    "M136",
    "L X+200 Z+100 R0 FMAX",
    ...moves,
    "L Z+100 FMAX",
    "M30",
    "END PGM CASE MM",
  ]
    .map((line, i) => `${i} ${line}`)
    .join("\n");

/** A bore of ⌀24 turned to ⌀26, and one that the tool widens behind a mouth of ⌀24. */
const bored = program("D60 L80 DIST+0 DI24", 5, ["L X+26 Z+2 FMAX M303", "L Z-30 F0.2", "L X+24", "L Z+2 FMAX"]);
const chamber = program("D60 L80 DIST+0 DI24", 5, [
  "L X+23 Z+2 FMAX M303",
  "L Z-20 FMAX",
  "L X+28 F0.2",
  "L Z-30 F0.2",
  "L X+23",
  "L Z+2 FMAX",
]);
const groove = (x: number) => program("D60 L80 DIST+0", 10, ["L X+64 Z-20 FMAX M303", `L X+${x} F0.1`, "L X+64 FMAX"]);
const parted = fileOf("bar-stop-after-part-off");
const faced = fileOf("face-groove-small");
/** The same groove opened outwards: from ⌀30 to ⌀40. */
const facedWide = faced.replace("Q491=+20", "Q491=+40").replace("Q493=+12", "Q493=+26");

const row = (T: number, limits: object) => {
  const tool = shippedTools.find((each) => each.T === T);
  return { ...tool, ...limits };
};
const hits = (text: string, tool: object) => {
  const read = readTools(JSON.stringify({ tools: [tool] }));
  if ("problem" in read) throw new Error(read.problem);
  const { issues, proof } = verified("case.h", text, over({ tools: shippedTools }, read));
  return {
    limits: issues.filter(({ code }) => code === "toolLimit").map(({ data }) => data),
    holder: proof.holder,
    reasons: proof.reasons.map(({ kind }) => kind),
  };
};

describe("limits of a tool", () => {
  test.each([
    ["axial groove inside the range", faced, row(8, { DAXN: 18, DAXX: 30 }), null],
    ["axial groove smaller than the blade is made for", faced, row(8, { DAXN: 24, DAXX: 60 }), ["DAXN", 20, 24]],
    ["axial groove larger than the blade is made for", facedWide, row(8, { DAXN: 20, DAXX: 30 }), ["DAXX", 40, 30]],
    ["groove within the cutting depth", groove(48), row(10, { CDX: 6 }), null],
    ["groove deeper than the cutting depth", groove(40), row(10, { CDX: 6 }), ["CDX", 10, 6]],
    ["depth counts in the material, not from the start point", groove(48), row(10, { CDX: 6.1 }), null],
    ["axial groove deeper than the cutting depth", faced, row(8, { CDX: 5 }), ["CDX", 8, 5]],
    ["parted off within the diameter", parted, row(9, { CUTDIA: 32 }), null],
    ["parted off beyond the diameter", parted, row(9, { CUTDIA: 25 }), ["CUTDIA", 30, 25]],
    ["bore wide enough for the bar", bored, row(5, { DMIN: 25 }), null],
    ["bore narrower than the bar needs", bored, row(5, { DMIN: 28 }), ["DMIN", 26, 28]],
    ["the narrowest place behind the tip counts", chamber, row(5, { DMIN: 25 }), ["DMIN", 24, 25]],
    ["a mouth that is wide enough", chamber, row(5, { DMIN: 24 }), null],
    ["nothing is checked of a limit of 0", bored, row(5, { DMIN: 0 }), null],
  ])("%s", (_, text, tool, limit) => {
    const { limits, reasons } = hits(text, tool);
    const found = limits.map((d) => {
      const { column, value, limit: most } = d as { column: string; value: number; limit: number };
      return [column, Math.round(value * 100) / 100, most];
    });
    expect(found).toEqual(limit ? [limit] : []);
    expect(reasons.includes("toolLimit")).toBe(limit !== null);
  });

  test("a stated range of diameters leaves nothing of an axial blade unchecked", () => {
    expect(hits(faced, row(8, {}))).toMatchObject({ holder: "unknown" });
    expect(hits(faced, row(8, { DAXN: 18 }))).toMatchObject({ holder: "unknown" });
    expect(hits(faced, row(8, { DAXN: 18, DAXX: 30 }))).toMatchObject({ holder: "clear" });
  });
});
