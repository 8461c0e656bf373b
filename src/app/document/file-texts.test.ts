import { strToU8, zipSync } from "fflate";
import { expect, test } from "vitest";
import { decode } from "./encoding.ts";
import { textsOfFile } from "./file-texts.ts";

const ENDINGS = [".json", ".p21", ".zip", ".hsmlib"];
const LIMITS = { bytes: 100_000, texts: 5, depth: 2 };
const named = (found: ReturnType<typeof textsOfFile>) =>
  found === "tooLarge" ? found : found.map(({ name, text, packed }) => [name, text, packed]);
const read = (name: string, bytes: Uint8Array) => named(textsOfFile(name, bytes, ENDINGS, LIMITS));

test("a text file is one text, in UTF-8, Windows-1252 or UTF-16", () => {
  expect(read("a.json", strToU8("{ä}"))).toEqual([["a.json", "{ä}", false]]);
  expect(read("a.tbl", Uint8Array.of(0xe4))).toEqual([["a.tbl", "ä", false]]);
  expect(read("a.hsmlib", Uint8Array.of(0xff, 0xfe, 0x3c, 0, 0xe4, 0))).toEqual([["a.hsmlib", "<ä", false]]);
  expect(read("a.hsmlib", Uint8Array.of(0xfe, 0xff, 0, 0x3c))).toEqual([["a.hsmlib", "<", false]]);
  // Half of a character is none in UTF-16: every byte is kept.
  const torn = Uint8Array.of(0xff, 0xfe, 0, 0xd8, 0x3c, 0);
  expect(read("a.h", torn)).toEqual([["a.h", decode(torn).text, false]]);
});

test("an archive has the texts with a known ending, also those of archives within it", () => {
  const inner = zipSync({ "A.P21": strToU8("inner") });
  const zip = zipSync({ "tools.json": strToU8("{}"), "model.stp": strToU8("solid"), "d/x.p21.zip": inner });
  expect(read("t.tools", zip)).toEqual([
    ["tools.json", "{}", true],
    ["A.P21", "inner", true],
  ]);
});

test("an archive beyond the limits is too large: by bytes, by number, by what is packed in it", () => {
  expect(read("bomb.zip", zipSync({ "a.json": new Uint8Array(100_001) }))).toBe("tooLarge");
  const many = Object.fromEntries(Array.from({ length: 6 }, (_, i) => [`${i}.json`, strToU8("{}")]));
  expect(read("many.zip", zipSync(many))).toBe("tooLarge");
  const inner = zipSync({ "a.json": new Uint8Array(99_000) });
  expect(read("twice.zip", zipSync({ "a.zip": inner, "b.zip": inner }))).toBe("tooLarge");
});

test("archives are opened two deep, and a damaged one throws", () => {
  const deep = zipSync({ "c.zip": zipSync({ "b.zip": zipSync({ "a.json": strToU8("{}") }) }) });
  expect(read("deep.zip", deep)).toEqual([]);
  expect(() => read("cut.zip", deep.slice(0, 60))).toThrow();
});

test("a file that is larger than the directory of its archive says makes the archive too large", () => {
  const zip = zipSync({ "a.json": new Uint8Array(90_000) });
  const at = zip.findIndex((_, i) => zip[i] === 0x50 && zip[i + 1] === 0x4b && zip[i + 2] === 1 && zip[i + 3] === 2);
  new DataView(zip.buffer).setUint32(at + 24, 10, true);
  expect(read("lie.zip", zip)).toBe("tooLarge");
});
