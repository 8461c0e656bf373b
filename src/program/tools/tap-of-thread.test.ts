import { expect, test } from "vitest";
import { readThread } from "../../kernel/thread/threads.ts";
import { drillOf } from "./drill-of.ts";
import { standardDrills } from "./standard-drills.ts";
import { hasTap, isCoreDrill, isTapOf } from "./tap-of-thread.ts";
import { readList, shippedList } from "./tool-list.ts";

/** Names of the taps of a thread, and of the first drill before them, among the standard ones. */
function found(name: string): readonly [taps: readonly string[], drill: string | undefined] {
  const thread = readThread(name);
  if (!thread) throw new Error(`no thread ${name}`);
  const rows = standardDrills(shippedList, thread).map((cells, i) => ({ id: `s${i}`, cells }));
  const drills = (readList(rows).table.mills ?? []).flatMap((row) => drillOf(row) ?? []);
  const named = (is: (tool: (typeof drills)[0]) => boolean) => drills.filter(is).map(({ NAME }) => NAME);
  return [named((tool) => isTapOf(tool, thread)), named((tool) => isCoreDrill(tool, thread))[0]];
}

// A usual drill within the limits of the minor diameter, or the one next to their middle.
test.each([
  ["M6", ["TAP-M6"], "DRILL-D5"],
  ["M8", ["TAP-M8"], "DRILL-D6.8"],
  ["M10", ["TAP-M10"], "DRILL-D8.5"],
  ["M12", ["TAP-M12"], "DRILL-D10.2"],
  ["M12x1,25", ["TAP-M12x1.25"], "DRILL-D10.8"],
  ["M20×1.5", ["TAP-M20x1.5"], "DRILL-D18.5"],
  ["M16-6H", ["TAP-M16"], "DRILL-D14"],
  ["1/4-20 UNC", ["TAP-1/4-20-UNC"], "DRILL-D5"],
])("%s has one tap and the drill before it", (name, taps, drill) => {
  expect(found(name)).toEqual([taps, drill]);
});

test.each([["Tr40x7"], ["1/2 NPT"], ["M20-6g"], ["M20xPh3P1.5"]])("%s is not tapped", (name) => {
  const thread = readThread(name);
  expect(thread && hasTap(thread)).toBe(false);
});
