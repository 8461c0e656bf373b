import type { Scan } from "../scan.ts";
import type { FileName, Label, OutlineSource } from "../words.ts";
import { parameterOf, readLabel, TEXT_PARAMETER } from "../value.ts";
import type { Field } from "./define.ts";
import { choiceField, fileText, labelText, shownLabel, takeQuoted, textField, typedLabel } from "./words.ts";

const LBL = /LBL(?:_?OUT)?(?![A-Z_])/iy;
const LABEL = /(?:(\d{1,9})|"([^"]*)")/y;
const FILE = /FILE(?![A-Z])/iy;
const HELD = new RegExp(TEXT_PARAMETER, "iy");

/** A label after a word; null where absent. */
export function takeLabelBehind(scan: Scan, lead: RegExp): Label | null {
  const m = scan.take(lead) && scan.take(LABEL);
  return m && readLabel(m[1], m[2]);
}

/** An outline by label, or by file with an optional FILE; undefined where absent. */
export function takeOutline(scan: Scan): OutlineSource | undefined {
  const label = takeLabelBehind(scan, LBL);
  if (label !== null) return { label };
  scan.take(FILE);
  const file = takeQuoted(scan);
  if (file !== null) return { file };
  const parameter = scan.take(HELD);
  return parameter ? { file: { parameter: parameter[0].toUpperCase(), negative: false } } : undefined;
}
export const outlineText = (from: OutlineSource): string =>
  "file" in from ? fileText(from.file) : `LBL ${labelText(from.label)}`;

type Outline = OutlineSource | "off";
const sourceOf = (from: Outline) => (from === "off" ? "off" : "file" in from ? "file" : "label");
const typedFile = (typed: string): FileName | undefined => {
  if (typed === "" || typed.includes('"')) return undefined;
  const parameter = parameterOf(typed);
  return parameter?.parameter.startsWith("QS") ? parameter : typed;
};

/** The fields of an outline: its kind of source, and its label or file. */
export const outlineFields = <T extends Outline>(
  sources: readonly string[],
): readonly Field<T, "blankSource" | "label" | "file">[] => [
  choiceField<T, "blankSource">(
    "blankSource",
    sources,
    sourceOf,
    (chosen, from) =>
      sourceOf(from) === chosen
        ? from
        : ((chosen === "off" ? "off" : chosen === "file" ? { file: "BLANK.H" } : { label: 1 }) as T),
    { noPicture: "choice" },
  ),
  textField<T, "label">(
    "label",
    (from: Outline) => (from !== "off" && "label" in from ? shownLabel(from.label) : ""),
    (typed) => {
      const label = typedLabel(typed);
      return label === undefined ? undefined : ({ label } as T);
    },
    { letter: "LBL", noPicture: "name" },
  ),
  textField<T, "file">(
    "file",
    (from: Outline) =>
      from === "off" || "label" in from ? "" : typeof from.file === "object" ? from.file.parameter : from.file,
    (typed) => {
      const file = typedFile(typed);
      return file === undefined ? undefined : ({ file } as T);
    },
    { noPicture: "name" },
  ),
];
