import { describe, expect, test } from "vitest";
import { findCommands, groupedCommands, type Command } from "./find-commands.ts";

const make = (group: Command["group"], id: string, name: string, words: readonly string[] = []): Command => ({
  id,
  group,
  name,
  words,
  run: () => undefined,
});
const ALL = [
  make("action", "export", "Part as STL"),
  make("action", "undo", "Undo"),
  make("page", "tools", "Tool table", ["inserts"]),
  make("setting", "dark", "Appearance: Dark"),
  make("setting", "theme.l", "Appearance: Light"),
  make("cycle", "812", "Cycle 812, turn shoulder"),
  make("page", "résumé", "Résumé of tools"),
];
const found = (typed: string, recent: readonly string[] = [], cycles: readonly string[] = []) =>
  findCommands(ALL, typed, recent, cycles).map(({ id }) => id);

describe("typed", () => {
  test.each([
    ["undo", ["undo"]],
    ["tool", ["tools", "résumé"]],
    ["resume", ["résumé"]],
    ["inserts", ["tools"]],
    ["appearance dark", ["dark"]],
    ["dark appearance", ["dark"]],
    ["cycle", []],
    ["nothing", []],
  ])("%j", (typed, expected) => expect(found(typed)).toEqual(expected));
});

test("of equals the last used one comes first", () => {
  expect(found("appearance")).toEqual(["dark", "theme.l"]);
  expect(found("appearance", ["undo", "theme.l"])).toEqual(["theme.l", "dark"]);
});

test("cycles come from their own search", () => {
  expect(found("shoulder", [], ["812"])).toEqual(["812"]);
});

test("before anything is typed the last used ones lead, and stand once", () => {
  const groups = groupedCommands(ALL, ["tools", "gone"]).map(({ group, commands }) => [
    group,
    commands.map(({ id }) => id),
  ]);
  expect(groups).toEqual([
    ["recent", ["tools"]],
    ["action", ["export", "undo"]],
    ["page", ["résumé"]],
    ["cycle", ["812"]],
    ["setting", ["dark", "theme.l"]],
  ]);
});
