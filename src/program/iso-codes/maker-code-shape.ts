import type { CellName } from "../tools/tool-columns.ts";
import type { CodePart } from "./code-part.ts";

/** Notes about a maker's code. Degrees. */
export type MakerNote =
  | { readonly is: "cornerMissing" | "fullRadius" | "unverified" | "flanksDiffer" | "holderUnplaced" }
  | { readonly is: "frontAngle"; readonly angle: number };

/** A thread, groove or part-off insert, or its holder, decoded from the designation of its makers. */
export interface MakerCode {
  readonly kind: "maker";
  /** The code as a tool name. */
  readonly code: string;
  readonly parts: readonly CodePart[];
  /** Cells that it states; TYPE is set only where the row has none of `types`. */
  readonly cells: Readonly<Partial<Record<CellName, string>>>;
  readonly types: readonly string[];
  readonly notes: readonly MakerNote[];
}
