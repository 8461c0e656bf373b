import { expect, test } from "vitest";
import type { WorkSummary } from "../../app/records/device.ts";
import { listWorks, type WorkOrder } from "./list-works.ts";
import { sizeWords } from "./size-words.ts";

const work = (name: string, cycle: number | null, savedAt: number, size: number): WorkSummary => ({
  work: name,
  name,
  cycle,
  savedAt,
  size,
});
const works = [
  work("A10", 812, 3, 412),
  work("a2", 861, 9, 90_113),
  work("WELLE.H", null, 5, 12),
  work("Ölnut", 861, 1, 413),
];
const named = (cycle: number) => (cycle === 861 ? "Einstechen" : "Absatz");
const list = (sought: string, order: WorkOrder) => listWorks(works, sought, order, named).map(({ name }) => name);

test.each<[WorkOrder, readonly string[]]>([
  ["newest", ["a2", "WELLE.H", "A10", "Ölnut"]],
  ["name", ["a2", "A10", "Ölnut", "WELLE.H"]],
  ["kind", ["WELLE.H", "A10", "a2", "Ölnut"]],
  ["size", ["a2", "Ölnut", "A10", "WELLE.H"]],
])("by %s", (order, names) => expect(list("", order)).toEqual(names));

test.each([
  ["oln", ["Ölnut"]],
  ["861", ["a2", "Ölnut"]],
  ["einst a", ["a2"]],
  [".h", ["WELLE.H"]],
  ["xyz", []],
])("%j finds %j", (sought, names) => expect(list(sought, "name")).toEqual(names));

test.each([
  [12, "en", "0.1 kB"],
  [12_437, "en", "12 kB"],
  [3_149_000, "de", "3,1 MB"],
  [999_999, "en", "1,000 kB"],
])("%d bytes are said in %s as %s", (bytes, language, words) => expect(sizeWords(bytes, language)).toBe(words));
