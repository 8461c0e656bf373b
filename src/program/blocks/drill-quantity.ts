const LENGTHS: ReadonlySet<string> = new Set([
  "Q200",
  "Q201",
  "Q202",
  "Q203",
  "Q204",
  "Q205",
  "Q212",
  "Q239",
  "Q256",
  "Q257",
  "Q258",
  "Q259",
  "Q344",
  "Q379",
]);
const FEEDS: ReadonlySet<string> = new Set(["Q206", "Q208", "Q253"]);

/** Whether a parameter of a drilling cycle is a length or a feed; undefined where it is neither. */
export function drillQuantity(cycle: number, q: string): { readonly kind: "length" | "feed" } | undefined {
  if (FEEDS.has(q)) return { kind: "feed" };
  // The retraction of a tap counts in pitches.
  return LENGTHS.has(q) && !(q === "Q256" && cycle === 209) ? { kind: "length" } : undefined;
}
