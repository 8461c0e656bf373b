import { valueText } from "../number-text.ts";
import type { Value } from "../words.ts";
import type { IsoToken } from "./tokens.ts";
import { isoMeaningOf, isoWordFor } from "./words.ts";

/** A coordinate of a block: an axis, a centre I J K, or the polar radius R and angle H. */
export interface IsoCoordinate {
  readonly name: string;
  readonly value: Value;
  readonly incremental: boolean;
}

const SIGNED = { plus: true, decimal: "." } as const;
const NAMES: ReadonlySet<string> = new Set("XYZABCUVWIJKRH");

/** Coordinates with G90 or G91 before the first and at each change, so that a block is complete in itself. */
export function coordinateTexts(coordinates: readonly IsoCoordinate[]): string[] {
  let before: boolean | null = null;
  return coordinates.flatMap(({ name, value, incremental }) => {
    const mode = incremental === before ? [] : [isoWordFor({ kind: "dimension", incremental }) ?? ""];
    before = incremental;
    return [...mode, `${name}${valueText(value, SIGNED)}`];
  });
}

/** Whether a token switches to incremental (G91: true, G90: false); null for any other token. */
export function dimensionOf(token: IsoToken): boolean | null {
  const means = token.letter === "G" && token.number !== null ? isoMeaningOf("G", token.number) : null;
  return means?.kind === "dimension" ? means.incremental : null;
}

/**
 * The coordinates of a block in order. A single G90 or G91 applies to the whole block, wherever it is; several apply to
 * the words after each. `incremental`: the mode left by earlier blocks.
 */
export function coordinatesOf(
  tokens: readonly IsoToken[],
  incremental: boolean,
): { coordinates: IsoCoordinate[]; incremental: boolean } {
  const modes = tokens.map(dimensionOf);
  const named = modes.filter((mode) => mode !== null);
  let now = named.length === 1 ? (named[0] ?? incremental) : incremental;
  const coordinates: IsoCoordinate[] = [];
  for (const [i, token] of tokens.entries()) {
    now = modes[i] ?? now;
    if (NAMES.has(token.letter) && token.value !== null)
      coordinates.push({ name: token.letter, value: token.value, incremental: now });
  }
  return { coordinates, incremental: named.at(-1) ?? incremental };
}
