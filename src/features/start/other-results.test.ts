import { expect, test } from "vitest";
import { page } from "../../i18n/de/first/page.ts";
import type { WorkSummary } from "../../app/records/device.ts";
import { findOtherResults } from "./other-results.ts";

const work = (name: string, cycle: number | null): WorkSummary => ({ work: name, savedAt: 7, name, cycle, size: 3 });
const works = [work("WELLE-31", 4711), work("Épaulement", null), work("FLANSCH", null)];

test.each([
  ["welle", ["WELLE-31"], ["shaft"]],
  ["47", ["WELLE-31"], []],
  ["epaul", ["Épaulement"], []],
  ["flansch sechs", [], ["flange"]],
  ["kitchen", [], []],
  ["  ", [], []],
])("%j finds works and examples by all its words", (sought, names, examples) => {
  const found = findOtherResults(sought, works, page.examples);
  expect(found.works.map(({ name }) => name)).toEqual(names);
  expect(found.examples).toEqual(examples);
});
