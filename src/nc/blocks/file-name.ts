import type { Scan } from "../scan.ts";
import type { FileName, Parameter } from "../words.ts";
import { TEXT_PARAMETER } from "../value.ts";
import { takeQuoted } from "./words.ts";

const NAMED = new RegExp(`(${TEXT_PARAMETER})`, "iy");
const BARE_NAME = /[^\s;"][^;"]*/y;

/** A parameter that holds no number. */
export const named = (parameter: string): Parameter => ({ parameter: parameter.toUpperCase(), negative: false });

/** The file that a block names: in quotes, bare up to the end of the line, or by a parameter. */
export function takeFileName(scan: Scan): { readonly file: FileName; readonly bare: boolean } | null {
  const quoted = takeQuoted(scan);
  if (quoted !== null) return { file: quoted, bare: false };
  const from = scan.at;
  const parameter = scan.take(NAMED);
  if (parameter && scan.done) return { file: named(parameter[1] ?? ""), bare: false };
  scan.at = from;
  const name = scan.take(BARE_NAME)?.[0].trim() ?? "";
  return name === "" ? null : { file: name, bare: true };
}
