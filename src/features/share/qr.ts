import { encode } from "uqr";

/**
 * The largest version drawn: a tablet still resolves its modules on a screen. With the lowest error correction it holds
 * `LONGEST_QR` characters; nothing covers a code on a screen, so that is enough.
 */
const LARGEST = 30;
export const LONGEST_QR = 1732;
/** Quiet zone around the code, in modules, as the standard requires. */
export const QUIET = 4;

/** A code as rows of modules, true where one is black, without its quiet zone; null for a text that is too long. */
export function qrOf(text: string): readonly (readonly boolean[])[] | null {
  if (new TextEncoder().encode(text).length > LONGEST_QR) return null;
  return encode(text, { ecc: "L", maxVersion: LARGEST, border: 0 }).data;
}

/** The black modules as one path of rectangles, one for each run in a row, in modules with the quiet zone. */
export const qrPath = (rows: readonly (readonly boolean[])[]): string =>
  rows
    .flatMap((row, y) =>
      row.flatMap((black, x) => {
        if (!black || row[x - 1]) return [];
        const end = row.indexOf(false, x);
        const wide = (end < 0 ? row.length : end) - x;
        return [`M${x + QUIET} ${y + QUIET}h${wide}v1h-${wide}z`];
      }),
    )
    .join("");
