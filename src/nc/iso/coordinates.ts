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

/** Coordinates with G90 or G91 in front of the first and wherever it changes, so that a block can be read alone. */
export function coordinateTexts(coordinates: readonly IsoCoordinate[]): string[] {
  let before: boolean | null = null;
  return coordinates.flatMap(({ name, value, incremental }) => {
    const mode = incremental === before ? [] : [isoWordFor({ kind: "dimension", incremental }) ?? ""];
    before = incremental;
    return [...mode, `${name}${valueText(value, SIGNED)}`];
  });
}

/** What G90 or G91 a token is; null for any other. */
export function dimensionOf(token: IsoToken): boolean | null {
  const means = token.letter === "G" && token.number !== null ? isoMeaningOf("G", token.number) : null;
  return means?.kind === "dimension" ? means.incremental : null;
}

/**
 * The coordinates of a block in their order. One G90 or G91 holds for the whole block, wherever it stands; of several
 * each holds for the words behind it. `incremental`: what the blocks before left in force.
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
