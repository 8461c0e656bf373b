import { codePart, type CodePart } from "./code-part.ts";
import type { MakerCode, MakerNote } from "./maker-code-shape.ts";

/*
 * Groove and part-off inserts whose makers put width and corner into the designation. One line a family; where the only
 * evidence is the common use of the code, it is said. Families that number their inserts are not read at all.
 */

interface Family {
  readonly maker: string;
  /** Groups: `name`, `width`, and where the code has them `radius`, `angle` (front edge) and `hand`. */
  readonly pattern: RegExp;
  /** Digits of width and radius for one millimetre; 1 where they are written with a point. */
  readonly width: number;
  readonly radius?: number;
  /** A full radius: round across its width. */
  readonly isRound?: true;
  readonly type: "RECESS" | "RECTURN";
  /** False: no list of the maker was at hand. */
  readonly verified: boolean;
  readonly holder?: { readonly to: string };
}

const GAP = String.raw`[\s\-_/·]*`;
const family = (pattern: string) => new RegExp(`^${pattern.replaceAll(" ", GAP)}`);

const FAMILIES: readonly Family[] = [
  // L123G2-0300-0502-CM has CW 3, 5° and RE 0.2 in the list of the maker.
  {
    maker: "Sandvik CoroCut 1-2",
    pattern: family("(?<name>(?<hand>[NRL])123 [A-Z](?: \\d)?) (?<width>\\d{4}) (?<angle>\\d{2})(?<radius>\\d{2})"),
    width: 100,
    radius: 10,
    type: "RECESS",
    verified: true,
  },
  {
    maker: "Sandvik CoroCut 1-2",
    pattern: family("(?<name>(?<hand>[NRL])123 [A-Z](?: \\d)?) (?<width>\\d{4}) R[OMSE]"),
    width: 100,
    isRound: true,
    type: "RECESS",
    verified: false,
  },
  // GRIP 3002Y has CW 3 and RE 0.2, HFPL 6004 CW 6 and RE 0.4.
  {
    maker: "Iscar DO-GRIP",
    pattern: family("(?<name>DG(?<hand>[NRL])) (?<width>\\d{2})(?<radius>\\d{2}) [A-Z]*(?: (?<angle>\\d{1,2})D)?"),
    width: 10,
    radius: 10,
    type: "RECESS",
    verified: true,
  },
  {
    maker: "Iscar CUT-GRIP",
    pattern: family("(?<name>GRIP) (?<width>\\d{2})(?<radius>\\d{2})"),
    width: 10,
    radius: 10,
    type: "RECTURN",
    verified: true,
  },
  {
    maker: "Iscar HELIFACE",
    pattern: family("(?<name>HFP(?<hand>[NRL])) (?<width>\\d{2})(?<radius>\\d{2})"),
    width: 10,
    radius: 10,
    type: "RECTURN",
    verified: true,
  },
  {
    maker: "Iscar CUT-GRIP",
    pattern: family("(?<name>G[IP][PFMN]) (?<width>\\d\\.\\d{1,2})E? (?<radius>\\d\\.\\d{1,2})"),
    width: 1,
    radius: 1,
    type: "RECTURN",
    verified: false,
  },
  // LCMF 031304-CM has CW 3, 13 mm and RE 0.4.
  {
    maker: "Dormer Pramet",
    pattern: family("(?<name>LC[GM][A-Z]) (?<width>\\d{2})\\d{2}(?<radius>\\d{2})"),
    width: 1,
    radius: 10,
    type: "RECTURN",
    verified: true,
  },
  {
    maker: "TaeguTec T-CLAMP",
    pattern: family("(?<name>TDT) (?<width>\\d+(?:\\.\\d+)?)E? (?<radius>\\d\\.\\d+)"),
    width: 1,
    radius: 1,
    type: "RECTURN",
    verified: false,
  },
  {
    maker: "TaeguTec T-CLAMP",
    pattern: family("(?<name>TD[CJ]) (?<width>\\d)(?![\\d.])(?: (?<angle>\\d{1,2})(?<hand>[RL]))?"),
    width: 1,
    type: "RECESS",
    verified: false,
  },
  {
    maker: "Korloy, ZCC-CT …",
    pattern: family("(?<name>MGMN) (?<width>\\d{3})"),
    width: 100,
    type: "RECTURN",
    verified: false,
  },
  {
    maker: "Korloy, ZCC-CT …",
    pattern: family("(?<name>MGGN) (?<width>\\d{3})"),
    width: 100,
    type: "RECTURN",
    verified: false,
  },
  {
    maker: "Korloy, ZCC-CT …",
    pattern: family("(?<name>MRMN) (?<width>\\d{3})"),
    width: 100,
    isRound: true,
    type: "RECTURN",
    verified: false,
  },
  {
    maker: "Korloy, ZCC-CT …",
    pattern: family("(?<name>MGEH(?<hand>[RL])) \\d{4} (?<width>\\d(?:\\.5)?)"),
    width: 1,
    type: "RECTURN",
    verified: false,
    holder: { to: "2" },
  },
  {
    maker: "Korloy, ZCC-CT …",
    pattern: family("(?<name>MGIV(?<hand>[RL])) \\d{4} (?<width>\\d(?:\\.5)?)"),
    width: 1,
    type: "RECTURN",
    verified: false,
    holder: { to: "6" },
  },
];

/** Widest insert of these families, mm: more is another code. */
const WIDEST = 20;

const mm = (name: "cutWidth" | "corner", text: string, value: number): CodePart =>
  codePart(name, text, { is: "mm", mm: value });
const rounded = (n: number) => String(Math.round(n * 1000) / 1000);

/** Reads a groove or part-off insert, in capital letters; null for a family that is not known. */
export function readGrooveCode(text: string): MakerCode | null {
  for (const { maker, pattern, width: per, radius: each = 1, isRound = false, type, verified, holder } of FAMILIES) {
    const found = pattern.exec(text);
    if (!found?.groups) continue;
    const { name = "", width: digits = "", radius, angle, hand } = found.groups;
    const width = Number(digits) / per;
    if (!(width > 0) || width > WIDEST) continue;
    const front = angle === undefined ? 0 : Number(angle);
    const corner = radius === undefined ? null : Number(radius) / each;
    const rest = text
      .slice(found[0].length)
      .replace(/^[\s\-_/·]+/, "")
      .trim();
    const notes: MakerNote[] = [
      ...(isRound ? [{ is: "fullRadius" } as const] : corner === null ? [{ is: "cornerMissing" } as const] : []),
      ...(front > 0 ? [{ is: "frontAngle", angle: front } as const] : []),
      ...(holder ? [{ is: "holderUnplaced" } as const] : []),
      ...(verified ? [] : [{ is: "unverified" } as const]),
    ];
    return {
      kind: "maker",
      code: found[0].replace(/[\s_/·]+/g, "-").replace(/(?<!-)-+$/, ""),
      parts: [
        codePart("family", name.replace(/[\s_/·-]+/g, ""), { is: "nothing" }),
        ...(hand && !holder ? [codePart("hand", hand, { is: "hand", hand: hand as "R" })] : []),
        mm("cutWidth", digits, width),
        ...(corner === null ? [] : [mm("corner", radius ?? "", corner)]),
        ...(front > 0 ? [codePart("frontAngle", angle ?? "", { is: "angle", angle: front })] : []),
        ...(rest ? [codePart("maker", rest, { is: "nothing" })] : []),
        codePart("source", "", { is: "named", name: maker, angle: null }),
      ],
      cells: isRound
        ? { TYPE: "BUTTON", RS: rounded(width / 2) }
        : {
            TYPE: type,
            CUTWIDTH: rounded(width),
            ...(corner !== null && { RS: rounded(corner) }),
            ...(holder && { TO: holder.to }),
          },
      types: isRound ? ["BUTTON"] : ["RECESS", "RECTURN"],
      notes,
    };
  }
  return null;
}
