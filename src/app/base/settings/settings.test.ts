import { expect, test, vi } from "vitest";
import { ISO_GROUPS, readCuttingTable, writeCuttingTable } from "../../../program/tools/cutting-table.ts";
import { changeSettings, firstSettings, readSettings } from "./settings.ts";

test("settings are restored, and invalid ones get their default", () => {
  const first = firstSettings();
  expect(readSettings({ ...first, language: "fr", theme: "dark", xDown: true })).toEqual({
    ...first,
    language: "fr",
    theme: "dark",
    xDown: true,
  });
  expect(readSettings({ language: "xx", theme: 3, programFolded: "yes", other: 1 })).toEqual(first);
  expect(readSettings({ fullSection: true })).toEqual({ ...first, section: "full" });
});

test("settings that only a newer edition knows stay when others are changed", () => {
  const data = new Map([["turnwise/settings", '{"later":[1],"theme":3,"fullSection":true}']]);
  vi.stubGlobal("localStorage", {
    getItem: (key: string) => data.get(key) ?? null,
    setItem: (key: string, text: string) => void data.set(key, text),
  });
  changeSettings({ section: "outside" });
  const after = JSON.parse(data.get("turnwise/settings") ?? "") as object;
  vi.unstubAllGlobals();
  expect(after).toMatchObject({ later: [1], theme: "system", section: "outside" });
  expect(readSettings(after)?.section).toBe("outside");
});

test.each([undefined, null, [], 7])("damaged settings %j are refused", (raw) => expect(readSettings(raw)).toBeNull());

test("the largest valid cutting data are stored as well", () => {
  // Names of characters that JSON escapes with six, and numbers with all their digits.
  const name = "\u0001".repeat(80);
  const numbers = {
    kc11: 2217.123456789123,
    mc: 0.1234567890123456,
    roughSpeed: 143.1234567890123,
    roughFeed: 0.2712345678901234,
  };
  const materials = Array.from({ length: 100 }, (_, i) => ({
    id: `${name.slice(0, 77)}${i}`,
    name,
    group: ISO_GROUPS[i % 6] ?? "P",
    ...numbers,
    finishSpeed: numbers.roughSpeed,
    finishFeed: numbers.roughFeed,
  }));
  const cutting = writeCuttingTable({ power: 7.3, materials });
  expect(readCuttingTable(cutting)?.materials).toHaveLength(100);
  expect(readSettings({ ...firstSettings(), cutting })?.cutting).toBe(cutting);
});
