import { describe, expect, test } from "vitest";
import { verified } from "../scripts/verify.ts";
import { readMachine } from "../src/program/machine/machine-file.ts";
import { over, readTools } from "../src/program/tools/read-tools.ts";
import { shippedTools } from "../src/program/tools/shipped-tools.ts";
import type { ReportTime } from "../src/report/report.ts";
import { projectFile } from "./sources.ts";

const table = readTools(projectFile("tests/times/tools.json"));
const shop = "tools" in table ? over({ tools: shippedTools }, table) : { tools: shippedTools, refused: new Map() };

function machineIn(name: string) {
  const read = readMachine(projectFile(`tests/times/${name}`));
  if ("problems" in read) throw new Error(JSON.stringify(read.problems));
  return read.machine;
}

/** The table of docs/times.md: manually calculated figures. */
const [head = [], , ...rows] =
  projectFile("docs/times.md")
    .split("\n## Six programs calculated by hand\n")[1]
    ?.split("\n")
    .filter((line) => line.startsWith("|"))
    .map((line) =>
      line
        .split("|")
        .slice(1, -1)
        .map((cell) => cell.trim().replaceAll("`", "")),
    ) ?? [];
const CAUSES = [
  "cutting",
  "rapid",
  "dwell",
  "toolChange",
  "spindle",
  "total",
] as const satisfies readonly (keyof ReportTime)[];

describe("times calculated by hand", () => {
  test("the table has its columns and six programs", () => {
    expect(head.slice(2)).toEqual(CAUSES);
    expect(rows.slice(0, 6).map(([name]) => name)).toEqual([
      "facing.h",
      "lengthwise.h",
      "thread.h",
      "drilling.h",
      "rapids.h",
      "changes.h",
    ]);
  });

  test.each(rows.slice(0, 6).map(([name = "", machine = "", ...seconds]) => [name, machine, seconds] as const))(
    "%s",
    (name, machine, seconds) => {
      const text = projectFile(`tests/times/${name}`);
      const { time } = verified(name, text, shop, machine.endsWith(".json") ? { machine: machineIn(machine) } : {});
      for (const [i, cause] of CAUSES.entries())
        expect([cause, time[cause].toFixed(3)]).toEqual([cause, Number(seconds[i]).toFixed(3)]);
      expect(time.cutting + time.rapid + time.dwell + time.toolChange + time.spindle).toBeCloseTo(time.total, 9);
    },
  );
});

describe("a time states its contents", () => {
  const timeOf = (machine?: ReturnType<typeof machineIn>) =>
    verified("changes.h", projectFile("tests/times/changes.h"), shop, machine ? { machine } : {}).time;

  test("without a machine: cuts, dwells and rapids at one rate", () => {
    expect(timeOf()).toMatchObject({
      contains: ["cutting", "rapid", "dwell"],
      machine: null,
      rates: 10_000,
      toolChange: 0,
      spindle: 0,
    });
  });

  test("it contains exactly the parts that the machine states", () => {
    expect(timeOf({ name: "A" })).toMatchObject({
      contains: ["cutting", "rapid", "dwell"],
      machine: "A",
      rates: 10_000,
    });
    expect(timeOf({ name: "B", rapid: { x: 9000, z: 8000 }, toolChange: 3.5 })).toMatchObject({
      contains: ["cutting", "rapid", "dwell", "toolChange"],
      rates: { x: 9000, z: 8000 },
      toolChange: 7,
      spindle: 0,
    });
    expect(timeOf(machineIn("machine.json")).contains).toEqual([
      "cutting",
      "rapid",
      "dwell",
      "acceleration",
      "toolChange",
      "spindle",
    ]);
  });

  test("a spindle limit alone slows the cuts that would be faster, and no others", () => {
    const [free, slow, wide] = [
      timeOf(),
      timeOf({ name: "C", spindle: { most: 1100 } }),
      timeOf({ name: "D", spindle: { most: 90_000 } }),
    ];
    // 12 mm at 0.1 mm/rev, twice at 1100 instead of 3000 rpm, 15 mm at 1100 instead of 1500, and the face.
    const k = 500_000 / (2 * Math.PI * 1100);
    expect(k).toBeGreaterThan(26);
    const face = 60 * (26 / (0.1 * 1100) - (Math.PI * 676) / 50_000);
    const lengthwise = 2 * (60 * 120) * (1 / 1100 - 1 / 3000) + 60 * 150 * (1 / 1100 - 1 / 1500);
    expect(slow.cutting - free.cutting).toBeCloseTo(lengthwise + face, 6);
    expect(wide.cutting).toBeCloseTo(free.cutting, 2);
    expect(wide.contains).not.toContain("spindle");
  });
});
