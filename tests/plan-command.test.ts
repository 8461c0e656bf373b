import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { main } from "../scripts/plan.ts";
import { parse } from "../src/nc/parse.ts";
import { asText, dxfGroups, polyline, utf8 } from "./drawings/dxf-file.ts";

let [folder, out, err] = ["", "", ""];
beforeEach(() => {
  [folder, out, err] = [mkdtempSync(join(tmpdir(), "plan-")), "", ""];
  vi.spyOn(process.stdout, "write").mockImplementation((data) => Boolean((out += String(data))));
  vi.spyOn(process.stderr, "write").mockImplementation((data) => Boolean((err += String(data))));
});
afterEach(() => {
  vi.restoreAllMocks();
  rmSync(folder, { recursive: true });
});

const file = (name: string, data: string | Uint8Array) => {
  const path = join(folder, name);
  writeFileSync(path, data);
  return path;
};
const pin = (outside: readonly object[] = [{ x: 0, z: 0 }, { x: 20 }, { z: -18 }, { x: 28 }, { z: -30 }]) =>
  file(
    "pin.json",
    JSON.stringify({
      format: "turnwise-part/1",
      name: "PIN",
      blank: { outside: 30, bore: 0, length: 60, allowance: 1 },
      outside,
      unmachinedBehind: true,
    }),
  );
const drawn = () =>
  file(
    "pin.dxf",
    utf8(
      asText(
        dxfGroups({
          header: [["$INSUNITS", 70, 4]],
          entities: [
            polyline(false, [
              [0, 10],
              [-18, 10],
              [-18, 14],
              [-30, 14],
            ]),
          ],
        }),
      ),
    ),
  );

test("the program is on standard output, the plan with its reasons on standard error", async () => {
  expect(await main([pin(), "--language", "de"])).toBe(0);
  expect(parse(out).blocks.flatMap((b) => b.issues ?? [])).toEqual([]);
  expect(out).toMatch(/^0 BEGIN PGM PIN MM\n1 BLK FORM CYLINDER Z D30 L60 DIST\+1\n/);
  expect(out.match(/\* - .*/g)).toEqual(["* - PLANEN", "* - AUSSEN SCHRUPPEN", "* - AUSSEN SCHLICHTEN"]);
  expect(err).toMatch(/^ 1\. Plandrehen: Zyklus \d+, T\d+ /);
  expect(err).toContain("Schruppen vor Schlichten");
  expect(err).toMatch(/\n {6}Nächstbeste Wege: Zyklus \d+, T\d+ .*: /);
  expect(err).toMatch(/Werkzeuge: \d, Werkzeugwechsel: \d; Geprüft, alles erreichbare Material zerspant\n$/);
});

test("a drawing gives the part, options its blank", async () => {
  expect(await main([drawn(), "--blank", "30x60+1", "--part-off"])).toBe(0);
  expect(out).toContain("D30 L60 DIST+1");
  expect(err).toMatch(/\d\. Part off: /);
});

test("the other side has a program of its own", async () => {
  const axle = file(
    "axle.json",
    JSON.stringify({
      format: "turnwise-part/1",
      name: "AXLE",
      blank: { outside: 30, bore: 0, length: 61, allowance: 1 },
      clamping: { kind: "chuckOutside", words: { D: 30, LENGTH: 25, FACE: -36, SIZE: 160 } },
      outside: [{ x: 0, z: 0 }, { x: 20 }, { z: -18 }, { x: 28 }, { z: -42 }, { x: 20 }, { z: -60 }],
    }),
  );
  const begins = () => out.match(/BEGIN PGM \w+/g);
  expect(await main([axle])).toBe(0);
  expect(begins()).toEqual(["BEGIN PGM AXLE"]);
  out = "";
  expect(await main([axle, "--clamping", "2"])).toBe(0);
  expect(begins()).toEqual(["BEGIN PGM AXLE_2"]);
  expect(err).toContain("Second clamping:\n 1. ");
});

test("a bore is drilled with the built-in drills; a side without a step is no clamping", async () => {
  const ring = file(
    "ring.json",
    JSON.stringify({
      format: "turnwise-part/1",
      name: "RING",
      blank: { outside: 50, bore: 0, length: 60, allowance: 1 },
      outside: [{ x: 30, z: 0 }, { x: 48 }, { z: -20 }, { x: 30 }],
      inside: [{ x: 30, z: 0 }, { z: -20 }],
      partsOff: true,
    }),
  );
  expect(await main([ring])).toBe(0);
  expect(err).toMatch(/\d\. Drill: cycle 200, T38 DRILL-D26[^]*\d\. Finish bore: [^]*\d\. Part off: /);
  expect(await main([ring, "--clamping", "2"])).toBe(2);
  expect(err).toMatch(/plan: there is no second clamping\n$/);
});

test("what is left names its tool, and the status is 1", async () => {
  const turning = [1, 2, 3, 4, 5, 6, 7, 8, 11, 14, 15, 16, 17].flatMap((T) => ["--without-tool", String(T)]);
  expect(await main([pin(), ...turning])).toBe(1);
  expect(err).toMatch(/Not made: .* mm² outside, Z.*: a tool or cycle that makes it is excluded/);
});

test.each([
  [() => file("part.json", "{}"), "notPart"],
  [() => pin([{ x: 20, z: 0 }]), "error: "],
])("without a part the status is 1 and the reason is said", async (path, reason) => {
  expect(await main([path()])).toBe(1);
  expect([out, err]).toEqual(["", expect.stringContaining(reason)]);
});

test.each([
  [[], "usage: "],
  [["a.json", "b.json"], "one part at a time"],
  [["nowhere.json"], "cannot read nowhere.json"],
  [["a.json", "--language", "it"], "--language needs one of en, de, fr, zh, not it"],
  [["a.json", "--blank", "50"], "--blank needs ⌀ x length, as 50x165+1.5, not 50"],
  [["a.json", "--without-tool", "x"], "--without-tool needs a number, not x"],
  [["a.json", "--tools"], "--tools needs a value"],
  [["a.json", "--fast"], "unknown option --fast"],
] as const)("%j is refused", async (args, reason) => {
  expect(await main(args)).toBe(2);
  expect([out, err.startsWith("plan: "), err.includes(reason)]).toEqual(["", true, true]);
});

test("help and version", async () => {
  expect(await main(["--help"])).toBe(0);
  expect(out).toContain("Exit status: 0 the program is verified");
});
