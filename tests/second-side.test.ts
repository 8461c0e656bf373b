import { describe, expect, test } from "vitest";
import { areaOf } from "../src/kernel/area/area.ts";
import { at } from "../src/kernel/geometry/point.ts";
import { parse } from "../src/nc/parse.ts";
import { NC_OUTPUTS } from "../src/program/machine/nc-output.ts";
import { run } from "../src/program/run/run.ts";
import { nextClampingName, secondSide } from "../src/program/edits/second-side.ts";
import { shippedTools } from "../src/program/tools/shipped-tools.ts";
import { leftPieces } from "../src/sim/left-pieces.ts";
import { simulate } from "../src/sim/simulate.ts";

const programs = import.meta.glob<string>("./shop/*.h", { query: "?raw", import: "default", eager: true });
const output = NC_OUTPUTS.mainSpindle;

function turned(name: string, allowance: number): string {
  const program = parse(programs[`./shop/${name}.h`] ?? "");
  const { held } = leftPieces(simulate(run(program, { tools: shippedTools, rapid: 10_000 })));
  return secondSide(program, held ?? [], { allowance, output });
}

describe("the program of the next clamping", () => {
  test.each([
    ["a shaft that is still to be faced", "shaft", 1.5],
    ["a ring with a stepped bore", "flange", 0.75],
    ["face grooves with arcs in their corners", "face-grooves", 0],
    ["a dome and a neck, arcs both", "knob", 0],
    ["a thread, in inches", "thread-inch", 0.508],
    ["a bore with a groove behind its mouth", "stepped-bush", 2],
  ])("%s", async (_, name, allowance) => {
    const text = turned(name, allowance);
    await expect(text).toMatchFileSnapshot(`second-side/${name}.h`);
    const said = run(parse(text), { tools: shippedTools, rapid: 10_000 }).issues.map(({ issue }) => issue);
    expect(said.filter(({ severity }) => severity !== "info")).toEqual([]);
  });

  test("begins like the previous program's turning, without its milling and parameters", () => {
    const first = (...lines: readonly string[]) =>
      secondSide(
        parse(["BEGIN PGM A MM", "BLK FORM CYLINDER Z D40 L60", ...lines, "M30", "END PGM A MM", ""].join("\n")),
        [[at(-60, 0), at(0, 0), at(0, 20), at(-60, 20)]],
        { allowance: 0, output },
      )
        .split("\n")
        .slice(2, 7)
        .filter((line) => !/^(?:L|M30|LBL)/.test(line));
    const spin = "FUNCTION TURNDATA SPIN VCONST:OFF S850";
    expect(
      first(
        "TOOL CALL 30 Z S4000 F200",
        "M136",
        'FUNCTION MODE TURN "AC_TURN"',
        'TOOL CALL "CNMG" DL+0.1',
        spin,
        "TOOL CALL 3",
      ),
    ).toEqual(['FUNCTION MODE TURN "AC_TURN"', 'TOOL CALL "CNMG"', spin, "M136"]);
    expect(first("Q5 = 3", "TOOL CALL Q5", "FUNCTION TURNDATA SPIN VCONST:ON VC:Q7 SMAX2500")).toEqual([
      "FUNCTION MODE TURN",
    ]);
  });

  test("without remaining stock there is no program", () => {
    expect(secondSide(parse("BEGIN PGM A MM\nEND PGM A MM\n"), [], { allowance: 0, output })).toBe("");
  });

  test("a closed cavity stays one", () => {
    const program = parse("BEGIN PGM A MM\nM30\nEND PGM A MM\n");
    const ring = (z0: number, r0: number, z1: number, r1: number) =>
      parse(`BEGIN PGM B MM\nBLK FORM CYLINDER Z R${r1} L${z1 - z0} DIST${z1} RI${r0}\nM30\nEND PGM B MM\n`);
    const blank = (p: ReturnType<typeof parse>) => run(p, { tools: [], rapid: 1 }).blank;
    const [outer = []] = blank(ring(-60, 0, 0, 20)),
      [inner = []] = blank(ring(-31.7, 6.3, -12.2, 11.1));
    const text = secondSide(program, [outer, [...inner].reverse()], { allowance: 0, output });
    expect(areaOf(blank(parse(text)))).toBeCloseTo(60 * 20 - 19.5 * 4.8, 6);
    expect(text).not.toMatch(/^\d/m);
  });

  test("is named after the previous program", () => {
    expect(["PART", "PART_2", "PART_50", "A".repeat(32)].map(nextClampingName)).toEqual([
      "PART_2",
      "PART_3",
      "PART_50_2",
      `${"A".repeat(30)}_2`,
    ]);
    expect(turned("shaft", 0)).toMatch(/^0 BEGIN PGM SHAFT_50_2 MM\n/);
  });
});
