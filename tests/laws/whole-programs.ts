import fc from "fast-check";

/*
 * Random whole programs of a shop: parts off the bar, each with a face, a shoulder, grooves and chamfers by cycle or by
 * feed, one behind another by a datum shift. The intended part is known from the construction.
 */

/** The planted fault; null: none. */
export type Planted =
  | null
  | "turned after it was parted off"
  | "groove that nobody meant"
  | "feed through a shoulder"
  | "rapid behind the blank"
  | "turned behind the blank"
  | "turned over the whole length";

/** The finding code expected for each planted fault. */
export const EXPECTED_CODE: Readonly<Record<Exclude<Planted, null>, string>> = {
  "turned after it was parted off": "cutOnLoosePiece",
  "groove that nobody meant": "cutBelowContour",
  "feed through a shoulder": "gouge",
  "rapid behind the blank": "behindBlank",
  "turned behind the blank": "behindBlank",
  "turned over the whole length": "behindBlank",
};

/** One part of the bar: diameters and lengths, mm. */
interface PartOfBar {
  readonly inner: number;
  readonly shoulder: number;
  readonly length: number;
  readonly cycle: 811 | 812;
  /** How a groove on the turned cylinder and one on the bar behind the shoulder are cut. */
  readonly grooves: readonly ["cycle" | "feed" | null, "cycle" | "feed" | null];
  readonly chamfer: boolean;
  readonly partedBy: "cycle" | "feed";
}

export interface WholeProgram {
  readonly text: string;
  readonly planted: Planted;
  readonly parts: number;
}

const OUTSIDE = 40;
const BLADE = 3;

const list = (number: number, name: string, values: Readonly<Record<string, number>>): string => {
  const lines = Object.entries(values).map(([q, n]) => `    ${q}=${n >= 0 ? "+" : ""}${n} ;P`);
  return `CYCL DEF ${number} ${name} ~\n${lines.join(" ~\n")}`;
};
const away = ["L X+200 FMAX", "L Z+100 FMAX"];
const toolOf = (T: number): string[] => [
  `TOOL CALL ${T}`,
  "FUNCTION TURNDATA SPIN VCONST:ON VC:120 SMAX2000",
  "M136",
  "L X+200 Z+100 R0 FMAX M303",
];
const turned = ({ inner, shoulder, cycle }: PartOfBar, end = -shoulder): string[] => {
  const common = { Q463: 2.5, Q478: 0.3, Q483: 0.4, Q484: 0.1, Q505: 0.2, Q506: 0 };
  const values =
    cycle === 811
      ? { Q215: 0, Q460: 2, Q493: inner, Q494: end, ...common }
      : {
          Q215: 0,
          Q460: 2,
          Q491: OUTSIDE,
          Q492: 0,
          Q493: inner,
          Q494: end,
          Q495: 0,
          Q501: 0,
          Q502: 0,
          Q500: 0.8,
          Q496: 0,
          Q503: 0,
          Q504: 0,
          ...common,
        };
  return [...toolOf(1), list(cycle, "SHOULDER", values), `L X+${OUTSIDE} Z+2 FMAX`, "CYCL CALL", ...away];
};
const recess = (bottom: number, from: number, width: number): string[] => [
  ...toolOf(9),
  list(861, "SIMPLE RECESS, RADL.", {
    Q215: 1,
    Q460: 2,
    Q493: bottom,
    Q494: from - width,
    Q478: 0.08,
    Q483: 0,
    Q484: 0,
    Q505: 0.1,
    Q463: 0,
    Q510: 0.8,
    Q511: 100,
    Q462: 0,
    Q211: 0,
    Q562: 0,
  }),
  `L X+${OUTSIDE + 4} Z${from} FMAX`,
  "CYCL CALL",
  ...away,
];
/** The position of the blade is the middle of its edge. */
const plunged = (bottom: number, from: number, meant: boolean): string[] => [
  ...toolOf(9),
  `L X+${OUTSIDE + 4} Z${from - BLADE / 2} FMAX`,
  ...(meant ? ["; INTENDED CUT"] : []),
  `L X${bottom >= 0 ? "+" : ""}${bottom} F0.08`,
  `L X+${OUTSIDE + 4} F0.5`,
  ...away,
];
const chamfered = (inner: number, meant: boolean): string[] => [
  ...toolOf(3),
  `L X+${inner - 8} Z+3 FMAX`,
  ...(meant ? ["; INTENDED CUT"] : []),
  `L X+${inner + 4} Z-3 F0.1`,
  ...away,
];

function partLines(part: PartOfBar): string[] {
  const {
    inner,
    shoulder,
    length,
    grooves: [onCylinder, onBar],
    chamfer,
    partedBy,
  } = part;
  const groove = (by: "cycle" | "feed" | null, bottom: number, at: number, meant: boolean) =>
    by === "cycle" ? recess(bottom, at, BLADE + 1) : by === "feed" ? plunged(bottom, at, meant) : [];
  return [
    ...turned(part),
    ...groove(onCylinder, inner - 4, -4, true),
    ...groove(onBar, OUTSIDE - 4, -shoulder - 3, false),
    ...(chamfer ? chamfered(inner, true) : []),
    ...(partedBy === "cycle" ? recess(0, -length, BLADE) : plunged(-0.4, -length, false)),
  ];
}

const parts = fc
  .record({
    inner: fc.integer({ min: 22, max: 34 }),
    shoulder: fc.integer({ min: 14, max: 24 }),
    behind: fc.integer({ min: 12, max: 20 }),
    cycle: fc.constantFrom<811 | 812>(811, 812),
    grooves: fc.tuple(fc.constantFrom("cycle", "feed", null), fc.constantFrom("cycle", "feed", null)),
    chamfer: fc.boolean(),
    partedBy: fc.constantFrom<"cycle" | "feed">("cycle", "feed"),
  })
  .map(({ behind, ...part }): PartOfBar => ({ ...part, length: part.shoulder + behind }));

const PLANTED: readonly Planted[] = [
  null,
  null,
  null,
  "turned after it was parted off",
  "groove that nobody meant",
  "feed through a shoulder",
  "rapid behind the blank",
  "turned behind the blank",
  "turned over the whole length",
];

/** The lines of a fault, with the datum at the face of the last part; `rear` is the end of the blank, from there. */
function faultLines(planted: Planted, part: PartOfBar, rear: number): readonly string[] {
  switch (planted) {
    case "turned after it was parted off":
      return turned({ ...part, inner: part.inner - 6 });
    case "groove that nobody meant":
      return [...turned(part), ...plunged(part.inner - 2, -8, false)];
    case "feed through a shoulder":
      return [
        ...turned(part),
        ...toolOf(1),
        `L X+${part.inner + 1} Z+2 FMAX`,
        `L Z${-part.shoulder - 6} F0.3`,
        `L X+${OUTSIDE + 20} FMAX`,
        ...away,
      ];
    case "rapid behind the blank":
      return [
        ...toolOf(9),
        `L X+${OUTSIDE + 20} Z+5 FMAX`,
        `L Z${rear - 12} FMAX`,
        `L X+${OUTSIDE - 10} FMAX`,
        `L X+${OUTSIDE + 20} FMAX`,
        ...away,
      ];
    case "turned behind the blank":
      return turned(part, rear - 9);
    case "turned over the whole length":
      return turned(part, rear);
    case null:
      return [];
  }
}

/** Programs without a fault, and programs with one. */
export const wholePrograms: fc.Arbitrary<WholeProgram> = fc
  .tuple(fc.array(parts, { minLength: 1, maxLength: 3 }), fc.constantFrom(...PLANTED), fc.boolean())
  .map(([made, planted, faced]) => {
    const last = made.at(-1) as PartOfBar;
    const total = made.reduce((sum, { length }) => sum + length + BLADE, 0);
    const blank = total + 60;
    const allowance = faced ? 1 : 0;
    // A parted-off piece is turned where it was; the other faults are on the remaining bar.
    const stays = planted === "turned after it was parted off";
    const shift = (by: number) => [
      "CYCL DEF 7.0 DATUM SHIFT",
      `CYCL DEF 7.1 Z${by <= 0 ? "" : "+"}${by === 0 ? "+0" : by}`,
    ];
    let gone = 0;
    const lines = made.flatMap((part, i) => {
      const own = [...shift(-gone), ...partLines(part)];
      gone += i === made.length - 1 && stays ? 0 : part.length + BLADE;
      return own;
    });
    const text = [
      "BEGIN PGM SHOP MM",
      `BLK FORM CYLINDER Z D${OUTSIDE} L${blank + allowance} DIST+${allowance}`,
      "FUNCTION MODE TURN",
      ...(faced ? [...toolOf(1), `L X+${OUTSIDE + 4} Z+0 FMAX`, "L X-1.6 F0.15", "L Z+2 FMAX", ...away] : []),
      ...lines,
      ...shift(-gone),
      ...faultLines(planted, last, gone - blank),
      "M30",
      "END PGM SHOP MM",
    ];
    let number = 0;
    return {
      text: text.map((line) => (line.startsWith(";") ? line : `${number++} ${line}`)).join("\n") + "\n",
      planted,
      parts: made.length,
    };
  });
