import { storedText } from "./storage.ts";

/**
 * The only source of random ids. With `?seed=7` in the address a fresh browser draws the same ids in every run, so that
 * names, addresses and files repeat. The number of draws is stored on the device: a reload or a second tab continues
 * and never repeats an id.
 */
const DRAWN = storedText("drawn");

/** Length of an id, bytes. */
const SIZE = 16;

/** A 32-bit hash of two numbers: the "lowbias32" steps of C. Wellons (hash-prospector). */
function mixed(seed: number, count: number): number {
  let x = (seed ^ Math.imul(count, 0x9e3779b9)) >>> 0;
  x = Math.imul(x ^ (x >>> 16), 0x7feb352d);
  x = Math.imul(x ^ (x >>> 15), 0x846ca68b);
  return (x ^ (x >>> 16)) >>> 0;
}

/** The number after `seed=`; null where the address has none. */
export function seedOf(search: string): number | null {
  const asked = new URLSearchParams(search).get("seed");
  return asked !== null && /^\d+$/.test(asked) ? Number(asked) >>> 0 : null;
}

let pageDrawCount = 0;

/** Number of seeded draws on this device, including this one; only those of this page where storage is refused. */
function counted(seed: number): number {
  pageDrawCount += 1;
  const [of, count] = (DRAWN.get() ?? "").split(" ").map(Number);
  pageDrawCount = Math.max(pageDrawCount, of === seed ? (count ?? 0) + 1 : 0);
  DRAWN.set(`${seed} ${pageDrawCount}`);
  return pageDrawCount;
}

function bytes(): Uint8Array {
  const seed = typeof location === "undefined" ? null : seedOf(location.search);
  if (seed === null) return crypto.getRandomValues(new Uint8Array(SIZE));
  const count = counted(seed);
  return Uint8Array.from({ length: SIZE }, (_, i) => mixed(seed, count * SIZE + i));
}

/** A random UUID (RFC 9562, version 4), also on a page without a secure context. */
export function randomId(): string {
  const hex = [...bytes()]
    .map((byte, i) => {
      if (i === 6) return (byte & 0x0f) | 0x40;
      return i === 8 ? (byte & 0x3f) | 0x80 : byte;
    })
    .map((byte) => byte.toString(16).padStart(2, "0"))
    .join("");
  return [hex.slice(0, 8), hex.slice(8, 12), hex.slice(12, 16), hex.slice(16, 20), hex.slice(20)].join("-");
}
