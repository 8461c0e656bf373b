/** A copy of a text slice, since a slice keeps the whole source text in memory. */
export const detachedText = (piece: string): string => ` ${piece}`.slice(1);
