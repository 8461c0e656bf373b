import { codePart, scanner, type CodePart, type Hand, type CodeMeaning, type Scanner } from "./code-part.ts";
import { BAR_MAKES, CLAMPINGS, HOLDER_STYLES, LENGTHS, UNSURE_LENGTHS, type HolderStyle } from "./holder-facts.ts";
import { CLEARANCES, INSERT_SHAPES } from "./insert-facts.ts";

/** A holder or a boring bar decoded from its code. mm and degrees. */
export interface HolderCode {
  readonly kind: "holder" | "bar";
  /** The code without separators, as a tool name. */
  readonly code: string;
  readonly parts: readonly CodePart[];
  /** Insert shape. */
  readonly shape: string;
  readonly style: HolderStyle | null;
  readonly clearance: string;
  readonly hand: Hand | null;
  /** Width of a shank, diameter of a bar. */
  readonly across: number | null;
  readonly length: number | null;
  /** Digits of the insert size. */
  readonly size: string | null;
  readonly inch: boolean;
}

interface Head {
  readonly parts: readonly CodePart[];
  readonly shape: string;
  readonly style: HolderStyle | null;
  readonly clearance: string;
  readonly hand: Hand | null;
}

const special = (text: string): CodeMeaning | null => (text === "X" ? { is: "special" } : null);

/** The five letters common to holders and bars. */
function head(scan: Scanner): Head {
  const [clamping, shape, style, clearance, hand] = ["clamping", "shape", "style", "clearance", "hand"].map(
    () => scan.take(/^[A-Z]/) ?? "",
  );
  const held = CLAMPINGS[clamping ?? ""];
  const form = INSERT_SHAPES[shape ?? ""];
  const cuts = HOLDER_STYLES[style ?? ""] ?? null;
  const angle = CLEARANCES[clearance ?? ""];
  const known = hand === "R" || hand === "L" || hand === "N" ? hand : null;
  const parts = [
    codePart("clamping", clamping ?? "", held ? { is: "clamping", clamping: held } : special(clamping ?? "")),
    codePart("holderShape", shape ?? "", form ? { is: "form", form: form.form, angle: form.angle } : null),
    codePart(
      "style",
      style ?? "",
      cuts ? { is: "style", angle: cuts.angle, cuts: cuts.cuts } : special(style ?? ""),
      cuts?.sure ?? true,
    ),
    codePart("clearance", clearance ?? "", angle === undefined ? null : { is: "angle", angle }),
    codePart("hand", hand ?? "", known ? { is: "hand", hand: known } : null),
  ].filter((each) => each.text !== "");
  return { parts, shape: shape ?? "", style: cuts, clearance: clearance ?? "", hand: known };
}

const mm = (
  name: "height" | "width" | "length" | "diameter" | "edge",
  text: string,
  value: number | null,
  sure = true,
): CodePart => codePart(name, text, value === null ? special(text) : { is: "mm", mm: value }, sure);

const lengthOf = (text: string) => mm("length", text, LENGTHS[text] ?? null, !UNSURE_LENGTHS.includes(text));

function makersOwn(scan: Scanner): CodePart[] {
  const rest = scan
    .rest()
    .replace(/^[\s\-_/·]+/, "")
    .trim();
  return rest === "" ? [] : [codePart("maker", rest, { is: "nothing" })];
}

const wordOf = (parts: readonly CodePart[]) => parts.map((each) => each.text).join("");

/** Insert size of a holder: digits only, their meaning depends on the shape. */
const sizePart = (text: string): CodePart => codePart("edge", text, { is: "nothing" });

/** Reads an external holder, such as PDJNL 2525M15; the text has capital letters only. */
export function readHolderCode(text: string): HolderCode {
  const scan = scanner(text);
  const { parts: letters, ...facts } = head(scan);
  // Three digits instead of shank and size are sixteenths and eighths of an inch (DCLNR 164D).
  const inch = /^[\s\-_/·]*\d{2}[\s\-_/·]*\d[A-Z]?(?!\d)/.test(scan.rest());
  if (inch) {
    const shank = codePart(
      "height",
      scan
        .rest()
        .replace(/^[\s\-_/·]+/, "")
        .trim(),
      null,
    );
    const parts = [...letters, shank];
    return { kind: "holder", code: wordOf(parts), parts, ...facts, across: null, length: null, size: null, inch };
  }
  const [height, width, long, size] = [
    scan.take(/^\d{2}/),
    scan.take(/^\d{2}/),
    scan.take(/^[A-Z]/),
    scan.take(/^\d{2}/),
  ];
  const sizes = [
    ...(height === null ? [] : [mm("height", height, Number(height))]),
    ...(width === null ? [] : [mm("width", width, Number(width))]),
    ...(long === null ? [] : [lengthOf(long)]),
    ...(size === null ? [] : [sizePart(size)]),
  ];
  const before = [...letters, ...sizes];
  return {
    kind: "holder",
    code: wordOf(before),
    parts: [...before, ...makersOwn(scan)],
    ...facts,
    inch,
    across: width === null ? null : Number(width),
    length: long === null ? null : (LENGTHS[long] ?? null),
    size,
  };
}

/** Reads a boring bar, such as A25R-SCLCR 09; the text has capital letters only. */
export function readBarCode(text: string): HolderCode {
  const scan = scanner(text);
  const [make = "", diameter = "", long = ""] = [
    scan.take(/^[A-Z]/) ?? "",
    scan.take(/^\d{2}/) ?? "",
    scan.take(/^[A-Z]/) ?? "",
  ];
  const known = BAR_MAKES[make];
  const bar = [
    codePart("bar", make, known ? { is: "bar", make: known } : special(make)),
    mm("diameter", diameter, Number(diameter)),
    ...(long === "" ? [] : [lengthOf(long)]),
  ];
  const { parts: letters, ...facts } = head(scan);
  const size = scan.take(/^\d{2}/);
  const before = [...bar, ...letters, ...(size === null ? [] : [sizePart(size)])];
  const code = `${wordOf(bar)}${letters.length > 0 ? "-" : ""}${wordOf(before.slice(bar.length))}`;
  return {
    kind: "bar",
    code,
    parts: [...before, ...makersOwn(scan)],
    ...facts,
    inch: false,
    across: Number(diameter),
    length: LENGTHS[long] ?? null,
    size,
  };
}
