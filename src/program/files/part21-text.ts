const HEX = /^[0-9A-F]+$/i;

/** Characters of hexadecimal groups of `width` digits; null for anything else, surrogates of \X2\ pairs included as they are. */
function fromHex(digits: string, width: 2 | 4 | 8): string | null {
  if (digits.length % width !== 0 || (digits !== "" && !HEX.test(digits))) return null;
  let text = "";
  for (let i = 0; i < digits.length; i += width) {
    const code = Number.parseInt(digits.slice(i, i + width), 16);
    if (code > 0x10ffff) return null;
    text += width === 8 ? String.fromCodePoint(code) : String.fromCharCode(code);
  }
  return text;
}

/** An escape at `i` of a raw string: its characters and its length; null when it is none. */
function escapeAt(raw: string, i: number, latin: boolean): readonly [text: string, length: number] | null {
  if (raw[i + 1] === "\\") return ["\\", 2];
  const name = /^\\(S|P[A-I]|N|F|X[24]?)\\/.exec(raw.slice(i, i + 4))?.[1];
  if (name === undefined) return null;
  const after = i + name.length + 2;
  if (name.startsWith("P") || name === "F") return ["", name.length + 2];
  if (name === "N") return ["\n", 3];
  // The pages of ISO 8859 other than the first are not decoded: their characters are visibly missing.
  if (name === "S") return after < raw.length ? [latin ? upper(raw, after) : "\uFFFD", 4] : null;
  if (name === "X") {
    const digits = raw.slice(after, after + 2),
      text = digits.length === 2 ? fromHex(digits, 2) : null;
    return text === null ? null : [text, 5];
  }
  const end = raw.indexOf("\\X0\\", after),
    text = end < 0 ? null : fromHex(raw.slice(after, end), name === "X2" ? 4 : 8);
  return text === null ? null : [text, end + 4 - i];
}
const upper = (raw: string, i: number) => String.fromCharCode((raw.charCodeAt(i) + 128) & 0xff);

/**
 * Text of a string of a Part 21 file, given what stands between its apostrophes (ISO 10303-21, clause 6.4.3): doubled
 * apostrophes, \S\, \X\, \X2\ and \X4\. Line breaks of the file are no part of it. An invalid escape stays as written.
 */
export function part21Text(raw: string): string {
  const flat = /[\n\r]/.test(raw) ? raw.replace(/[\n\r]+/g, "") : raw;
  if (!flat.includes("\\") && !flat.includes("''")) return flat;
  let text = "",
    latin = true;
  for (let i = 0; i < flat.length;) {
    const c = flat.charAt(i),
      found = c === "\\" ? escapeAt(flat, i, latin) : null;
    if (found) {
      if (flat[i + 1] === "P") latin = flat[i + 2] === "A";
      text += found[0];
      i += found[1];
      continue;
    }
    text += c;
    i += c === "'" && flat[i + 1] === "'" ? 2 : 1;
  }
  return text;
}
