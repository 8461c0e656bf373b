import { describe, expect, test } from "vitest";
import type { ContourChoice, DrawnContour } from "../../src/program/drawing/drawing.ts";
import { contourOf, propose, readDrawing } from "../../src/program/drawing/formats.ts";
import { readRows } from "../../src/program/job/contour-rows.ts";
import { entityCases } from "./entity-cases.ts";
import { REFERENCE } from "./shaft.ts";
import { viewCases } from "./view-cases.ts";
import { arc, asText, dxfGroups, line, MM, polyline, utf8, type Entity } from "./dxf-file.ts";

/** Rows as short words: X24 Z0 | CR X32 Z-22 R4 cw. */
const short = ({ rows }: DrawnContour) =>
  rows
    .map((r) =>
      [r.kind === "CR" ? "CR" : "", r.x && `X${r.x}`, r.z && `Z${r.z}`, r.r && `R${r.r}`, r.kind === "CR" ? r.turn : ""]
        .filter((word) => word !== "")
        .join(" "),
    )
    .join(" | ");
const read = (bytes: Uint8Array, unit?: "mm" | "inch") => readDrawing({ name: "part.dxf", bytes }, unit && { unit });
const taken = async (bytes: Uint8Array, given: Partial<ContourChoice> = {}) => {
  const drawing = await read(bytes),
    choice = propose(drawing, given);
  return { drawing, choice, made: contourOf(drawing, choice) };
};
const mm = (entities: readonly Entity[]) => utf8(asText(dxfGroups({ header: MM, entities })));
const codes = (notes: readonly { readonly code: string }[]) => notes.map((n) => n.code);

describe("one shaft in the manners of many programs", () => {
  const cases = [...entityCases, ...viewCases].map(([name, bytes, contour, notes = []]) => ({
    name,
    bytes,
    contour,
    notes,
  }));
  test.each(cases)("$name", async ({ bytes, contour, notes }) => {
    const { drawing, made } = await taken(bytes);
    expect(short(made)).toBe(contour);
    expect(codes([...drawing.notes, ...made.notes])).toEqual(notes);
    expect(readRows(made.rows).issues).toEqual([]);
  });

  test("texts and dimensions are hints with their places", async () => {
    const bytes = entityCases.find(([name]) => name.startsWith("dimensions"))?.[1] ?? utf8("");
    expect((await read(bytes)).texts).toEqual([
      { text: "⌀24", at: { z: 5, r: 5 } },
      { text: "R4", at: { z: 5, r: 9 } },
      { text: "24H7", at: { z: -9, r: 20 } },
    ]);
  });
});

describe("sections", () => {
  const bush = mm([
    polyline(true, [
      [0, 11],
      [0, 20],
      [-30, 20],
      [-30, 26],
      [-52, 26],
      [-52, 11],
    ]),
  ]);
  /** A blind bore ⌀16 with a point, in a part of ⌀40, both halves with the edges behind the section. */
  const blind = [1, -1].flatMap((s) => [
    line(0, 8 * s, -30, 8 * s),
    line(-30, 8 * s, -34, 0),
    line(0, 20 * s, -50, 20 * s),
  ]);
  const section = mm([...blind, line(0, -20, 0, 20), line(-30, -8, -30, 8), line(-50, -20, -50, 20)]);

  test.each([
    ["outside of a bush", bush, {}, "X22 Z0 | X40 | Z-30 | X52 | Z-52"],
    ["bore of a bush", bush, { side: "bore" }, "X22 Z0 | Z-52"],
    ["bore of a bush from the other end", bush, { side: "bore", reversed: true }, "X22 Z-52 | Z0"],
    ["blind bore, outside", section, {}, "X0 Z0 | X40 | Z-50"],
    ["blind bore, inside", section, { side: "bore" }, "X16 Z0 | Z-30 | X0 Z-34"],
    [
      "half of a section, closed along the axis: the rear face is left out",
      mm([polyline(true, [[0, 0], [0, 10], [-20, 10], [-20, 0]])]), // oxfmt-ignore
      {},
      "X0 Z0 | X20 | Z-20",
    ],
    [
      "a half drawn far from the origin, whose ends lie on its axis",
      mm([polyline(false, [[500, 400], [500, 412], [518, 412], [518, 427], [546, 427], [546, 400]])]), // oxfmt-ignore
      {},
      "X0 Z0 | X54 | Z-28 | X24 | Z-46",
    ],
    [
      "open along its axis from the origin, whose face lies on the other axis",
      mm([polyline(false, [[0, 0], [0, 12], [25, 12], [31, 18], [50, 18], [50, 0]])]), // oxfmt-ignore
      { mirrored: true, zero: 0 },
      "X0 Z0 | X24 | Z-25 | X36 Z-31 | Z-50",
    ],
    [
      "ball end on the axis",
      mm([arc(-10, 0, 10, 0, 90), line(-10, 10, -40, 10)]),
      {},
      "X0 Z0 | CR X20 Z-10 R10 ccw | Z-40",
    ],
  ] as const)("%s", async (_, bytes, given, contour) => {
    const { made } = await taken(bytes, given);
    expect(short(made)).toBe(contour);
    expect(made.hasSides).toBe(bytes === bush || bytes === section);
  });
});

/** Both halves of a section away from the origin, without a centre line, their axis along X or along Y. */
const rings = (half: readonly (readonly [along: number, across: number])[], isUpright: boolean) =>
  mm(
    [1, -1].map((s) =>
      polyline(
        true,
        half.map(([z, r]) => (isUpright ? [100 + s * r, 80 + z] : [80 + z, 100 + s * r])),
      ),
    ),
  );
const RING = [[0, 11], [0, 20], [-30, 20], [-30, 11]] as const; // oxfmt-ignore

describe("a ring without a centre line, away from the origin", () => {
  test.each([
    ["plain", RING, "X22 Z0 | X40 | Z-30", "X22 Z0 | Z-30"],
    [
      "as wide as it is high",
      [
        [0, 11],
        [0, 20],
        [-9, 20],
        [-9, 11],
      ],
      "X22 Z0 | X40 | Z-9",
      "X22 Z0 | Z-9",
    ],
    ["chamfered", [[0, 11], [0, 19], [-1, 20], [-29, 20], [-30, 19], [-30, 11]], "X22 Z0 | X38 | X40 Z-1 | Z-29 | X38 Z-30", "X22 Z0 | Z-30"], // oxfmt-ignore
  ] as const)("%s: its axis is between its halves, not along one", async (_, half, outside, bore) => {
    for (const isUpright of [false, true]) {
      const bytes = rings(half, isUpright);
      expect(short((await taken(bytes)).made)).toBe(outside);
      expect(short((await taken(bytes, { side: "bore" })).made)).toBe(bore);
    }
  });

  test("a spool keeps its axis: its edges cross the line between its halves", async () => {
    const spool = [[0, 0], [0, 12], [-4, 12], [-4, 20], [-26, 20], [-26, 12], [-30, 12], [-30, 0]] as const; // oxfmt-ignore
    const lines = [1, -1].flatMap((s) =>
      spool.slice(1).map(([z, r], i) => line(80 + (spool[i]?.[0] ?? 0), 100 + s * (spool[i]?.[1] ?? 0), 80 + z, 100 + s * r)),
    ); // oxfmt-ignore
    expect(short((await taken(mm(lines))).made)).toBe("X0 Z0 | X24 | Z-4 | X40 | Z-26 | X24 | Z-30");
  });
});

describe("gaps", () => {
  const broken = (gap: number) => mm([line(0, 12, -18 + gap, 12), arc(-18, 16, 4, 180, 270), line(-22, 16, -22, 27 - gap), line(-22, 27, -46, 27)]); // oxfmt-ignore

  test("are joined up to the tolerance, each with its width and place: lines give way to arcs, corners stay corners", async () => {
    const { drawing, choice, made } = await taken(broken(0.05));
    expect(choice.gap).toBe(0.1);
    expect(short(made)).toBe(REFERENCE);
    expect([...drawing.notes, ...made.notes].map((n) => [n.code, n.values, n.at])).toEqual([
      ["gapJoined", { width: expect.closeTo(0.05, 6), x: 24, z: expect.closeTo(-17.975, 6) }, { z: expect.closeTo(-17.975, 6), r: 12 }],
      ["gapJoined", { width: expect.closeTo(0.05, 6), x: expect.closeTo(53.95, 6), z: -22 }, { z: -22, r: expect.closeTo(26.975, 6) }],
    ]); // oxfmt-ignore
  });

  test("that are wider are named, and cut the contour", async () => {
    const { made } = await taken(broken(0.4));
    expect(made.pieces).toHaveLength(3);
    expect(made.notes.filter((n) => n.code === "gapOpen").map((n) => n.values)).toEqual([
      { width: expect.closeTo(0.4, 6), x: expect.closeTo(53.6, 6), z: 0 },
    ]);
    const joined = (await taken(broken(0.4), { gap: 0.5 })).made;
    expect(short(joined)).toBe(REFERENCE);
  });

  test("a line that ends short of the middle of another is joined there", async () => {
    const { made } = await taken(mm([line(0, 12, -21.95, 12), line(-22, 0, -22, 27), line(-22, 27, -46, 27)]), {
      gap: 0.1,
    });
    expect(short(made)).toBe("X24 Z0 | Z-22 | X54 | Z-46");
  });
});

describe("choices", () => {
  const two = mm([line(0, 12, -20, 12), line(-20, 12, -20, 18), line(-60, 9, -50, 9), line(0, -5, -40, -5)]);

  test.each([
    ["the second piece", { piece: 1, half: "upper" }, "X18 Z0 | Z-10"],
    ["the lower half", { half: "lower" }, "X10 Z0 | Z-40"],
    ["a place of Z0", { zero: -20 }, "X24 Z20 | Z0 | X36"],
    ["Z mirrored", { zero: -20, mirrored: true }, "X36 Z0 | X24 | Z-20"],
    ["an axis of rotation", { axis: "x", axisAt: 2 }, "X20 Z0 | Z-20 | X32"],
    ["diameters", { diameters: true, half: "upper" }, "X12 Z0 | Z-20 | X18"],
  ] as const)("%s", async (_, given, contour) => {
    expect(short((await taken(two, { axis: "x", axisAt: 0, half: "upper", ...given })).made)).toBe(contour);
  });

  test("a unit that is chosen replaces that of the file", async () => {
    const drawing = await read(utf8(asText(dxfGroups({ entities: [line(0, 1, -2, 1)] }))), "inch");
    expect(drawing.unit).toEqual({ unit: "inch", source: "chosen" });
    expect(short(contourOf(drawing, propose(drawing)))).toBe("X50.8 Z0 | Z-50.8");
  });

  test("arcs whose distances are diameters are elliptical on the part and fitted", async () => {
    const { made } = await taken(mm([line(0, 12, -10, 12), arc(-10, 22, 10, 180, 270)]), { diameters: true });
    expect(made.rows.length).toBeGreaterThan(4);
    for (const { from } of made.segments)
      expect(Math.hypot((from.r * 2 - 22) / 10, (from.z + 10) / 10) >= 0.999 || from.r * 2 === 12).toBe(true);
  });

  test("layers that are left out, thin lines that are taken", async () => {
    const bytes = mm([
      line(0, 12, -20, 12, "8 A"),
      line(-20, 12, -20, 18, "8 B"),
      line(-20, 18, -30, 18, "8 0 6 HIDDEN"),
    ]);
    expect(short((await taken(bytes, { withoutLayers: ["B"] })).made)).toBe("X24 Z0 | Z-20");
    expect(short((await taken(bytes, { thin: true })).made)).toBe("X24 Z0 | Z-20 | X36 | Z-30");
  });
});

describe("what cannot be taken is said", () => {
  test.each([
    ["another kind of file", utf8("%PDF-1.4"), "part.pdf", "unknownKind"],
    ["no DXF in a DXF file", utf8("hello"), "part.dxf", "unreadable"],
    ["an empty file", new Uint8Array(), "part.dxf", "unreadable"],
    ["no lines", mm(["TEXT 8 0 10 0 20 0 1 x"]), "part.dxf", "nothing"],
    ["too many lines", mm(Array.from({ length: 20_100 }, (_, i) => line(0, i, 1, i))), "part.dxf", "tooMany"],
    ["a bomb of blocks", utf8(asText(dxfGroups({ entities: ["INSERT 8 0 2 B9 10 0 20 0"], blocks: Object.fromEntries(Array.from({ length: 10 }, (_, i) => [`B${i}`, i === 0 ? [line(0, 1, 1, 2)] : Array.from({ length: 10 }, () => `INSERT 8 0 2 B${i - 1} 10 0 20 0 70 9 71 9`)])) }))), "part.dxf", "tooMany"], // oxfmt-ignore
  ])("%s", async (_, bytes, name, code) => {
    const drawing = await readDrawing({ name, bytes });
    expect(drawing.curves).toEqual([]);
    expect(drawing.notes[0]).toMatchObject({ code, severity: "error" });
    expect(contourOf(drawing, propose(drawing)).rows).toEqual([]);
  });

  test("lines on the axis alone are no contour", async () => {
    expect(codes((await taken(mm([line(0, 0, -10, 0)]), { axisAt: 0 })).made.notes)).toContain("onlyAxis");
  });

  /* A half from ⌀24 to ⌀36 with its right end 60 from the origin, moved across by `up`, with what shows the axis. */
  test.each([
    ["far from the origin, nothing on its axis", 60, 40, [], true],
    ["far from the origin along the axis", 60, 0, [], true],
    ["its face at the origin", 0, 0, [], false],
    ["its face before the origin by an allowance", 1, 0, [], false],
    ["a centre line", 60, 0, [line(0, 0, 70, 0, "8 0 6 CENTER")], false],
    ["a line down to the axis", 60, 0, [line(60, 12, 60, 0)], false],
    ["the other half", 60, 0, [line(60, -12, 40, -12)], false],
  ] as const)("the place of the axis: %s", async (_, right, up, more, told) => {
    const half = [line(right, up + 12, right - 20, up + 12), line(right - 20, up + 12, right - 20, up + 18), line(right - 20, up + 18, right - 30, up + 18)]; // oxfmt-ignore
    const { made } = await taken(mm([...half, ...more]), { axis: "x", axisAt: 0 });
    const found = made.notes.filter(({ code }) => code === "axisUnmarked");
    expect(found).toMatchObject(!told ? [] : [{ severity: "warning", values: { x: 24 + 2 * up } }]);
  });
});
