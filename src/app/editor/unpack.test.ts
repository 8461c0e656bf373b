import { deflateSync, strToU8 } from "fflate";
import { expect, test } from "vitest";
import { LARGEST_PROGRAM } from "../files/limits.ts";
import { MARK, sharedProgram, shareLink } from "./share.ts";
import { inflateUpTo, unpackedText } from "./unpack.ts";

/** Small when packed, 64 MB when unpacked. */
const bomb = deflateSync(new Uint8Array(64_000_000).fill(0x4c), { level: 9 });
const hashOf = (bytes: Uint8Array) => MARK + Buffer.from(bytes).toString("base64url");

test.each([0, 1000, 1_000_000, LARGEST_PROGRAM])("unpacking stops at %i bytes, not when all is unpacked", (most) => {
  let taken = 0;
  const produced = inflateUpTo(bomb, most, (piece) => {
    taken += piece.length;
  });
  expect(produced).toBeGreaterThan(most);
  expect(produced).toBeLessThan(most + 2_000_000);
  expect(taken).toBeLessThanOrEqual(most);
});

test("a link that unpacks to more than is opened says so, one byte less is a program", () => {
  expect(sharedProgram(hashOf(bomb))).toEqual({ kind: "tooLarge" });
  const text = "0 BEGIN PGM Ø MM\n".repeat(3000);
  const size = strToU8(text).length;
  const hash = new URL(shareLink("https://example.org/", { name: "T.H", text, encoding: "utf-8" })).hash;
  expect(sharedProgram(hash, size)).toEqual({ kind: "text", text });
  expect(sharedProgram(hash, size - 1)).toEqual({ kind: "tooLarge" });
});

test.each([1, 2, 7, 40])("packed bytes that break off %i early are damaged, not a shorter program", (by) => {
  const packed = deflateSync(strToU8(Array.from({ length: 900 }, (_, i) => `${i} L X+${i * 7}`).join("\n")));
  expect(unpackedText(packed, LARGEST_PROGRAM)).toContain("899 L X+6293");
  expect(() => unpackedText(packed.subarray(0, packed.length - by), LARGEST_PROGRAM)).toThrow();
  expect(sharedProgram(hashOf(packed.subarray(0, packed.length - by)))).toEqual({ kind: "damaged" });
});

test("characters that lie across two pieces come back whole", () => {
  const text = Array.from({ length: 40_000 }, (_, i) => "中Ø\u{1f529}x"[i % 5] ?? "").join("") + String(Math.PI);
  const packed = deflateSync(strToU8(text), { level: 0 });
  expect(unpackedText(packed, LARGEST_PROGRAM)).toBe(text);
});
