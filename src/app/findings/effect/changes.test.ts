import { expect, test } from "vitest";
import { length } from "../../../kernel/units.ts";
import { texts } from "../../../i18n/index.ts";
import { lengthsOf } from "../../calculation/lengths.ts";
import type { MeasuredSetting } from "./compared.ts";
import { changedOperations, changeText, numberText } from "./changes.ts";

const t = texts("en"),
  en = lengthsOf("en", "mm");
const setting = (effect: Partial<MeasuredSetting["effect"]>, more: Partial<MeasuredSetting> = {}): MeasuredSetting =>
  ({
    effect: { passes: 5, infeed: 2.4517, seconds: 84.61, residual: 0, ...effect },
    chip: 0.7356,
    faults: 0,
    ...more,
  }) as MeasuredSetting;

test("a changed number shows its previous value, a time the difference", () => {
  const [before, now] = [
    setting({}),
    setting({ passes: 7, infeed: 1.7512, seconds: 101.27, residual: 0.137 }, { chip: null, faults: 3 }),
  ];
  const said = (["passes", "infeed", "time", "chip", "residual", "faults"] as const).map((name) =>
    changeText(t, en, before, now, name),
  );
  expect(said).toEqual(["5", "2.452", "+16.7 s", "0.74", "none", "0"]);
  expect(changeText(t, lengthsOf("de", "mm"), now, before, "time")).toContain("−16,7");
});
test("numbers that are written the same have not changed", () => {
  const [before, now] = [setting({}), setting({ infeed: 2.4519, seconds: 84.6401 })];
  expect(changeText(t, en, before, now, "infeed")).toBeNull();
  expect(changeText(t, en, before, now, "time")).toBeNull();
  expect(changeText(t, en, before, now, "passes")).toBeNull();
});
test("a large change of time is in hours and minutes, and a small area keeps two digits", () => {
  const [before, now] = [setting({}), setting({ seconds: 14_740.31 }, { chip: 0.0018 })];
  expect(changeText(t, en, before, now, "time")).toBe("+4 h 4 min");
  expect(changeText(t, en, now, setting({ seconds: 14_646.2 }), "time")).toBe("−1 min 34 s");
  expect(changeText(texts("zh"), lengthsOf("zh", "mm"), before, now, "time")).toBe("+4 小时 4 分");
  expect([0, 0.0018, 0.0567, 0.137, 2.5].map((chip) => numberText(t, en, setting({}, { chip }), "chip"))).toEqual([
    "0.00",
    "0.0018",
    "0.057",
    "0.14",
    "2.50",
  ]);
});
test("long times are in minutes, and an unknown value is a dash", () => {
  expect(numberText(t, en, setting({ seconds: 84.61 }), "time")).toBe("1 min 25 s");
  expect(numberText(t, en, setting({ seconds: 7.34 }), "time")).toBe("7.3 s");
  expect(numberText(t, en, setting({ seconds: 3599.6 }), "time")).toBe("1 h 0 min");
  expect(numberText(t, en, setting({ residual: null }), "residual")).toBe("–");
});

test("only operations whose numbers differ are set side by side, and none of another program", () => {
  const call = (cycle: number, passes: number, infeed: number, seconds: number) => ({
    cycle,
    seconds,
    plan: { passes, infeed: length(infeed) },
  });
  const before = [call(820, 1, 0.95, 60), call(812, 7, 2.7, 80.2), call(861, 0, 0, 12.04)];
  const now = [call(820, 1, 0.95, 60.2), call(812, 4, 4.7, 52.91), call(861, 0, 0, 12)];
  expect(changedOperations(t, en, before, now)).toEqual([
    { operation: 1, name: "passes", before: "7", now: "4" },
    { operation: 1, name: "infeed", before: "2.700", now: "4.700" },
    { operation: 1, name: "time", before: "1 min 20 s", now: "52.9 s" },
  ]);
  expect(changedOperations(t, en, before, now.slice(1))).toEqual([]);
  expect(changedOperations(t, en, before, [call(810, 1, 0.95, 60), ...now.slice(1)])).toEqual([]);
});
