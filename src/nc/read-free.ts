import { readWords } from "./read-words.ts";
import { Scan } from "./scan.ts";
import type { FreeForm, NamedWord, Statement } from "./statement.ts";
import { VALUE } from "./value.ts";

/** Words that only free contours have: the angle of a line, the centre of an arc, and where a closed contour begins and ends. */
const GIVEN = new RegExp(String.raw`(?<![A-Z_])(?:(AN|CCP[RA]|CC[XYZ])[ \t]*(${VALUE})|(CLSD)[ \t]*([+-])(?![\d.,Q]))`, "gi");
const SOLUTION = /\d{1,2}(?![\d.,])/y;

/** FL, FC, FLT, FCT, FPOL and FSELECT: elements of which some things are given. */
export function readFree(scan: Scan, form: FreeForm): Statement | null {
  const given: NamedWord[] = [];
  if (form === "FSELECT") {
    const number = scan.take(SOLUTION);
    if (!number) return null;
    given.push({ name: form, value: Number(number[0]) });
    scan.leftOver();
    return { kind: "free", form, given, words: { axes: [], linear: [], functions: [], extra: [] } };
  }
  const rest = scan.text.slice(scan.at).replace(GIVEN, (text, name?: string, digits?: string, closed?: string, sign?: string) => {
    const value = digits === undefined ? (sign === "-" ? -1 : 1) : scan.value(digits);
    if (value !== null) given.push({ name: (name ?? closed ?? "").toUpperCase(), value });
    return " ".repeat(text.length);
  });
  // The other words stand where they stood, so that what is wrong with them has its place.
  const inner = new Scan(rest, scan.offset + scan.at);
  const words = readWords(inner);
  for (const found of inner.issues) scan.issues.push(found);
  scan.at = scan.text.length;
  return { kind: "free", form, given, words };
}
