import { codePart, scanner, type CodePart, type Hand, type CodeMeaning, type Scanner } from "./code-part.ts";
import {
  CLEARANCES,
  circleOf,
  EDGE_FINISHES,
  edgeOf,
  INSERT_SHAPES,
  INSERT_TYPES,
  inchCircle,
  inchCorner,
  inchThickness,
  THICKNESSES,
  TOLERANCES,
  WIPER_EDGES,
} from "./insert-facts.ts";

/** An insert decoded from its code. mm and degrees. */
export interface InsertCode {
  readonly kind: "insert";
  /** The code without separators, as a tool name. */
  readonly code: string;
  readonly parts: readonly CodePart[];
  readonly shape: string;
  /** Included angle at the tip; null for a round insert and an unknown letter. */
  readonly angle: number | null;
  readonly clearance: string;
  /** Edge length, or diameter of a round insert. */
  readonly edge: number | null;
  /** Digits of the size as in a holder code. */
  readonly size: string | null;
  readonly corner: number | null;
  readonly inch: boolean;
}

/** Separators between two parts. */
const SEPARATORS = /^[\s\-_/·]+/;
const inHundredths = (n: number) => Math.round(n * 100) / 100;

/** The digits of ANSI B212.4: circle, thickness, corner. */
const INCHES = /^(1\.[258]|10|\d(?:\.5)?)[\s\-_/·]*(\d(?:\.\d)?)[\s\-_/·]*(0\.5|\.5|\d)?(?=$|[^\d.])/;

interface Sizes {
  readonly parts: readonly CodePart[];
  readonly edge: number | null;
  readonly size: string | null;
  readonly corner: number | null;
}
const NO_SIZES: Sizes = { parts: [], edge: null, size: null, corner: null };

const lengthPart = (name: "edge" | "thickness" | "corner", text: string, mm: number | null, sure = true) =>
  codePart(name, text, mm === null ? null : { is: "mm", mm }, sure);

/** Corner position: a radius in tenths, M0 or 00, or two letters of a wiper. */
function cornerPart(text: string, round: boolean): { readonly part: CodePart; readonly corner: number | null } {
  if (/^(?:M[0O]?|00)$/.test(text))
    return round || text !== "00"
      ? { part: codePart("corner", text, { is: "nothing" }), corner: null }
      : { part: lengthPart("corner", text, 0), corner: 0 };
  if (/^\d\d$/.test(text)) return { part: lengthPart("corner", text, Number(text) / 10), corner: Number(text) / 10 };
  const angle = WIPER_EDGES[text[0] ?? ""];
  const known = text.length === 2 && angle !== undefined && /[A-GNPZ]/.test(text[1] ?? "");
  return { part: codePart("corner", text, known ? { is: "wiper", angle } : null), corner: null };
}

function metricSizes(scan: Scanner, shape: string): Sizes {
  const round = INSERT_SHAPES[shape]?.form === "round";
  const size = scan.take(/^\d{2}/) ?? "";
  const thick = scan.take(/^(?:T\d|\d\d)/);
  const cornerText =
    thick === null ? null : scan.take(/^(?:M[0O]|M(?=$|[\s-])|\d\d|[ADEFPZ][A-GNPZ](?=[FETSKP]?[RLN]?(?:$|[\s\-_/])))/);
  const corner = cornerText === null ? null : cornerPart(cornerText, round);
  const circle = circleOf(shape, Number(size));
  // A round insert is in whole millimetres with corner M0, and in fractions of an inch with 00.
  const inWholes = round && cornerText !== "00";
  const edge = circle === null || inWholes ? Number(size) : inHundredths(edgeOf(shape, circle) ?? Number(size));
  const sure = round ? cornerText !== null : circle !== null;
  const parts = [
    lengthPart("edge", size, edge, sure),
    ...(thick === null ? [] : [thickness(thick)]),
    ...(corner ? [corner.part] : []),
  ];
  return { parts, edge, size, corner: round ? inHundredths(edge * HALF) : (corner?.corner ?? null) };
}
const HALF = 1 / 2;
const thickness = (text: string) => lengthPart("thickness", text, THICKNESSES[text] ?? null);

function inchSizes(scan: Scanner, shape: string): Sizes {
  const [all = "", size = "", thick = "", tip] = INCHES.exec(scan.rest().replace(SEPARATORS, "")) ?? [];
  const circle = inchCircle(size);
  const thickMm = inchThickness(thick);
  if (all === "" || circle === null || thickMm === null)
    return { ...NO_SIZES, parts: [codePart("edge", scan.rest().trim(), null)] };
  scan.take(/^(?:1\.[258]|10|\d(?:\.5)?)/);
  scan.take(/^\d(?:\.\d)?/);
  if (tip !== undefined) scan.take(/^(?:0?\.5|\d)/);
  const round = INSERT_SHAPES[shape]?.form === "round";
  const corner = tip === undefined ? null : inchCorner(tip === ".5" ? "0.5" : tip);
  const exact = edgeOf(shape, circle);
  const edge = exact === null ? null : inHundredths(exact);
  const parts = [
    lengthPart("edge", size, edge),
    lengthPart("thickness", thick, thickMm),
    ...(tip === undefined
      ? []
      : [round ? codePart("corner", tip, { is: "nothing" }) : lengthPart("corner", tip, corner)]),
  ];
  const digits = edge === null ? null : String(Math.floor(edge)).padStart(2, "0");
  return { parts, edge, size: digits, corner: round ? inHundredths(circle * HALF) : corner };
}

/** Optional parts after the seven positions: the edge, the direction, and the maker's code. */
function behind(scan: Scanner): CodePart[] {
  const parts: CodePart[] = [];
  const alone = String.raw`(?=[RLN]?(?:$|[\s\-_/]))`;
  const finish = scan.take(new RegExp(`^[${EDGE_FINISHES.join("")}]${alone}`));
  const found = EDGE_FINISHES.find((each) => each === finish);
  if (found) parts.push(codePart("finish", found, { is: "finish", finish: found }));
  const hand = scan.take(/^[RLN](?=$|[\s\-_/])/);
  if (hand) parts.push(codePart("direction", hand, { is: "hand", hand: hand as Hand }));
  const maker = scan.rest().replace(SEPARATORS, "").trim();
  if (maker !== "") parts.push(codePart("maker", maker, { is: "nothing" }));
  return parts;
}

const letter = (text: string, known: CodeMeaning | null): CodeMeaning | null =>
  known ?? (text === "X" ? { is: "special" } : null);

/** Reads an insert code in capital letters; null when its first letter is no shape. */
export function readInsertCode(text: string): InsertCode | null {
  const scan = scanner(text);
  const shape = scan.take(/^[A-Z]/) ?? "";
  const known = INSERT_SHAPES[shape];
  if (!known) return null;
  const clearance = scan.take(/^[A-Z]/) ?? "";
  const tolerance = scan.take(/^[A-Z]/) ?? "";
  const type = scan.take(/^[A-Z]/) ?? "";
  const angle = CLEARANCES[clearance];
  const [from, to, thick] = TOLERANCES[tolerance] ?? [];
  const [hole, breaker] = INSERT_TYPES[type] ?? [];
  const letters = [
    codePart("shape", shape, { is: "form", form: known.form, angle: known.angle }),
    codePart(
      "clearance",
      clearance,
      angle !== undefined ? { is: "angle", angle } : clearance === "O" ? { is: "special" } : null,
    ),
    codePart(
      "tolerance",
      tolerance,
      from !== undefined && to !== undefined && thick !== undefined
        ? { is: "tolerance", from, to, thickness: thick }
        : null,
    ),
    codePart("type", type, letter(type, hole && breaker ? { is: "type", hole, breaker } : null)),
  ].filter((each) => each.text !== "");
  const digits = scan.rest().replace(SEPARATORS, "");
  const inch = isInch(digits);
  const sizes = digits === "" ? NO_SIZES : inch ? inchSizes(scan, shape) : metricSizes(scan, shape);
  const before = [...letters, ...sizes.parts];
  const code = before.map((each) => each.text).join("");
  const parts = sizes.edge === null ? before : [...before, ...behind(scan)];
  return {
    kind: "insert",
    code,
    parts,
    shape,
    angle: known.angle || null,
    clearance,
    inch,
    edge: sizes.edge,
    size: sizes.size,
    corner: sizes.corner,
  };
}

/** Three digits alone, or digits with a point, are fractions of an inch; pairs are millimetres. */
const isInch = (digits: string) => /^\d{3}(?!\d)|^\d{1,2}\.\d/.test(digits.replaceAll(/[\s\-_/·]/g, ""));
