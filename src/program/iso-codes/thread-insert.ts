import { codePart, scanner, type CodePart } from "./code-part.ts";
import { LENGTHS } from "./holder-facts.ts";
import type { MakerCode } from "./maker-code-shape.ts";

/*
 * Laydown thread inserts, such as 16ER AG60 or 16 IR 2.0 ISO, and their holders, such as SER 2020 K16. Designation and
 * ranges as Iscar (turning catalogue 2017, page 489), TaeguTec (TaeguThread) and Kyocera (2021/2022) print them (tag B).
 */

const MAKERS = "Iscar, TaeguTec, Kyocera";

/** Inscribed circle by size, mm. */
const CIRCLES: Readonly<Record<string, number>> = {
  "06": 3.97,
  "08": 4.76,
  "11": 6.35,
  "16": 9.525,
  "22": 12.7,
  "27": 15.875,
};

/** Pitches of partial profiles: mm, and threads per inch. */
const RANGES: Readonly<Record<string, readonly [mm: readonly [number, number], tpi: readonly [number, number]]>> = {
  A: [
    [0.5, 1.5],
    [48, 16],
  ],
  AG: [
    [0.5, 3],
    [48, 8],
  ],
  G: [
    [1.75, 3],
    [14, 8],
  ],
  N: [
    [3.5, 5],
    [7, 5],
  ],
  Q: [
    [5.5, 6],
    [4.5, 4],
  ],
  U: [
    [5.5, 9],
    [4.5, 2.75],
  ],
};

/** Full profiles: their name, the angle between the flanks (null: they differ), and how the pitch is given. */
interface Profile {
  readonly name: string;
  readonly angle: number | null;
  readonly inch: boolean;
}
const profile = (name: string, angle: number | null, inch: boolean): Profile => ({ name, angle, inch });
const PROFILES: Readonly<Record<string, Profile>> = {
  ISO: profile("ISO 68, M", 60, false),
  MJ: profile("ISO 5855, MJ", 60, false),
  TR: profile("DIN 103, Tr", 30, false),
  SAGE: profile("DIN 513, S", null, false),
  UN: profile("UN", 60, true),
  UNJ: profile("UNJ", 60, true),
  NPT: profile("NPT", 60, true),
  NPTF: profile("NPTF", 60, true),
  W: profile("Whitworth, G", 55, true),
  BSPT: profile("BSPT, R", 55, true),
  RND: profile("DIN 405, Rd", 30, true),
  ACME: profile("ACME", 29, true),
  STACME: profile("Stub ACME", 29, true),
  ABUT: profile("American Buttress", null, true),
};

const SIDES = { E: "outside", I: "inside", EI: "both" } as const;
const sideOf = (text: string) => SIDES[text.replace("U", "") as keyof typeof SIDES];
const side = (text: string) => codePart("side", text, { is: "side", side: sideOf(text) });
const hand = (text: string) =>
  codePart("hand", text, text === "RL" ? { is: "nothing" } : { is: "hand", hand: text as "R" | "L" | "N" });
/** Orientations of the thread tools that ship: square to the axis, outside and inside. */
const ORIENTATIONS = { outside: { TO: "2" }, inside: { TO: "6" }, both: {} } as const;
const orientation = (text: string) => ORIENTATIONS[sideOf(text)];

/** Three digits without a point are hundredths of a millimetre: 100ISO is 1 mm. */
const pitchOf = (digits: string, inch: boolean) =>
  !inch && /^\d{3}$/.test(digits) ? Number(digits) / 100 : Number(digits.replace(",", "."));

function partial(letters: string, angle: string): { readonly parts: CodePart[]; readonly angle: number } | null {
  const range = RANGES[letters];
  if (!range) return null;
  const [from, to] = range[angle === "55" ? 1 : 0];
  return {
    angle: Number(angle),
    parts: [
      codePart("pitch", letters, { is: "pitches", from, to, inch: angle === "55" }),
      codePart("profile", angle, { is: "angle", angle: Number(angle) }),
    ],
  };
}

function full(digits: string, letters: string): { readonly parts: CodePart[]; readonly angle: number | null } | null {
  const known = PROFILES[letters];
  const pitch = pitchOf(digits, known?.inch ?? false);
  if (!known || !(pitch > 0)) return null;
  return {
    angle: known.angle,
    parts: [
      codePart("pitch", digits, { is: "pitches", from: pitch, to: pitch, inch: known.inch }),
      codePart("profile", letters, { is: "named", name: known.name, angle: known.angle }),
    ],
  };
}

function readInsert(text: string): MakerCode | null {
  const scan = scanner(text);
  const [size, at, of] = [
    scan.take(/^\d{2}(?=[\s\-_/·]*U?[EI])/),
    scan.take(/^U?(?:EI|E|I)/),
    scan.take(/^(?:RL|R|L|N)/),
  ];
  const circle = size === null ? undefined : CIRCLES[size];
  if (size === null || !at || !of || circle === undefined) return null;
  const make = scan.take(/^[MB](?![A-Z])/);
  const letters = scan.take(/^(?:AG|[AGNQU])(?=[\s\-_/·]*[56][05])/);
  const shape = letters
    ? partial(letters, scan.take(/^(?:60|55)/) ?? "")
    : full(scan.take(/^\d{1,3}(?:[.,]\d+)?/) ?? "", scan.take(/^[A-Z]+/) ?? "");
  if (!shape) return null;
  const rest = scan.rest().trim();
  const parts: CodePart[] = [
    codePart("circle", size, { is: "mm", mm: circle }),
    side(at),
    hand(of),
    ...(make ? [codePart("maker", make, { is: "nothing" })] : []),
    ...shape.parts,
    ...(rest ? [codePart("maker", rest, { is: "nothing" })] : []),
    codePart("source", "", { is: "named", name: MAKERS, angle: null }),
  ];
  return {
    kind: "maker",
    code: `${size}${at}${of}-${shape.parts.map((each) => each.text).join("")}`,
    parts,
    cells: {
      TYPE: "THREAD",
      ...orientation(at),
      ...(shape.angle !== null && { "P-ANGLE": String(shape.angle) }),
    },
    types: ["THREAD"],
    notes: [{ is: "cornerMissing" }, ...(shape.angle === null ? [{ is: "flanksDiffer" } as const] : [])],
  };
}

/** A holder: screw, outside or inside, hand, shank or bar, length and insert size. */
function readHolder(text: string): MakerCode | null {
  const found = /^S([EI])([RL])[\s\-_/·]*(\d{2})(\d{2})[\s\-_/·]*([A-Z])[\s\-_/·]*(\d{2})/.exec(text);
  const [, at = "", of = "", first = "", second = "", long = "", size = ""] = found ?? [];
  const [mm, circle] = [LENGTHS[long], CIRCLES[size]];
  if (!found || mm === undefined || circle === undefined) return null;
  const across = Number(second);
  return {
    kind: "maker",
    code: `S${at}${of}${first}${second}${long}${size}`,
    parts: [
      codePart("clamping", "S", { is: "clamping", clamping: "screw" }),
      side(at),
      hand(of),
      ...(at === "I"
        ? [codePart("diameter", first + second, { is: "mm", mm: Number(first + second) })]
        : [
            codePart("height", first, { is: "mm", mm: Number(first) }),
            codePart("width", second, { is: "mm", mm: across }),
          ]),
      codePart("length", long, { is: "mm", mm }),
      codePart("circle", size, { is: "mm", mm: circle }),
      codePart("source", "", { is: "named", name: MAKERS, angle: null }),
    ],
    cells: { TYPE: "THREAD", ...orientation(at) },
    types: ["THREAD"],
    notes: [{ is: "holderUnplaced" }],
  };
}

/** Reads a thread insert or its holder, in capital letters; null for other codes. */
export const readThreadCode = (text: string): MakerCode | null => readInsert(text) ?? readHolder(text);
