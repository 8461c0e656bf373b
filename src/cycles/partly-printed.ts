import type { Params } from "./params.ts";

/** What a page prints about a parameter of an unprinted list: its meaning, or its values too. */
type Attested = "meaning" | "values";

/** Tags parameters of a recalled list that a page of the control names with A; the place in the list stays recalled. */
export const partlyPrinted = <const P extends Params>(params: P, by: { readonly [Q in keyof P]?: Attested }): P =>
  Object.fromEntries(
    Object.entries(params).map(([q, p]) => {
      const what = by[q];
      return [q, what === undefined ? p : { ...p, evidence: "A", ...(what === "values" && { rangeEvidence: "A" }) }];
    }),
  ) as P;
