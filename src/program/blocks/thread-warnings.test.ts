import { expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import { projectFile } from "../../../tests/sources.ts";
import { run } from "../run/run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";

const program = projectFile("tests/programs/cycle-831.h");
const told = (text: string, rapid = 10_000) =>
  run(parse(text), { tools: shippedTools, rapid })
    .issues.map((i) => i.issue)
    .filter((i) => i.code === "threadFeedOverLimit" || i.code === "runInShort");

test("a feed that the axis cannot follow is reported, with the highest possible speed", () => {
  expect(told(program.replace("S640", "S330"))).toEqual([]);
  // 640 rpm × 3.5 mm.
  expect(told(program.replace("Q460=+4.7", "Q460=+5.6"), 2100)).toMatchObject([
    {
      code: "threadFeedOverLimit",
      at: "Q472",
      data: { feed: 2240, speed: 640, most: 2100, upTo: 600 },
    },
  ]);
});

test("a run-in too short for the speed is reported, with a sufficient one", () => {
  expect(told(program)).toMatchObject([
    { code: "runInShort", at: "Q460", data: { runIn: 4.7, needed: 5.6, nearest: 6 } },
  ]);
  expect(told(program.replace("Q460=+4.7", "Q460=+5.6"))).toEqual([]);
});

test("a thread at constant surface speed is reported at its call, with its range of speeds", () => {
  const codes = (text: string) =>
    run(parse(text), { tools: shippedTools, rapid: 10_000 }).issues.filter(
      (i) => i.issue.code === "threadSurfaceSpeed",
    );
  expect(codes(program)).toEqual([]);
  const [found, ...more] = codes(program.replace("VCONST:OFF S640", "VCONST:ON VC:120 SMAX3000"));
  expect(more).toEqual([]);
  const call = codes(program.replace("VCONST:OFF S640", "VCONST:ON VC:120")).map((i) => i.block);
  expect(found).toMatchObject({ block: call[0], issue: { severity: "warning", data: { cuttingSpeed: 120 } } });
  const { slow = 0, fast = 0 } = (found?.issue.data ?? {}) as { slow?: number; fast?: number };
  expect(slow).toBeGreaterThan(0);
  expect(fast).toBeGreaterThan(slow);
});

test("where no run-in can reach the feed, the speed is to blame and no run-in is offered", () => {
  const found = told(program.replace("S640", "S4000"), 10_000);
  const runIn = found.find((i) => i.code === "runInShort");
  expect(found.map((i) => i.code).sort()).toEqual(["runInShort", "threadFeedOverLimit"]);
  expect(runIn?.data).not.toHaveProperty("nearest");
});
