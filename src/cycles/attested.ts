import type { Params } from "./params.ts";

/** What a page prints of a parameter whose list it does not print: what it means, or its values too. */
type Attested = "meaning" | "values";

/**
 * Marks parameters of a recalled list that a page of the control names: tag A for what it says, the place in the list
 * stays recalled.
 */
export const attested = <const P extends Params>(params: P, by: { readonly [Q in keyof P]?: Attested }): P =>
  Object.fromEntries(
    Object.entries(params).map(([q, p]) => {
      const what = by[q];
      return [q, what === undefined ? p : { ...p, evidence: "A", ...(what === "values" && { rangeEvidence: "A" }) }];
    }),
  ) as P;
