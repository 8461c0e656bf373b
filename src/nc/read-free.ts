import { readWords } from "./read-words.ts";
import { Scan } from "./scan.ts";
import type { FreeForm, NamedWord, Statement } from "./statement.ts";
import { VALUE } from "./value.ts";

/**
 * Words that only free contours have: angles, centres, points that an element runs through or past, parallels, and the
 * block from which a value counts.
 */
const NAMES = "I?AN|I?CC[XYZ]|CCPR|CCPA|P[123][XYZ]|PD[XYZ]|PAR|DP|D|RCC[XYZ]|RPR|RPA|RAN|R[XYZ]";
const GIVEN = new RegExp(String.raw`(?<![A-Z_])(?:(CLSD)[ \t]*([+-])|(${NAMES})[ \t]*(${VALUE}))`, "gi");
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
  const begun = scan.at;
  const rest = scan.text
    .slice(begun)
    .replace(GIVEN, (text, closes?: string, sign?: string, name = "", digits = "", at = 0) => {
      // What is wrong with a value is said where it stands.
      scan.at = begun + Number(at) + text.length;
      const value = closes ? (sign === "-" ? -1 : 1) : scan.value(digits);
      if (value !== null) given.push({ name: (closes ?? name).toUpperCase(), value });
      return " ".repeat(text.length);
    });
  // The other words stand where they stood, so that what is wrong with them has its place.
  const inner = new Scan(rest, scan.offset + begun);
  const words = readWords(inner);
  for (const found of inner.issues) scan.issues.push(found);
  scan.at = scan.text.length;
  return { kind: "free", form, given, words };
}
