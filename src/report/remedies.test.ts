import { describe, expect, test } from "vitest";
import { degrees, length } from "../kernel/units.ts";
import { parse } from "../nc/parse.ts";
import { run } from "../program/run/run.ts";
import { shippedTools } from "../program/tools/shipped-tools.ts";
import { simulate } from "../sim/simulate.ts";
import { remedies } from "./remedies.ts";

const [rough] = shippedTools;
if (!rough) throw new Error("a tool");
const other = (T: number, RS: number, columns: object = {}) => ({ ...rough, T, RS: length(RS), ...columns });
const tools = [
  rough,
  other(61, 0.2),
  other(63, 0.75),
  other(52, 0.4),
  other(51, 0.2),
  other(64, 0.2, { TO: 5 }),
  other(65, 0.2, { "T-ANGLE": degrees(0) }),
  ...shippedTools.filter(({ TYPE }) => TYPE === "THREAD"),
];

/** A shoulder whose corner keeps the nose radius of the tool; behind a datum shift or not. */
function made(datum: string) {
  const text = [
    "BEGIN PGM S MM",
    "BLK FORM CYLINDER Z D60 L60 DIST+1",
    "FUNCTION MODE TURN",
    `TOOL CALL ${rough?.T}`,
    "FUNCTION TURNDATA SPIN VCONST:OFF S700",
    "M136",
    "L X+70 Z+9 R0 FMAX M303",
    datum,
    "CYCL DEF 811 SHOULDER ~\nQ215=+0 ~\nQ460=+2 ~\nQ493=+50 ~\nQ494=-20 ~\nQ463=+3 ~\nQ478=+0.3 ~\nQ483=+0 ~\nQ484=+0 ~\nQ505=+0.15 ~\nQ506=+0",
    "L X+62 Z+3 FMAX",
    "CYCL CALL",
    "M30",
    "END PGM S MM",
    "",
  ].join("\n");
  const done = run(parse(text), { tools, rapid: 10_000 });
  const [operation] = done.operations;
  if (!operation) throw new Error("an operation");
  return { operation, residual: simulate(done).proof.residual };
}

describe("tools that take what an operation leaves", () => {
  test.each(["", "TRANS DATUM AXIS Z-3"])("are those that leave least of it, the lower number first %s", (datum) => {
    const { operation, residual } = made(datum);
    const left = residual.find(({ reason }) => reason === "insertRadius");
    if (!left) throw new Error("a corner");
    const found = remedies(tools)(operation, left);
    // A nose of 0.75 mm leaves most of the corner of 0.8 mm.
    expect(found.map(({ tool }) => tool.T)).toEqual([51, 61, 52]);
    // What two arcs in a corner leave: (1 − π/4) r².
    for (const { tool, residualArea } of found)
      expect(residualArea).toBeCloseTo((1 - Math.PI / 4) * Number(tool.RS) ** 2, 1);
  });

  test("are asked for once per operation, and for each region", () => {
    const { operation, residual } = made("");
    const left = residual.find(({ reason }) => reason === "insertRadius");
    if (!left) throw new Error("a corner");
    const find = remedies(tools);
    const plans = find(operation, left).length;
    expect(find(operation, left).length).toBe(plans);
    expect(find(operation, { ...left, area: left.area / 100 })).toEqual([]);
    expect(find({ ...operation, cycle: 1 }, left)).toEqual([]);
    expect(find({ ...operation, call: null } as unknown as typeof operation, left)).toEqual([]);
  });

  test("are none for what every tool would leave", () => {
    const { operation, residual } = made("");
    const left = residual.find(({ reason }) => reason === "insertRadius");
    if (!left) throw new Error("a corner");
    const find = remedies(tools);
    const reasons = [
      "limit",
      "oversize",
      "insertRadius",
      "mainEdge",
      "secondaryEdge",
      "toolWidth",
      "cutLength",
    ] as const;
    expect(reasons.filter((reason) => find(operation, { ...left, reason }).length === 0)).toEqual([
      "limit",
      "oversize",
    ]);
  });
});
