import { intervalsBelow } from "../reach/below.ts";
import { highest, lowest, type Envelope, type Interval } from "../reach/envelope.ts";
import { SAME } from "../tolerance.ts";

/** A side of a section: where its wall begins, and the height down to which the material next to it is cut before. */
export interface Rim {
  readonly u: number;
  readonly v: number;
}

/** A valley cut on its own, level by level, until it splits or ends at its floor. Strategy space, mm. */
export interface RecessSection {
  /** The ends of the area, or the crests between it and its neighbours. */
  readonly left: Rim;
  readonly right: Rim;
  /**
   * The pass of its first level, and its interval at each level from there on; a valley between two levels has none.
   */
  readonly first: number;
  readonly levels: readonly Interval[];
  /** The valleys that it splits into below its last level, in order. */
  readonly inner: readonly RecessSection[];
}

/** Evenly divided heights: level `pass` is `pass` infeeds below `top`. */
export interface Heights {
  readonly top: number;
  readonly passes: number;
  readonly infeed: number;
}

export const heightOf = ({ top, infeed }: Heights, pass: number) => top - pass * infeed;

/**
 * The valleys of an area below its top, from left to right, each with the valleys that it splits into (decision
 * "Sections of a recess").
 */
export function sectionsOf(e: Envelope, h: Heights, area: Interval): RecessSection[] {
  const within = (pass: number, valley: Interval, left: Rim, right: Rim): RecessSection[] => {
    const parts = pass > h.passes ? [] : intervalsBelow(e, heightOf(h, pass), valley.from, valley.to);
    const crest = (i: number): Rim => {
      const [before, after] = [parts[i - 1], parts[i]];
      return before && after
        ? { u: highest(e, before.to, after.from).u, v: heightOf(h, pass - 1) }
        : before
          ? right
          : left;
    };
    return parts.map((part, i) => downFrom(pass, part, crest(i), crest(i + 1)));
  };
  const downFrom = (first: number, part: Interval, left: Rim, right: Rim): RecessSection => {
    const levels = [part];
    for (let pass = first + 1, here = part; pass <= h.passes; pass += 1) {
      const next = intervalsBelow(e, heightOf(h, pass), here.from, here.to);
      if (next.length !== 1) return { left, right, first, levels, inner: within(pass, here, left, right) };
      here = next[0] as Interval;
      levels.push(here);
    }
    return { left, right, first, levels, inner: [] };
  };
  return intervalsBelow(e, h.top, area.from, area.to).flatMap((open) => {
    const [left, right]: Rim[] = [
      { u: open.from, v: h.top },
      { u: open.to, v: h.top },
    ];
    if (!left || !right) return [];
    const parts = within(1, open, left, right);
    if (parts.length > 0) return parts;
    return lowest(e, open.from, open.to) < h.top - SAME ? [{ left, right, first: 1, levels: [], inner: [] }] : [];
  });
}
