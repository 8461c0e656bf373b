import { readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import { clampingBodies, missesBlank, type Clamping, type ClampPart } from "../../kernel/area/clamping.ts";
import { areaOf } from "../../kernel/area/area.ts";
import { boxAround } from "../../kernel/area/box.ts";
import { at } from "../../kernel/geometry/point.ts";
import { parse } from "../../nc/parse.ts";
import { simulate, incrementalSimulator } from "../../sim/simulate.ts";
import { stockIssues } from "../../sim/issues.ts";
import { report } from "../../report/report.ts";
import { summary } from "../../report/summary.ts";
import { run } from "../run/run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";
import { clampingIn, proposedClamping, withClamping } from "./draft.ts";
import { clampingOf, readClamping } from "./read-clamping.ts";
import { CLAMPING_KINDS, clampingText, neededWords } from "./words.ts";

const ran = (text: string) => run(parse(text), { tools: shippedTools, rapid: 10_000 });
const OUTSIDE: Clamping = { kind: "chuckOutside", diameter: 60, length: 25, face: -75, size: 200 };
const CENTRE = { quill: 40, tip: -2, angle: 60 };

test("jaws grip the blank behind their face, over the stated length", () => {
  const { rings = [] } = clampingBodies(OUTSIDE, []).find(({ part }) => part === "jaws") ?? {};
  const [face, back] = [OUTSIDE.face, OUTSIDE.face - OUTSIDE.length];
  expect(boxAround(rings).right).toBe(face);
  const gripped = rings.flat().filter(({ z, r }) => z >= back && Math.abs(r - OUTSIDE.diameter / 2) < 1e-9);
  expect([...new Set(gripped.map(({ z }) => z))].toSorted((x, y) => x - y)).toEqual([back, face]);
});

describe("comments in odd spelling", () => {
  test.each<[string, Clamping]>([
    [" CLAMPING CHUCK OUTSIDE D60 LENGTH25 FACE-75 SIZE200", OUTSIDE],
    ["clamping: outside, chuck 200, face Z-75; length = 25  d 60", OUTSIDE],
    ["CLAMPING CHUCK OUTSIDE ⌀60 LENGTH:+25.0 FACE=-75 CHUCK200 MM", OUTSIDE],
    [" CLAMPING Outside Ø60,0 LENGTH 25,0 FACE -75 SIZE 200", OUTSIDE],
    [" CLAMPING CHUCK INSIDE D60 LENGTH25 FACE-75 SIZE200", { ...OUTSIDE, kind: "chuckInside" }],
    [" CLAMPING SOFT JAWS OUTSIDE D60 LENGTH25 FACE-75 SIZE200", { ...OUTSIDE, kind: "softJaws" }],
    [" CLAMPING COLLET D60 LENGTH25 FACE-75 NOSE100", { ...OUTSIDE, kind: "collet", size: 100 }],
    [
      " CLAMPING BETWEEN CENTERS D30 FACE-75 QUILL40 TIP-2",
      {
        kind: "centres",
        diameter: 30,
        length: 0,
        face: -75,
        tailstock: CENTRE,
      },
    ],
    [
      " CLAMPING CHUCK OUTSIDE D60 LENGTH25 FACE-75 SIZE200 TAILSTOCK QUILL40 TIP Z-2 ANGLE 75 LIMIT Z-72.5 LIMIT X100",
      {
        ...OUTSIDE,
        tailstock: { ...CENTRE, angle: 75 },
        limit: { z: -72.5, x: 100 },
      },
    ],
  ])("%s", (comment, wanted) => {
    const read = readClamping(comment) ?? expect.fail("a clamping");
    expect(read.what).toEqual([]);
    expect(clampingOf(read, (n) => n)).toEqual(wanted);
  });

  test.each([" CLAMPINGS D60", " clamp it well", " NO CLAMPING", ""])("%j is another comment", (comment) =>
    expect(readClamping(comment)).toBeNull(),
  );

  test.each<[string, readonly string[]]>([
    [" CLAMPING CHUCK OUTSIDE D60 LENGTH25 FACE-75", ["SIZE"]],
    [" CLAMPING CHUCK OUTSIDE D60 LENGTH25 SIZE200", ["FACE"]],
    [" CLAMPING CHUCK OUTSIDE D0 LENGTH25 FACE-75 SIZE200", ["D"]],
    [" CLAMPING CHUCK OUTSIDE D60 LENGTH25 FACE-75 SIZE60", ["SIZE"]],
    [" CLAMPING CHUCK OUTSIDE D60 LENGTH25 FACE-75 SIZE200 QUILL40", ["TIP"]],
    [" CLAMPING BETWEEN CENTRES D30 FACE-75", ["QUILL", "TIP"]],
    [" CLAMPING by hand", ["CHUCK OUTSIDE"]],
  ])("%s lacks %j", (comment, missing) => {
    const read = readClamping(comment) ?? expect.fail("a clamping");
    expect(clampingOf(read, (n) => n)).toEqual(missing);
  });

  test("what is printed is read the same", () => {
    const words = {
      D: "60",
      LENGTH: "25",
      FACE: "-75",
      SIZE: "200",
      QUILL: "40",
      TIP: "-2",
      ANGLE: "75",
      LIMITZ: "-72.5",
      LIMITX: "100",
    };
    for (const kind of CLAMPING_KINDS) {
      const read = readClamping(` ${clampingText({ kind, words })}`) ?? expect.fail(kind);
      expect([kind, read.kind, read.what]).toEqual([kind, kind, []]);
      for (const word of neededWords(kind)) expect(String(read.values[word])).toBe(words[word]);
    }
  });
});

describe("bodies", () => {
  const blank = [[at(-100, 0), at(0, 0), at(0, 30), at(-100, 30)]];
  const sizes = (c: Clamping) =>
    Object.fromEntries(clampingBodies(c, blank).map(({ part, rings }) => [part, boxAround(rings)])) as Record<
      ClampPart,
      ReturnType<typeof boxAround>
    >;

  test("jaws begin at the front, stand on the gripped ⌀, and leave the blank to itself", () => {
    const { jaws, chuck } = sizes(OUTSIDE);
    expect(jaws).toMatchObject({ left: -115, right: -75 });
    const grip =
      clampingBodies(OUTSIDE, blank)[0]
        ?.rings.flat()
        .filter(({ z }) => z > -99) ?? [];
    expect(Math.min(...grip.map(({ r }) => r))).toBe(30);
    expect(chuck).toMatchObject({ right: -115, low: 26, high: 100 });
    for (const c of [OUTSIDE, { ...OUTSIDE, kind: "collet", size: 90 } as const, { ...OUTSIDE, tailstock: CENTRE }])
      for (const { rings } of clampingBodies(c, blank))
        expect(areaOf([...rings, ...blank])).toBeCloseTo(areaOf(rings) + areaOf(blank), 6);
  });

  test("jaws inside stand within the bore", () => {
    const tube = [[at(-100, 20), at(0, 20), at(0, 30), at(-100, 30)]];
    const [jaws] = clampingBodies({ ...OUTSIDE, kind: "chuckInside", diameter: 40 }, tube);
    const front = boxAround((jaws?.rings ?? []).map((ring) => ring.filter(({ z }) => z > -99)));
    expect(front).toMatchObject({ right: -75, high: 20 });
  });

  test("the tailstock is a cone from its tip, as wide as its quill", () => {
    const { tailstock } = sizes({ ...OUTSIDE, tailstock: CENTRE });
    expect(tailstock.high).toBe(20);
    expect(tailstock.left).toBeCloseTo(0, 6);
  });

  test.each<[Partial<Clamping>, boolean]>([
    [{}, false],
    [{ diameter: 60.8 }, false],
    [{ diameter: 64 }, true],
    [{ diameter: 56 }, true],
    [
      {
        face: -1,
        length: 10,
      },
      false,
    ],
    [{ face: 20, length: 10 }, true],
  ])("%j grips nothing: %s", (more, misses) => expect(missesBlank({ ...OUTSIDE, ...more }, blank)).toBe(misses));
});

/** A bar ⌀30, Z0 to Z-80, turned along its whole length; `comment` behind its blank. */
const turned = (comment: string, end = -80) =>
  readFileSync("tests/cases/clamped-bar.h", "utf8")
    .replace(/; CLAMPING .*/, comment)
    .replace("Q494=-80", `Q494=${end}`);
const contacts = (text: string) => {
  const made = ran(text),
    simulation = simulate(made);
  return stockIssues(simulation).flatMap(({ issue }) =>
    issue.code === "clampContact" ? [`${issue.data.part} ${issue.data.by}`] : [],
  );
};
const HELD = "; CLAMPING CHUCK OUTSIDE D30 LENGTH20 FACE-60 SIZE160";

describe("contact", () => {
  test("turning to the end of the bar runs into the stated jaws", () =>
    expect(contacts(turned(HELD))).toEqual(["jaws tool", "jaws holder"]));
  test.each([
    ["; a comment", -80],
    ["; CLAMPING CHUCK OUTSIDE D30 LENGTH20 FACE-60", -80],
  ])("with %s no contact is reported", (comment, end) => expect(contacts(turned(comment, end))).toEqual([]));
  test("a cut that ends clear of the jaws meets none of them, one that ends nearer than its holder does", () => {
    expect(contacts(turned(HELD, -50))).toEqual([]);
    expect(contacts(turned(HELD, -59))).toEqual([]);
    expect(contacts(turned(HELD, -60.5)).length).toBeGreaterThan(0);
  });
  test("a limit is a wall for tool and holder, within its ⌀", () => {
    expect(contacts(turned(`${HELD} LIMITZ-45`, -50))).toContain("limit tool");
    expect(contacts(turned(`${HELD} LIMITZ-45 LIMITX20`, -50))).toEqual([]);
  });
  test("the tailstock is met by what goes in front of the face, and by nothing that stays away from it", () => {
    const held = `${HELD} QUILL80 TIP-4 ANGLE120`;
    expect(contacts(turned(held, -50)).some((each) => each.startsWith("tailstock"))).toBe(true);
    expect(contacts(turned(`${HELD} QUILL4 TIP-2`, -50))).toEqual([]);
  });
  test("the body of the chuck is met behind its jaws, and a driver and a collet are met like them", () => {
    const long = (stated: string) => contacts(turned(`; CLAMPING ${stated}`, -79.5));
    expect(long("CHUCK INSIDE D10 LENGTH20 FACE-30 SIZE160")).toContain("chuck tool");
    expect(long("COLLET D30 LENGTH20 FACE-60 SIZE90")).toContain("collet tool");
    expect(long("BETWEEN CENTRES D60 FACE-70 QUILL10 TIP-2")).toContain("driver tool");
    expect(long("CHUCK OUTSIDE D30 LENGTH4 FACE-76 SIZE160 QUILL80 TIP-4 ANGLE120")).toContain("tailstock tool");
  });
  test("a changed clamping is recomputed for a cached run: other pieces come loose", () => {
    const again = incrementalSimulator(),
      disc = readFileSync("tests/cases/ring-out-of-a-disc.h", "utf8");
    const loose = (text: string) => again(ran(text)).proof.loose.map(({ shape }) => shape);
    const beside = disc.replace("SOFT JAWS D80", "SOFT JAWS D76");
    expect([loose(disc), loose(beside), loose(disc), loose(disc.replace(/; CLAMPING.*/, "; none"))]).toEqual([
      ["slug"],
      [],
      ["slug"],
      [],
    ]);
  });
  test("changed in a cached run, contact is recomputed", () => {
    const again = incrementalSimulator();
    const count = (text: string) => again(ran(text)).findings.filter(({ kind }) => kind === "clampContact").length;
    expect([count(turned("; none")), count(turned(HELD)), count(turned("; none"))]).toEqual([0, 2, 0]);
  });
});

test.each<[string, readonly string[]]>([
  [HELD, []],
  [`${HELD} FORCE40`, ["clampingUnread"]],
  ["; CLAMPING CHUCK OUTSIDE D30", ["clampingIncomplete"]],
  [`${HELD}\n; CLAMPING COLLET D30 LENGTH20 FACE-60 SIZE80`, ["clampingTwice"]],
  ["; CLAMPING CHUCK OUTSIDE D36 LENGTH20 FACE-60 SIZE160", ["clampingMisses"]],
])("%s tells %j", (comment, codes) => {
  const told = ran(turned(comment))
    .issues.map(({ issue }) => issue.code)
    .filter((code) => code.startsWith("clamping"));
  expect(told).toEqual(codes);
});

test("behind a block, and in an inch program, it counts as well", () => {
  const beside = turned("").replace("DIST+0", `DIST+0 ${HELD}`);
  expect(ran(beside).clamping?.clamping).toEqual({
    kind: "chuckOutside",
    diameter: 30,
    length: 20,
    face: -60,
    size: 160,
  });
  const inch = "0 BEGIN PGM A INCH\n; CLAMPING CHUCK OUTSIDE D1 LENGTH1 FACE-2 SIZE8\n1 END PGM A INCH\n";
  expect(ran(inch).clamping?.clamping).toEqual({
    kind: "chuckOutside",
    diameter: 25.4,
    length: 25.4,
    face: -50.8,
    size: 203.2,
  });
});

test("a program gets its clamping behind the blank, another one in its place, and none again", () => {
  const text = turned("; CLAMPING CHUCK OUTSIDE D30").replace(/; CLAMPING .*\n/, ""),
    program = parse(text);
  const raw = (of: typeof program) => of.blocks.map((b) => b.raw).join("");
  const draft = proposedClamping({ left: -80, right: 0, high: 15 });
  const stated = withClamping(program, draft);
  expect(raw(stated).split("\n")[2]).toBe("2 ; CLAMPING CHUCK OUTSIDE D30 LENGTH20 FACE-60 SIZE160");
  expect(clampingIn(parse(raw(stated)))?.draft).toEqual(draft);
  expect(raw(withClamping(stated, { ...draft, kind: "softJaws" })).split("\n")[2]).toContain(
    "; CLAMPING SOFT JAWS D30",
  );
  expect(raw(withClamping(stated, null))).toBe(text);
});

test("the report states the clamping, or that contact was not checked without one", () => {
  const reported = (text: string) => {
    const made = ran(text);
    return report(
      { file: "a.h", run: made, simulation: simulate(made), milliseconds: { parse: 0, plan: 0, simulate: 0 } },
      "en",
    );
  };
  const stated = reported(turned(`${HELD} QUILL4 TIP-2`, -50)),
    unstated = reported(turned("; none", -50));
  expect(stated.clamping).toMatchObject({ kind: "chuckOutside", diameter: 30, face: -60 });
  expect(summary(stated)).toContain("clamping: chuck outside, D30, front at Z-60, tailstock at Z-2");
  expect(unstated.clamping).toBeNull();
  expect(summary(unstated)).toMatch(/clamping not specified: .*contact .* not checked/);
});
