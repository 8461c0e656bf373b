import type { FinishedPart } from "../../src/planning/part/finished-part.ts";
import { PART_FORMAT, readPart } from "../../src/planning/part/part-file.ts";

type Row = Readonly<Record<string, unknown>>;

/** A bar part as a part file states it, without what the drawings of all have in common. */
export const barPart = (name: string, outside: readonly Row[], more: Row = {}): FinishedPart => {
  const { part, problems } = readPart(
    JSON.stringify({ format: PART_FORMAT, name, material: "c45", outside, partsOff: true, ...more }),
  );
  if (!part) throw new Error(`${name}: ${JSON.stringify(problems)}`);
  return part;
};

const FRONT = { x: 0, z: 0 };

/** Parts for which the built-in tools lack one, by what they need. */
export const MISSING_PARTS = {
  "thread in a bore": barPart("THREADED SLEEVE", [FRONT, { x: 45 }, { z: -36 }], {
    inside: [
      { x: 24, z: 0 },
      { x: 20, z: -2 },
      { id: "bore", z: -36 },
    ],
    marks: { bore: { thread: "M20x1.5" } },
  }),
  "countersink of a bore": barPart("FITTING", [FRONT, { x: 30 }, { z: -36 }], {
    inside: [
      { x: 13, z: 0 },
      { x: 12, z: -0.5 },
      { id: "bore", z: -36 },
    ],
  }),
  "thread in front of a shallow relief": barPart(
    "STUD",
    [FRONT, { x: 16 }, { kind: "CHF", r: 1.5 }, { id: "thread", z: -24 }, { kind: "UDC" }, { x: 22 }, { z: -34 }],
    { marks: { thread: { thread: "M16" } } },
  ),
  "narrow groove in a face": barPart("SEALED COVER", [
    FRONT,
    { x: 60 },
    {
      id: "seal",
      kind: "GRV",
      form: "AXIAL",
      words: { CENTER: 40, BREADTH: 2.4, DEPTH: -3 },
    },
    { z: -20 },
  ]),
  "rounded groove in a bore": barPart("BUSH FOR A CIRCLIP", [FRONT, { x: 50 }, { z: -30 }], {
    inside: [
      { x: 30, z: 0 },
      { id: "bore", z: -30 },
      { kind: "GRV", form: "RADIAL", words: { CENTER: -10.65, BREADTH: 1.3, DEPTH: 0.7, R: 0.2 } },
    ],
    marks: { bore: { tolerance: "H7", ra: 1.6 } },
  }),
  "deep bore of small diameter": barPart("GUIDE", [FRONT, { x: 24 }, { z: -50 }], {
    inside: [
      { x: 7.5, z: 0 },
      { id: "bore", z: -50 },
    ],
    marks: { bore: { tolerance: "H7", ra: 1.6 } },
  }),
  "undercut F behind a shoulder": barPart(
    "COLLARED PIN",
    [
      FRONT,
      { x: 30 },
      { z: -10 },
      { x: 22 },
      { id: "seat", z: -40 },
      { id: "relief", kind: "UDC" },
      { x: 32 },
      { z: -50 },
    ],
    { marks: { seat: { tolerance: "h6", ra: 1.6 }, relief: { undercut: "DIN 509-F 0.6x0.3" } } },
  ),
  "valley with a steep rear flank": barPart("SPOOL PIN", [
    FRONT,
    { x: 36 },
    { z: -10 },
    { x: 24, z: -16 },
    { kind: "RND", r: 1 },
    { x: 36, z: -17 },
    { z: -40 },
  ]),
} as const;
