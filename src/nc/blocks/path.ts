import { readWords } from "../read-words.ts";
import { noWords, type PathKind, type Words } from "../words.ts";
import { VALUE } from "../value.ts";
import { defineBlock, type Field, type BlockReading } from "./define.ts";
import {
  axesIn,
  axisFields,
  feedField,
  pathWords,
  polarAngleField,
  polarFields,
  radiusField,
  retractField,
  straightTailFields,
  tailFields,
  turnField,
  withoutPicture,
} from "./path-words.ts";
import { cut, TO_CUT } from "./sample.ts";
import { property } from "./words.ts";

const fieldsOf = (words: Words, { path }: { readonly path: PathKind }) => {
  switch (path) {
    case "L":
      return [...axisFields(words), ...straightTailFields, ...(words.retract === undefined ? [] : [retractField])];
    case "LP":
    case "CTP":
      return [...polarFields, ...axisFields(words, []), ...tailFields];
    case "C":
      // A changed end point alone would be off the arc.
      return [
        ...axisFields(words).map((field) =>
          field.id === "X" || field.id === "Z" ? withoutPicture(field, "together") : field,
        ),
        turnField,
        ...tailFields,
      ];
    case "CP":
      return [polarAngleField, ...axisFields(words, []), turnField, ...tailFields];
    case "CR":
      return [...axisFields(words), radiusField, turnField, ...tailFields];
    case "CT":
      return [...axisFields(words), ...tailFields];
    case "CC":
      return axisFields(words);
    case "RND":
      return [{ ...radiusField, spread: { times: [0.5, 2] } } satisfies Field<Words, "radius">, feedField];
  }
};

/** A line with the letter of a path function but none of its words is something else. */
const saysNothing = (words: Words) =>
  words.extra !== undefined && words.axes.length + words.functions.length === 0 && Object.keys(words).length === 3;

const BARE = new RegExp(VALUE, "iy");

function readRounding({ scan }: BlockReading): Words {
  const bare = scan.take(BARE);
  const value = bare && scan.value(bare[0]);
  const words = readWords(scan, true);
  if (value === null && words.radius === undefined) scan.missing("R");
  return value === null ? words : { ...words, radius: value };
}

const at = (x: number, z: number): Words["axes"] => [
  { axis: "X", value: x, incremental: false },
  { axis: "Z", value: z, incremental: false },
];
const polar = { polarRadius: { value: 10, incremental: false }, polarAngle: { value: 0, incremental: false } };
const offered = <P extends PathKind>(path: P, words: Partial<Words>) =>
  ({ group: "path", begins: { kind: "path", path: path as PathKind, words: { ...noWords, ...words } } }) as const;

/** Lines and arcs, their pole, and the rounding of a corner. */
export const path = defineBlock({
  kind: "path",
  // C with a number behind it is a coordinate; a coordinate alone is a straight line.
  begins: String.raw`(?:CTP|CR|CT|CC|CP|LP|L|RND|C(?![ \t]*[+\-.\d]))(?![A-Z_])|(?=I?[XYZABCUVW][ \t]*${VALUE})`,
  words: [
    property<PathKind>()("path", { compareAs: (form, said) => void said.put("", form) }),
    pathWords(fieldsOf, {
      signs: ({ path: form }: { readonly path: PathKind }) => ({ length: true, radius: form !== "RND" }),
    }),
  ],
  read(reading) {
    const { scan } = reading;
    const form = (reading.head || "L").toUpperCase() as PathKind;
    if (form === "RND") return { kind: "path", path: form, words: readRounding(reading) };
    const words = readWords(scan, form === "CR");
    if (saysNothing(words)) return null;
    if (form === "CR" && words.radius === undefined) scan.missing("R");
    if ((form === "CR" || form === "C" || form === "CP") && words.turn === undefined) scan.missing("DR");
    return { kind: "path", path: form, words };
  },
  lead: (s) => s.path,
  nameKey: (s) => `${s.path} ${axesIn(s.words)}`,
  tags: ["waits"],
  nameOf: (s) => s.path,
  names: {
    L: {
      offered: offered("L", { axes: at(50, 2), feed: "max" }),
      sample: cut("L X+42 Z+2 FMAX", "> L X+46 Z-25 F0.25"),
      samples: { compensation: cut("L X+42 Z+2 R0 FMAX", "> L X+46 Z-25 R0 F0.25") },
    },
    C: {
      offered: offered("C", { axes: at(50, -10), turn: "cw" }),
      sample: cut(...TO_CUT, "CC X+60 Z-12", "> C X+60 Z-20 DR-"),
      samples: { feed: cut(...TO_CUT, "CC X+60 Z-12", "> C X+60 Z-20 DR- F0.2") },
    },
    CC: {
      offered: offered("CC", { axes: at(0, 0) }),
      sample: cut(...TO_CUT, "> CC X+30 Z-12", "LP PR+10 PA+120"),
    },
    CR: {
      offered: offered("CR", { axes: at(50, -10), radius: 10, turn: "cw" }),
      sample: cut(...TO_CUT, "> CR X+50 Z-20 R10 DR+"),
      samples: { feed: cut(...TO_CUT, "> CR X+50 Z-20 R10 DR+ F0.2") },
    },
    CT: {
      offered: offered("CT", { axes: at(50, -10) }),
      sample: cut(...TO_CUT, "> CT X+49 Z-22"),
      samples: { feed: cut(...TO_CUT, "> CT X+49 Z-22 F0.2") },
    },
    LP: {
      offered: offered("LP", polar),
      sample: cut(...TO_CUT, "CC X+30 Z-12", "> LP PR+12 PA+125"),
      samples: { feed: cut(...TO_CUT, "CC X+30 Z-12", "> LP PR+12 PA+125 F0.2") },
    },
    CP: {
      offered: offered("CP", { polarAngle: polar.polarAngle, turn: "cw" }),
      sample: cut(...TO_CUT, "CC X+60 Z-12", "> CP PA+220 DR-"),
      samples: { feed: cut(...TO_CUT, "CC X+60 Z-12", "> CP PA+220 DR- F0.2") },
    },
    CTP: {
      offered: offered("CTP", polar),
      sample: cut(...TO_CUT, "CC X+30 Z-12", "> CTP PR+14 PA+130"),
      samples: { feed: cut(...TO_CUT, "CC X+30 Z-12", "> CTP PR+14 PA+130 F0.2") },
    },
    RND: {
      offered: offered("RND", { radius: 1 }),
      sample: cut(...TO_CUT, "L Z-20", "> RND R3", "L X+58"),
      samples: { feed: cut(...TO_CUT, "L Z-20", "> RND R6 F0.1", "L X+58") },
    },
  },
});
