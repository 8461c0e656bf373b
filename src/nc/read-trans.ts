import { axisName, readWords } from "./read-words.ts";
import type { Scan } from "./scan.ts";
import type { AxisName, Statement } from "./statement.ts";
import { VALUE } from "./value.ts";

const AXIS = /AXIS(?![A-Z])/iy;
const RESET = /RESET(?![A-Z])/iy;
const TABLE = /TABLE(?![A-Z])/iy;
const LETTER = /([XYZABCUVW])(?![A-Z\d])/iy;
const TURNED = new RegExp(String.raw`(I?)ROT[ \t]*(${VALUE})`, "iy");
const SCALED = new RegExp(String.raw`SCL[ \t]*(${VALUE})`, "iy");

/** What TRANS changes: the word behind it. */
export type TransWord = "DATUM" | "MIRROR" | "ROTATION" | "SCALE";

/**
 * What follows `TRANS DATUM`, `TRANS MIRROR`, `TRANS ROTATION` and `TRANS SCALE`; null when it is none of their forms.
 */
export function readTrans(scan: Scan, word: TransWord): Statement | null {
  if (scan.take(RESET)) {
    scan.leftOver();
    if (word === "DATUM") return { kind: "datum", shift: "reset" };
    if (word === "MIRROR") return { kind: "mirror", axes: "reset" };
    return word === "ROTATION" ? { kind: "rotation", angle: "reset" } : { kind: "scale", factor: "reset" };
  }
  if (word === "DATUM") return datum(scan);
  if (word === "MIRROR") return mirror(scan);
  const m = scan.take(word === "ROTATION" ? TURNED : SCALED);
  const value = m && scan.value(m[word === "ROTATION" ? 2 : 1] ?? "");
  if (value === null) return null;
  scan.leftOver();
  return word === "ROTATION"
    ? { kind: "rotation", angle: { value, incremental: m?.[1] !== "" } }
    : { kind: "scale", factor: value };
}

function datum(scan: Scan): Statement | null {
  if (scan.take(AXIS)) return { kind: "datum", shift: readWords(scan).axes };
  if (!scan.take(TABLE)) return null;
  const row = scan.rest;
  scan.at = scan.text.length;
  return { kind: "datumTable", row };
}

function mirror(scan: Scan): Statement | null {
  if (!scan.take(AXIS)) return null;
  const axes: AxisName[] = [];
  for (let m = scan.take(LETTER); m; m = scan.take(LETTER)) axes.push(axisName(m[1] ?? ""));
  if (axes.length === 0) return null;
  scan.leftOver();
  return { kind: "mirror", axes };
}
