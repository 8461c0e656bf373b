import type { Params, Topic } from "../../cycles/params.ts";

/** How a parameter is shown; by default as a plain dimension. */
export const shownAs = (params: Params, q: string): Topic => params[q]?.shown ?? "outline";

/** The Q of a cycle that is shown in this way. */
export const qOf = (params: Params, shown: Topic): string | null =>
  Object.keys(params).find((q) => params[q]?.shown === shown) ?? null;

/** The Q of the type that says what a size is (chamfer or radius), or of the size that belongs to a type. */
export const partnerOf = (params: Params, q: string): string | null =>
  params[q]?.sizes ?? Object.keys(params).find((other) => params[other]?.sizes === q) ?? null;
