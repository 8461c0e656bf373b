import { strFromU8, strToU8, zipSync } from "fflate";
import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { packedFiles, unpackedFile } from "./unpack.ts";

const ZIP = zipSync({
  "a.txt": strToU8("plain ".repeat(50)),
  "ä/b.txt": [strToU8("stored"), { level: 0 }],
  "empty.txt": new Uint8Array(0),
});

/** A byte-exact zip of one stored file whose sizes and place stand in the fields of large files. */
function largeZip(): Uint8Array {
  const name = strToU8("a"),
    content = strToU8("large");
  const local = new Uint8Array(30),
    entry = new Uint8Array(46),
    extra = new Uint8Array(28),
    end = new Uint8Array(22);
  const view = (of: Uint8Array) => new DataView(of.buffer);
  view(local).setUint32(0, 0x04034b50, true);
  view(local).setUint16(26, 1, true);
  view(entry).setUint32(0, 0x02014b50, true);
  for (const field of [20, 24, 42]) view(entry).setUint32(field, 0xffffffff, true);
  view(entry).setUint16(28, 1, true);
  view(entry).setUint16(30, extra.length, true);
  view(extra).setUint16(0, 1, true);
  view(extra).setUint16(2, 24, true);
  for (const [i, value] of [5n, 5n, 0n].entries()) view(extra).setBigUint64(4 + 8 * i, value, true);
  view(end).setUint32(0, 0x06054b50, true);
  view(end).setUint16(10, 1, true);
  view(end).setUint32(16, local.length + name.length + content.length, true);
  return Uint8Array.from([local, name, content, entry, name, extra, end].flatMap((part) => [...part]));
}

describe("files of a zip", () => {
  test.each([
    ["deflated, stored and empty", ZIP, ["plain ".repeat(50), "stored", ""], ["a.txt", "ä/b.txt", "empty.txt"]],
    ["behind other bytes of a view", new Uint8Array([9, 9, ...ZIP]).subarray(2), undefined, undefined],
    ["with a comment", new Uint8Array([...ZIP, ...new Uint8Array(300)]), undefined, undefined],
    ["with the fields of large files", largeZip(), ["large"], ["a"]],
  ])("%s", (_, zip, texts = ["plain ".repeat(50), "stored", ""], names = ["a.txt", "ä/b.txt", "empty.txt"]) => {
    const files = packedFiles(zip);
    expect(files.map(({ name }) => name)).toEqual(names);
    expect(files.map((file) => strFromU8(unpackedFile(file) ?? new Uint8Array(1)))).toEqual(texts);
  });

  test("a file is never unpacked beyond what it says or what is asked for", () => {
    const [file] = packedFiles(zipSync({ "a.txt": new Uint8Array(5_000_000) }));
    if (!file) throw new Error("no file");
    expect(unpackedFile(file, 4_999_999)).toBeNull();
    expect(unpackedFile({ ...file, size: 1000 })).toBeNull();
    expect(unpackedFile(file, 5_000_000)).toHaveLength(5_000_000);
  });

  test("damaged bytes throw an error, and none hangs", () =>
    fc.assert(
      fc.property(fc.array(fc.tuple(fc.nat(ZIP.length - 1), fc.nat(255)), { maxLength: 8 }), (changes) => {
        const damaged = ZIP.slice();
        for (const [at, value] of changes) damaged[at] = value;
        try {
          for (const file of packedFiles(damaged)) unpackedFile(file, 10_000);
        } catch (error) {
          expect(error).toBeInstanceOf(Error);
        }
      }),
      { numRuns: 500, seed: 42 },
    ));
});
