import { expect, test } from "vitest";
import { readThread } from "../kernel/thread/threads.ts";
import { c831 } from "./c831.ts";
import { c832 } from "./c832.ts";
import type { ThreadRoles } from "./define.ts";
import { differencesFrom, threadOfValues } from "./found-thread.ts";
import { depthForNose, valuesOfThread, type ThreadAim, type TypedValues } from "./thread-values.ts";

const [long, extended] = [c831.thread as ThreadRoles, c832.thread as ThreadRoles];
const MIDDLE: ThreadAim = { aim: "middle", nose: null };
const BASIC: ThreadAim = { aim: "basic", nose: null };
const OUTSIDE = { Q471: 0, Q467: 30 };
const INSIDE = { Q471: 1, Q467: 30 };

const filled = (name: string, roles: ThreadRoles, typed: TypedValues, aim: ThreadAim) => {
  const thread = readThread(name);
  if (!thread) throw new Error(`no thread ${name}`);
  const fill = valuesOfThread(thread, roles, typed, aim);
  return typeof fill === "string" ? fill : fill.values;
};

test.each([
  ["M20x1.5", OUTSIDE, BASIC, { Q472: 1.5, Q473: 0.92, Q475: 1, Q491: 20 }],
  ["M20x1.5", OUTSIDE, MIDDLE, { Q472: 1.5, Q473: 0.896, Q475: 1, Q491: 19.85 }],
  ["M20x1.5", INSIDE, BASIC, { Q472: 1.5, Q473: 0.812, Q475: 1, Q491: 20 }],
  ["M70x1.5", OUTSIDE, MIDDLE, { Q472: 1.5, Q473: 0.901, Q475: 1, Q491: 69.85 }],
  // A class of the other side turns the thread.
  ["M20-6H", OUTSIDE, BASIC, { Q471: 1, Q472: 2.5, Q473: 1.353, Q475: 1, Q491: 20 }],
  ["G1/2", OUTSIDE, BASIC, { Q472: 1.814, Q473: 1.162, Q475: 1, Q491: 20.955, Q467: 27.5 }],
  // Core of the external thread 15.5; root of the internal one 20.5 and its core 16.
  ["Tr20x4", OUTSIDE, BASIC, { Q472: 4, Q473: 2.25, Q475: 1, Q491: 20, Q467: 15 }],
  ["Tr20x4", INSIDE, BASIC, { Q472: 4, Q473: 2.25, Q475: 1, Q491: 20.5, Q467: 15 }],
  ["Tr40x14P7", OUTSIDE, BASIC, { Q472: 14, Q473: 4, Q475: 2, Q491: 40, Q467: 15 }],
  ["S48x8", OUTSIDE, BASIC, { Q472: 8, Q473: 6.942, Q475: 1, Q491: 48, Q467: 3 }],
] as const)("%s with %j gives the values of 831", (name, typed, aim, values) => {
  expect(filled(name, long, typed, aim)).toEqual(values);
});

test("a taper begins and ends as its gauge plane says, whichever way it is cut", () => {
  // NPT 1/2: E0 19.264 + 1.451, and 13.556 mm further 1/16 of it more.
  const ends = { Q491: 20.716, Q493: 21.563, Q492: 0, Q494: -13.556 };
  expect(filled("NPT 1/2", extended, { ...OUTSIDE, Q492: 0, Q494: -35 }, BASIC)).toMatchObject({ Q464: 0, ...ends });
  expect(filled("NPT 1/2", extended, { ...OUTSIDE, Q492: -35, Q494: 0 }, BASIC)).toMatchObject({
    Q491: 21.563,
    Q493: 20.716,
    Q492: -13.556,
    Q494: 0,
  });
  // Inside the gauge plane is the face: root 21.224, smaller behind it.
  expect(filled("NPT 1/2", extended, { ...INSIDE, Q492: 5, Q494: -35 }, BASIC)).toMatchObject({
    Q491: 21.224,
    Q493: 20.376,
    Q492: 5,
    Q494: -8.571,
  });
  expect(filled("R1/2", extended, { ...OUTSIDE, Q492: 0, Q494: -35 }, BASIC)).toMatchObject({
    Q491: 20.443,
    Q493: 21.268,
  });
  expect(filled("R1/2", long, OUTSIDE, BASIC)).toBe("taper");
  expect(filled("Rp1/2", long, OUTSIDE, BASIC)).toMatchObject({ Q471: 1 });
  // A cylinder in the cycle that can cut a taper.
  expect(filled("M20", extended, OUTSIDE, BASIC)).toMatchObject({ Q464: 0, Q491: 20, Q493: 20 });
});

test("an insert with a sharper nose cuts deeper for the same pitch diameter", () => {
  const thread = readThread("M20x1.5");
  if (!thread) throw new Error("no thread");
  // H/6 − 0.1 more: its flanks meet that much deeper.
  expect(depthForNose(thread, false, 0.1)).toBeCloseTo(0.1165, 3);
  expect(filled("M20x1.5", long, OUTSIDE, { aim: "middle", nose: 0.1 })).toMatchObject({ Q473: 1.013 });
});

test.each([
  ["M20x1.5", long, OUTSIDE, MIDDLE],
  ["M20x1.5", long, INSIDE, BASIC],
  ["M70x1.5-6h", long, OUTSIDE, MIDDLE],
  ["M33.5x0.75", long, OUTSIDE, MIDDLE],
  ["G1/2", long, INSIDE, MIDDLE],
  ["G1/2B", long, OUTSIDE, MIDDLE],
  ["1/4-20 UNC", long, OUTSIDE, MIDDLE],
  ["3/8-24 UNF-3A", long, OUTSIDE, MIDDLE],
  ["Tr40x7", long, OUTSIDE, BASIC],
  ["Tr40x14P7", long, OUTSIDE, BASIC],
  ["W1/2", long, OUTSIDE, BASIC],
  ["Rd40", long, OUTSIDE, BASIC],
  ["NPT 1/2", extended, { ...OUTSIDE, Q492: 0, Q494: -35 }, BASIC],
  ["R1/2", extended, { ...OUTSIDE, Q492: 0, Q494: -35 }, BASIC],
] as const)("%s is recognized from its values", (name, roles, typed, aim) => {
  const thread = readThread(name);
  const found = threadOfValues(roles, { ...typed, ...(filled(name, roles, typed, aim) as TypedValues) }, null);
  expect([found?.thread.name, found?.aim, found?.differences]).toEqual([thread?.name, aim.aim, []]);
});

test("values near a thread are named with what differs; others are none", () => {
  const found = (own: TypedValues) =>
    threadOfValues(long, { Q471: 0, Q472: 1.5, Q473: 0.92, Q475: 1, Q491: 20, Q467: 30, ...own }, null);
  expect(found({})).toMatchObject({ thread: { name: "M20×1.5" }, aim: "basic", differences: [] });
  // A depth of 0 is that of the metric profile.
  expect(found({ Q473: 0 })?.differences).toEqual([]);
  expect(found({ Q473: 0.8 })?.differences).toEqual([{ q: "Q473", is: 0.8, should: 0.92 }]);
  expect(found({ Q491: 20.13, Q472: 1.63 })).toBeNull();
  expect(found({ Q491: "auto" })).toBeNull();
  const thread = readThread("M20x1.5");
  expect(thread && differencesFrom(thread, long, { Q471: 0, Q491: 20, Q472: 2 }, MIDDLE).map(({ q }) => q)).toEqual([
    "Q472",
    "Q491",
  ]);
});
