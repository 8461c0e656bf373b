/** The same characters as a text of their own: a piece of a long text keeps all of it in memory. */
export const ownText = (piece: string): string => ` ${piece}`.slice(1);
