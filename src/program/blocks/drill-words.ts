/** Required parameters; all others default to the value without effect. */
export const DRILL_WORDS: ReadonlyMap<number, readonly string[]> = new Map([
  [200, ["Q200", "Q201", "Q206", "Q202", "Q203"]],
  [201, ["Q200", "Q201", "Q206", "Q203"]],
  [202, ["Q200", "Q201", "Q206", "Q203"]],
  [203, ["Q200", "Q201", "Q206", "Q202", "Q203"]],
  [205, ["Q200", "Q201", "Q206", "Q202", "Q203"]],
  [206, ["Q200", "Q201", "Q206", "Q203"]],
  [207, ["Q200", "Q201", "Q239", "Q203"]],
  [209, ["Q200", "Q201", "Q239", "Q203", "Q257"]],
  [240, ["Q200", "Q206", "Q203"]],
]);

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

/** Whether a cycle drills on the axis while turning. */
export const isDrilling = (cycle: number): boolean => DRILL_WORDS.has(cycle);

/** Whether a parameter of a drilling cycle is a length or a feed; undefined where it is neither. */
export function drillQuantity(cycle: number, q: string): { readonly kind: "length" | "feed" } | undefined {
  if (!isDrilling(cycle)) return undefined;
  if (FEEDS.has(q)) return { kind: "feed" };
  // The retraction of a tap counts in pitches.
  return LENGTHS.has(q) && !(q === "Q256" && cycle === 209) ? { kind: "length" } : undefined;
}
