import { expect, test } from "vitest";
import { cycleByNumber } from "../../cycles/index.ts";
import { never } from "../../kernel/never.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { degrees, length } from "../../kernel/units.ts";
import { advise, SPINDLE, type Advised } from "./advise.ts";
import { readCuttingTable, usualTable, writeCuttingTable } from "../../program/tools/cutting-table.ts";
import { cuttingForce, cuttingPower, depthForPower, feedForRz, heldDownTo, specificForce } from "./formulas.ts";

const steel = { kc11: 2220, mc: 0.14 };

/* Calculated by hand (logarithms), not by these functions. */
test("the diameter below which a speed limit acts", () => {
  expect(heldDownTo(173, 2350)).toBeCloseTo(23.433, 2);
});

test("Kienzle: the specific force of a thin chip, its force and its power", () => {
  // 0.27^−0.14 = e^(0.14 · 1.30933) = e^0.183307 = 1.20118
  expect(specificForce(steel, 0.27)).toBeCloseTo(2666.6, 0);
  // 2.3 mm · 0.27 mm · 2666.6 N/mm²
  expect(cuttingForce(steel, 2.3, 0.27)).toBeCloseTo(1656.0, 0);
  // 1656 N · 187 m/min / 60 000
  expect(cuttingPower(steel, 2.3, 0.27, 187)).toBeCloseTo(5.161, 2);
  // At 45° the chip is 0.27 · 0.70711 = 0.190919 mm: e^(0.14 · 1.65591) = 1.26090
  expect(cuttingForce(steel, 2.3, 0.27, Math.PI / 4)).toBeCloseTo(1738.3, 0);
  expect(cuttingPower(steel, depthForPower(steel, 7.3, 0.27, 187), 0.27, 187)).toBeCloseTo(7.3, 9);
});

test("the feed for a roughness: √(8 · 0.8 · 6.3 / 1000)", () => {
  expect(feedForRz(6.3, 0.8)).toBeCloseTo(0.200798, 6);
  expect(feedForRz(4.7, 0.37)).toBeCloseTo(0.117949, 5);
});

const tool: Tool = {
  T: 7,
  NAME: "CNMG",
  TYPE: "ROUGH",
  TO: 1,
  RS: length(0.37),
  "T-ANGLE": degrees(95),
  "P-ANGLE": degrees(80),
  CUTLENGTH: length(4.1),
};
const material = usualTable.materials.find(({ id }) => id === "c45") ?? never("no such material");
const calm: Advised = {
  cycle: cycleByNumber(812) ?? never("no such cycle"),
  values: { Q463: 2.1, Q478: 0.29, Q505: 0.11 },
  tool,
  spindle: { kind: "surface", cuttingSpeed: 187, limit: 2950 },
  perRevolution: true,
  depth: 2.07,
  smallest: 43.7,
  largest: 61.3,
  machine: null,
  material,
  table: usualTable,
};
const codes = (change: Partial<Advised>) =>
  advise({ ...calm, ...change }).map(({ code, at, better }) => `${code} ${at} ${String(better)}`);

test("moderate values get no advice; each rule applies on its own", () => {
  expect(codes({})).toEqual([]);
  expect(codes({ depth: 2.74, values: { ...calm.values, Q463: 2.9 } })).toEqual(["depthOverEdge Q463 2.733"]);
  expect(codes({ values: { ...calm.values, Q478: 0.31 } })).toEqual(["feedOverNose Q478 0.296"]);
  expect(codes({ values: { ...calm.values, Q505: 0.19 } })).toEqual(["rough Q505 0.14"]);
  expect(codes({ table: { ...usualTable, power: 4.3 } })).toEqual(["power Q463 1.801"]);
  expect(codes({ smallest: 17.9 })).toEqual([`speedLimited ${SPINDLE} null`]);
  expect(codes({ spindle: { kind: "surface", cuttingSpeed: 187, limit: 0 } })).toEqual([`noLimit ${SPINDLE} null`]);
  expect(codes({ spindle: { kind: "surface", cuttingSpeed: 311, limit: 6000 } })).toEqual([`speedFar ${SPINDLE} 190`]);
});

test("the machine's spindle is limited by power and torque at its slowest speed", () => {
  expect(codes({ machine: { most: 4000 }, table: { ...usualTable, power: 4.3 } })).toEqual(["power Q463 1.801"]);
  expect(codes({ machine: { most: 4000, power: 4.3 } })).toEqual(["power Q463 1.801"]);
  expect(codes({ machine: { most: 4000, power: 11 }, table: { ...usualTable, power: 4.3 } })).toEqual([]);
  // 187 m/min at ⌀61.3 are 971 rpm: 42.3 Nm give 4.3 kW there, 55 Nm 5.6 kW.
  const flat = (torque: number) => ({
    most: 4000,
    power: 11,
    torque: [
      { speed: 0, torque },
      { speed: 4000, torque },
    ],
  });
  expect(codes({ machine: flat(42.3) })).toEqual(["power Q463 1.801"]);
  expect(codes({ machine: flat(55) })).toEqual([]);
  expect(codes({ machine: flat(55), largest: 97.3 })).toEqual(["power Q463 1.475"]);
});

test("unknown values get no advice: feeds per minute, FAUTO, a constant rpm, a parting blade", () => {
  const loud = { Q463: 3.9, Q478: 0.6, Q505: 0.4 };
  expect(codes({ values: loud, perRevolution: false, depth: 2.07 })).toEqual([]);
  expect(codes({ values: { Q463: 2.1, Q478: "auto", Q505: "auto" } })).toEqual([]);
  expect(codes({ spindle: { kind: "constant", speed: 800 }, table: { ...usualTable, power: 1 } })).toEqual([]);
  expect(
    codes({
      tool: { ...tool, TYPE: "RECESS", CUTWIDTH: length(3) },
      values: loud,
      depth: 3.9,
      table: { ...usualTable, power: 99 },
    }),
  ).toEqual([]);
});

test("a shop's table is read back as written, and anything else is refused", () => {
  const own = { power: 7.3, materials: [{ ...material, id: "own", name: "Shaft steel", roughSpeed: 143 }] };
  expect(readCuttingTable(writeCuttingTable(own))).toEqual(own);
  expect(readCuttingTable("{}")).toBeNull();
  expect(readCuttingTable("no table")).toBeNull();
  expect(readCuttingTable(writeCuttingTable({ ...own, power: -1 }))).toBeNull();
  expect(readCuttingTable(writeCuttingTable({ ...own, materials: [...own.materials, ...own.materials] }))).toBeNull();
});

test("the shipped table has every group of ISO 513 and forces that fit its group", () => {
  expect(new Set(usualTable.materials.map(({ group }) => group)).size).toBe(6);
  expect(readCuttingTable(writeCuttingTable(usualTable))).toEqual(usualTable);
  for (const { roughSpeed, finishSpeed, roughFeed, finishFeed } of usualTable.materials) {
    expect(finishSpeed).toBeGreaterThan(roughSpeed);
    expect(finishFeed).toBeLessThan(roughFeed);
  }
});
