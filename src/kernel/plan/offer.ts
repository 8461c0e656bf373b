import type { Issue } from "./issue.ts";
import { roundedDown } from "../units.ts";

/** The value that a finding offers; null when it offers none. */
export const offerOf = (found: Issue): number | null =>
  "nearest" in found.data && typeof found.data.nearest === "number" ? found.data.nearest : null;

/** The same finding with another value to offer, or with none. */
export function withOffer(found: Issue, offer: number | null): Issue {
  const { nearest: _, ...data } = found.data as { nearest?: number };
  return { ...found, data: offer === null ? data : { ...data, nearest: offer } } as Issue;
}

/** As much of a finding as tells it from others. */
interface Told extends Pick<Issue, "severity"> {
  readonly code: string;
  readonly at?: string;
  readonly data: object;
}

const keyOf = ({ code, at, data }: Told) => `${code} ${at ?? ""} ${"element" in data ? data.element : ""}`;

/** Whether a change mends a finding: it is gone, and no error came that was not there before. */
export function mends(found: Told, before: readonly Told[], after: readonly Told[]): boolean {
  const known = new Set(before.filter((each) => each.severity === "error").map(keyOf));
  return !after.some((each) => keyOf(each) === keyOf(found) || (each.severity === "error" && !known.has(keyOf(each))));
}

/** The largest of the sizes from `offer` down to 0 that works, on a grid of 0.001 mm; null when none does. */
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
