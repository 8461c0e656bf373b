import { expect, test } from "vitest";
import { parse } from "../nc/parse.ts";
import { projectFile } from "../../tests/sources.ts";
import { run } from "./run.ts";
import { shippedTools } from "./shipped-tools.ts";

const program = projectFile("tests/programs/cycle-831.h");
const told = (text: string, rapid = 10_000) =>
  run(parse(text), { tools: shippedTools, rapid }).issues.map((i) => i.issue).filter((i) =>
    i.code === "threadFeedOverLimit" || i.code === "runInShort"
  );

test("a feed that the axis cannot follow is told, with the speed up to which it can", () => {
  expect(told(program.replace("S640", "S330"))).toEqual([]);
  // 640 rpm × 3.5 mm.
  expect(told(program.replace("Q460=+4.7", "Q460=+5.6"), 2100)).toMatchObject([{
    code: "threadFeedOverLimit",
    at: "Q472",
    data: { feed: 2240, speed: 640, most: 2100, upTo: 600 },
  }]);
});

test("a run-in too short for the speed is told, with the one that is not", () => {
  expect(told(program)).toMatchObject([{ code: "runInShort", at: "Q460", data: { runIn: 4.7, needed: 5.6, nearest: 5.6 } }]);
  expect(told(program.replace("Q460=+4.7", "Q460=+5.6"))).toEqual([]);
});
