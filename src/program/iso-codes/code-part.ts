import type { Breaker, EdgeFinish, Hole, InsertForm } from "./insert-facts.ts";

/** Names of the positions of a code. */
export const PART_NAMES = [
  "shape",
  "clearance",
  "tolerance",
  "type",
  "edge",
  "thickness",
  "corner",
  "finish",
  "direction",
  "maker",
  "clamping",
  "holderShape",
  "style",
  "hand",
  "height",
  "width",
  "length",
  "bar",
  "diameter",
  "side",
  "circle",
  "pitch",
  "profile",
  "family",
  "cutWidth",
  "frontAngle",
  "source",
] as const;
export type PartName = (typeof PART_NAMES)[number];

export type InsertClamping = "top" | "topHole" | "hole" | "screw" | "wedge";
export type Hand = "R" | "L" | "N";
/** Material of a bar. */
export type BarMake =
  | "steel"
  | "steelCoolant"
  | "steelDamped"
  | "steelDampedCoolant"
  | "carbide"
  | "carbideCoolant"
  | "carbideDamped"
  | "carbideDampedCoolant"
  | "heavy"
  | "heavyCoolant";
/** Cutting side of a holder: along its flank, with its end, or both. */
export type Cuts = "side" | "end" | "both";

/** Meaning of a part of a code. mm and degrees. */
export type CodeMeaning =
  | { readonly is: "form"; readonly form: InsertForm; readonly angle: number }
  | { readonly is: "angle"; readonly angle: number }
  | { readonly is: "mm"; readonly mm: number }
  | { readonly is: "tolerance"; readonly from: number; readonly to: number; readonly thickness: number }
  | { readonly is: "type"; readonly hole: Hole; readonly breaker: Breaker }
  | {
      readonly is: "wiper";
      readonly angle: number | null;
    }
  | { readonly is: "finish"; readonly finish: EdgeFinish }
  | { readonly is: "hand"; readonly hand: Hand }
  | { readonly is: "clamping"; readonly clamping: InsertClamping }
  | { readonly is: "style"; readonly angle: number; readonly cuts: Cuts }
  | { readonly is: "bar"; readonly make: BarMake }
  | { readonly is: "side"; readonly side: "outside" | "inside" | "both" }
  /** Pitches in mm, or in threads per inch. */
  | { readonly is: "pitches"; readonly from: number; readonly to: number; readonly inch: boolean }
  | { readonly is: "named"; readonly name: string; readonly angle: number | null }
  | { readonly is: "special" }
  | { readonly is: "nothing" };

/** One part of a code; `sure` is false where sources differ or the fact is only recalled. */
export interface CodePart {
  readonly name: PartName;
  readonly text: string;
  /** Null: unknown letter or number. */
  readonly meaning: CodeMeaning | null;
  readonly sure: boolean;
}

export const codePart = (name: PartName, text: string, meaning: CodeMeaning | null, sure = true): CodePart => ({
  name,
  text,
  meaning,
  sure,
});

/** Reads a code part by part; separators are skipped. */
export interface Scanner {
  /** The next part if it matches the pattern, which begins with ^. */
  readonly take: (pattern: RegExp) => string | null;
  readonly rest: () => string;
}

export function scanner(text: string): Scanner {
  let left = text;
  return {
    take: (pattern) => {
      left = left.replace(/^[\s\-_/·]+/, "");
      const found = pattern.exec(left)?.[0];
      if (found === undefined || found === "") return null;
      left = left.slice(found.length);
      return found;
    },
    rest: () => left,
  };
}
