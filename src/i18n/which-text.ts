import type { TurnedShape } from "../cycles/define.ts";
import type { Site } from "../cycles/shape-request.ts";
import type { Reason } from "../kernel/plan/issue.ts";

/** Texts of the cycle search by shape, loaded with its dialog. */
export interface WhichTexts {
  readonly title: string;
  readonly lead: string;
  /** The sentence, with a placeholder in braces for each choice. */
  readonly sentence: string;
  readonly site: { readonly label: string; readonly of: Readonly<Record<Site, string>> };
  readonly shape: { readonly label: string; readonly of: Readonly<Record<TurnedShape, string>> };
  readonly stock: { readonly label: string; readonly of: Readonly<Record<"solid" | "preturned" | "now", string>> };
  readonly measures: Readonly<Record<"d1" | "d2" | "z1" | "z2" | "angle" | "chamfer" | "pitch" | "allowance", string>>;
  readonly threadDiameter: string;
  readonly degrees: string;
  /** Faults between two numbers. */
  readonly faults: Readonly<Record<"notSmaller" | "notLarger" | "same" | "contour", string>>;
  readonly stretch: {
    readonly title: string;
    readonly about: string;
    readonly first: string;
    readonly last: string;
    readonly picture: (first: number, last: number, of: number) => string;
  };
  /** The drawing of the shape. */
  readonly sketch: string;
  readonly ways: string;
  readonly trying: (done: number, of: number) => string;
  readonly none: string;
  readonly noneWorks: string;
  readonly best: string;
  /** Why an option is the best. */
  readonly because: Readonly<Record<"only" | "tool" | "least" | "fast" | "passes" | "equal", string>>;
  readonly bestIs: (name: string, why: string) => string;
  readonly passes: string;
  readonly time: string;
  readonly residual: string;
  readonly nothing: string;
  readonly noArea: string;
  readonly tool: (number: number, name: string) => string;
  readonly proved: string;
  readonly problems: Readonly<
    Record<
      | "gouge"
      | "rapidInStock"
      | "holderContact"
      | "clampContact"
      | "nothingCut"
      | "unproved"
      | "leavesMost"
      | "finishingInsert",
      string
    >
  >;
  readonly reasons: Readonly<Record<Reason, string>>;
  readonly take: string;
  readonly takeLong: (name: string) => string;
  readonly insert: string;
  readonly insertLong: (name: string) => string;
}
