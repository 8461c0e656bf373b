import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { PART_NAMES, PEER_NAMES } from "./parts.ts";

/*
 * The table of plans in docs/planning.md is written by `npm run laws -- --trade --write`, which plans for minutes. Here
 * it is held to the plans that `plans.test.ts` makes anyway, so that it cannot go stale unnoticed.
 */

const page = readFileSync("docs/planning.md", "utf8");
const table = page.slice(page.indexOf("<!-- plans -->"), page.indexOf("<!-- /plans -->"));
const rows = new Map(
  [...table.matchAll(/^\| ([a-z-]+) +\|(.*)\|$/gm)]
    .filter(([, name]) => name !== "part")
    .map(([, name = "", cells = ""]) => [name, cells.split("|").map((cell) => cell.trim())] as const),
);
const snapshot = readFileSync("tests/planning/__snapshots__/plans.test.ts.snap", "utf8");
const planned = [...snapshot.matchAll(/^exports\[`([a-z-]+) is made.*\n"([^"]*)"/gm)].map(
  ([, name = "", text = ""]) => [name, text.split("\n")] as const,
);

test("the page has a row for each part", () => {
  expect([...rows.keys()]).toEqual([...PART_NAMES, ...PEER_NAMES]);
  expect(planned.length).toBeGreaterThan(0);
});

test.each(planned)("the page states the plan of the %s", (name, lines) => {
  const [, , tools, , operations, seconds] = rows.get(name) ?? [];
  expect([operations, `${seconds} s`, tools]).toEqual([String(lines.length - 2), ...lines.slice(-2)]);
});
