import type { Issue } from "./issue.ts";
import { roundedDown } from "../units.ts";

/** The value that a finding offers; null if none. */
export const offerOf = (found: Issue): number | null =>
  "nearest" in found.data && typeof found.data.nearest === "number" ? found.data.nearest : null;

/** The same finding with another offered value, or none. */
export function withOffer(found: Issue, offer: number | null): Issue {
  const { nearest: _, ...data } = found.data as { nearest?: number };
  return { ...found, data: offer === null ? data : { ...data, nearest: offer } } as Issue;
}

/** The properties that identify a finding. */
interface ComparedFinding extends Pick<Issue, "severity"> {
  readonly code: string;
  readonly at?: string;
  readonly data: object;
}

const keyOf = ({ code, at, data }: ComparedFinding) => `${code} ${at ?? ""} ${"element" in data ? data.element : ""}`;

const offersAt = (each: ComparedFinding, at: string | undefined): boolean =>
  at !== undefined && each.at === at && "nearest" in each.data && typeof each.data.nearest === "number";

/**
 * Whether a change fixes a finding: the finding is gone, there is no new error, and no new finding offers another value
 * at the same place.
 */
export function fixesFinding(
  found: ComparedFinding,
  before: readonly ComparedFinding[],
  after: readonly ComparedFinding[],
): boolean {
  const errors = new Set(before.filter((each) => each.severity === "error").map(keyOf)),
    known = new Set(before.map(keyOf));
  return !after.some(
    (each) =>
      keyOf(each) === keyOf(found) ||
      (each.severity === "error" && !errors.has(keyOf(each))) ||
      (offersAt(each, found.at) && !known.has(keyOf(each))),
  );
}

/** The largest working size from `offer` down to 0, on a grid of 0.001 mm; null if none works. */
export function largestThatWorks(offer: number, works: (size: number) => boolean): number | null {
  if (!(roundedDown(offer) > 0)) return null;
  if (works(roundedDown(offer))) return roundedDown(offer);
  let [yes, no] = [0, roundedDown(offer)];
  for (let i = 0; i < 20; i += 1) {
    const middle = roundedDown((yes + no) / 2);
    if (middle === yes || middle === no) break;
    if (works(middle)) yes = middle;
    else no = middle;
  }
  return yes > 0 ? yes : null;
}
