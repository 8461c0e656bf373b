const spaced = (text: string): string => text.replace(/ (?=[?!:;»%])|(?<=«) /g, "\u00a0");

/**
 * Sets French as it is printed: no line breaks before ? ! : ; and inside « », and the apostrophe is a curved one. The
 * prompts of the control have no space before their question mark; on the screen they have one, as all questions do.
 */
export function typeset<T>(texts: T): T {
  const set = (value: unknown): unknown => {
    if (typeof value === "string")
      return spaced(value)
        .replace(/(?<=\p{L})'/gu, "’")
        .replace(/(?<=[\p{L}\d)])\?$/u, "\u00a0?");
    if (typeof value === "function") {
      return (...values: readonly unknown[]) => {
        const said: unknown = Reflect.apply(value, undefined, values);
        return typeof said === "string" ? spaced(said) : said;
      };
    }
    if (Array.isArray(value)) return value.map(set);
    if (typeof value !== "object" || value === null) return value;
    return Object.fromEntries(Object.entries(value).map(([key, inner]: [string, unknown]) => [key, set(inner)]));
  };
  return set(texts) as T;
}
