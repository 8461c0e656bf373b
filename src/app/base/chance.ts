import { keptText } from "./kept.ts";

/**
 * The one place that draws by lot. With `?seed=7` in the address a fresh browser draws the same in every run, so that
 * names, addresses and files repeat. How often was drawn is kept on the device: a reload or a second tab goes on and
 * meets no name again.
 */
const DRAWN = keptText("drawn");

/** Bytes of an id. */
const SIZE = 16;

/** One of many numbers from two, well mixed: the "lowbias32" steps of C. Wellons (hash-prospector). */
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

let here = 0;

/** How often this device has drawn with a seed, this time included; only of this page where nothing can be kept. */
function counted(seed: number): number {
  here += 1;
  const [of, count] = (DRAWN.get() ?? "").split(" ").map(Number);
  here = Math.max(here, of === seed ? (count ?? 0) + 1 : 0);
  DRAWN.set(`${seed} ${here}`);
  return here;
}

function bytes(): Uint8Array {
  const seed = typeof location === "undefined" ? null : seedOf(location.search);
  if (seed === null) return crypto.getRandomValues(new Uint8Array(SIZE));
  const count = counted(seed);
  return Uint8Array.from({ length: SIZE }, (_, i) => mixed(seed, count * SIZE + i));
}

/** A name that no other has: a random UUID (RFC 9562, version 4), also where the page is not served safely. */
export function drawnId(): string {
  const hex = [...bytes()]
    .map((byte, i) => {
      if (i === 6) return (byte & 0x0f) | 0x40;
      return i === 8 ? (byte & 0x3f) | 0x80 : byte;
    })
    .map((byte) => byte.toString(16).padStart(2, "0"))
    .join("");
  return [hex.slice(0, 8), hex.slice(8, 12), hex.slice(12, 16), hex.slice(16, 20), hex.slice(20)].join("-");
}
