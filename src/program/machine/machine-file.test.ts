import { describe, expect, test } from "vitest";
import { EXAMPLE_MACHINE_NAMES, EXAMPLE_MACHINES } from "./example-machines.ts";
import { powerAt } from "./machine-data.ts";
import { MACHINE_FORMAT, machineOf, readMachine, writeMachine } from "./machine-file.ts";
import { NC_OUTPUTS } from "./nc-output.ts";

const read = (file: object) => readMachine(JSON.stringify({ format: MACHINE_FORMAT, name: "A", ...file }));
const problems = (file: object) => {
  const made = read(file);
  return "problems" in made
    ? made.problems.map(({ kind, at, limit }) => [kind, at, ...(limit === undefined ? [] : [limit])].join(" "))
    : [];
};
const torque = (...points: readonly (readonly [number, number])[]) => ({
  spindle: { most: 3000, torque: points.map(([speed, of]) => ({ speed, torque: of })) },
});

describe("a machine file", () => {
  test.each(EXAMPLE_MACHINE_NAMES)("%s comes back as it was written, with its NC output and without", (name) => {
    const machine = EXAMPLE_MACHINES[name];
    expect(readMachine(writeMachine(machine))).toEqual({ machine });
    const whole = { ...machine, output: NC_OUTPUTS.mainSpindle };
    expect(readMachine(writeMachine(whole))).toEqual({ machine: whole });
    expect(machineOf(writeMachine(whole))).toEqual(machine);
  });

  test("a name is enough", () => expect(read({})).toEqual({ machine: { name: "A" } }));

  test.each([
    ["not JSON", "{", "notJson"],
    ["a list", "[]", "notMachine"],
    ["deeper than any", "[".repeat(101) + "]".repeat(101), "notMachine"],
    ["a tool file", `{"tools":[]}`, "notMachine"],
    ["of a newer edition", `{"format":"turnwise-machine/2","name":"A"}`, "newer"],
    ["longer than any", `{"format":"turnwise-machine/1","name":"${"A".repeat(10_000)}"}`, "notMachine"],
  ])("%s", (_, text, kind) => expect(readMachine(text)).toEqual({ problems: [{ kind, at: "" }] }));

  test.each([
    [{ name: "" }, ["low name 1"]],
    [{ rapid: { x: 99, z: 200_001 } }, ["low rapid.x 100", "high rapid.z 200000"]],
    [{ rapid: { x: 5000 } }, ["missing rapid.z"]],
    [{ rapids: { x: 5000, z: 5000 } }, ["unknown rapids"]],
    [{ acceleration: { x: 2, z: 2 } }, ["alone acceleration"]],
    [{ toolChange: "4 s" }, ["wrong toolChange"]],
    [{ spindle: { runUp: 2 } }, ["missing spindle.most"]],
    [{ spindle: { most: 3000, runUp: 121, speed: 3 } }, ["high spindle.runUp 120", "unknown spindle.speed"]],
    [torque([0, 70]), ["low spindle.torque 2"]],
    [torque([0, 70], [1500, 70], [1500, 20]), ["order spindle.torque"]],
    [torque([0, 70], [1500, 0]), ["low spindle.torque.1.torque 0.1"]],
    [{ output: { ...NC_OUTPUTS.manual, spindleOn: 1000 } }, ["wrong output"]],
  ])("%j says what is wrong and where", (file, expected) => expect(problems(file)).toEqual(expected));

  test.each([
    [{ rapid: { x: 100, z: 200_000 }, acceleration: { x: 0.05, z: 50 } }],
    [{ toolChange: 0, spindle: { most: 10, runUp: 120 } }],
    [torque([0, 70], [1500, 70], [1501, 20])],
  ])("%j is at its bounds, and read", (file) => expect(problems(file)).toEqual([]));
});

test("the power of a spindle is that of its torque up to its own", () => {
  const spindle = {
    most: 3000,
    power: 11,
    torque: [
      { speed: 500, torque: 80 },
      { speed: 1500, torque: 70 },
      { speed: 3000, torque: 40 },
    ],
  };
  const kW = (Nm: number, rpm: number) => (Nm * rpm * 2 * Math.PI) / 60_000;
  expect(powerAt(spindle, 250)).toBeCloseTo(kW(80, 250), 9);
  expect(powerAt(spindle, 1000)).toBeCloseTo(kW(75, 1000), 9);
  expect(powerAt(spindle, 1500)).toBeCloseTo(kW(70, 1500), 9);
  expect(powerAt(spindle, 2000)).toBe(11);
  expect(powerAt({ most: 3000, torque: spindle.torque }, 3000)).toBeCloseTo(kW(40, 3000), 9);
  expect(powerAt({ most: 3000, power: 11 }, 200)).toBe(11);
  expect(powerAt({ most: 3000 }, 200)).toBeNull();
});
