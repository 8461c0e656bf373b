/** Text inside a pattern; names are compared with plain spaces in them. */
export const plainText = (text: string): string =>
  text
    .replaceAll("\u00a0", " ")
    .replaceAll("\u202f", " ")
    .replace(/[.*+?^${}()|[\]\\]/g, "\\$&");

/** Matches a name with any number in it. */
export const counted = (name: (n: number) => string): RegExp =>
  new RegExp(`^${plainText(name(12345)).replace(/12.?345/, "\\d+")}$`);
