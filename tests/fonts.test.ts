import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { brotliDecompressSync } from "node:zlib";
import { expect, test } from "vitest";
import { projectFile, projectPath } from "./sources.ts";

/** Where screen texts, lessons and NC words are written. */
const WRITTEN = ["src/i18n", "src/nc", "src/course", "src/examples", "src/features"];
/** What a browser draws of its own, or not at all. */
const NO_GLYPH = /[\p{C}\u2028\u2029]/u;

const inRange = (range: string, code: number): boolean =>
  range.split(",").some((each) => {
    const [from = 0, to = from] = each
      .trim()
      .slice(2)
      .split("-")
      .map((hex) => Number.parseInt(hex, 16));
    return code >= from && code <= to;
  });

/** The characters of a WOFF2 file, as its table `cmap` (format 4) lists them. */
function charactersOf(path: string): ReadonlySet<number> {
  const file = readFileSync(projectPath(path));
  const tables = file.readUInt16BE(12);
  let at = 48;
  const base128 = () => {
    let value = 0;
    for (;;) {
      const byte = file[at++] ?? 0;
      value = value * 128 + (byte & 127);
      if (byte < 128) return value;
    }
  };
  let offset = 0,
    found = -1;
  for (let i = 0; i < tables; i += 1) {
    const flags = file[at++] ?? 0,
      tag = flags & 63,
      form = flags >> 6;
    if (tag === 63) at += 4;
    const whole = base128();
    // The outlines and their places are stored in another form, of another length, unless the form is 3.
    const isChanged = tag === 10 || tag === 11 ? form !== 3 : form !== 0;
    const length = isChanged ? base128() : whole;
    if (tag === 0) found = offset;
    offset += length;
  }
  const cmap = brotliDecompressSync(file.subarray(at, at + file.readUInt32BE(20))).subarray(found);
  const characters = new Set<number>();
  for (let i = 0; i < cmap.readUInt16BE(2); i += 1) {
    const table = cmap.subarray(cmap.readUInt32BE(8 + 8 * i));
    if (table.readUInt16BE(0) !== 4) continue;
    const doubled = table.readUInt16BE(6);
    for (let k = 0; k < doubled; k += 2)
      for (let code = table.readUInt16BE(16 + doubled + k); code <= table.readUInt16BE(14 + k); code += 1)
        characters.add(code);
  }
  return characters;
}

const written = new Set(
  WRITTEN.flatMap((folder) =>
    readdirSync(projectPath(folder), { recursive: true, encoding: "utf8" })
      .filter((path) => /\.(ts|tsx|json|h)$/.test(path))
      .flatMap((path) => [...new Set(readFileSync(join(projectPath(folder), path), "utf8"))]),
  ),
);
const css = projectFile("src/app/base/fonts/fonts.css");

test.each(["inter", "jetbrains-mono"])("%s has all that is written and that its package draws", (font) => {
  const has = charactersOf(`src/app/base/fonts/${font}.woff2`);
  const range = new RegExp(String.raw`/${font}\.woff2"[^}]*unicode-range: ([^;]+)`).exec(css)?.[1] ?? "";
  const { latin = "" } = JSON.parse(projectFile(`node_modules/@fontsource-variable/${font}/unicode.json`)) as Partial<
    Record<string, string>
  >;
  const wanted = [...written].filter((c) => !NO_GLYPH.test(c) && inRange(latin, c.codePointAt(0) ?? 0));
  expect(wanted).toEqual(expect.arrayContaining([..."aZ0~äßÉç°±µ×÷·»’…−²↑"]));
  const lacking = (is: (code: number) => boolean) => wanted.filter((c) => !is(c.codePointAt(0) ?? 0));
  expect(lacking((code) => has.has(code))).toEqual([]);
  expect(lacking((code) => inRange(range, code))).toEqual([]);
});
