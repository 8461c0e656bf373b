import type { Expected } from "./expectation.ts";

/** Programs with a cause that is reported, and consequences that are not reported again. */
export const expectedCauses: Readonly<Record<string, Expected>> = {
  "oversize-asked-for": {
    says: "the oversize of Q215 = 3 was asked for",
    reason: "oversize",
    infos: ["materialLeft"],
    mostWarnings: 0,
    mostErrors: 0,
    verdict: "proved",
  },
  "corner-of-the-insert": {
    says: "a simple shoulder has the corner of its insert",
    reason: "insertRadius",
    infos: ["materialLeft"],
    mostWarnings: 0,
    mostErrors: 0,
    verdict: "proved",
  },
  "corner-drawn-smaller": {
    says: "a corner that is drawn smaller than the insert is none that was asked for",
    reason: "insertRadius",
    has: { materialLeft: 1 },
  },
};
