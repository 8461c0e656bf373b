import type { Cycle } from "../../cycles/define.ts";
import { firstValues } from "../../cycles/first-values.ts";
import type { Param } from "../../cycles/params.ts";

/** What a suggestion goes by besides the cycle: the faces of a blank that somebody has set, ⌀ and Z, mm. */
export interface SuggestionContext {
  readonly blank: { readonly outside: number | null; readonly bore: number | null; readonly front: number | null };
  /** Feeds are per revolution: those that are usual here are. */
  readonly perRevolution: boolean;
  /** Values of the same parameter in the operation before, by Q. */
  readonly before?: Readonly<Partial<Record<string, number>>>;
}

/**
 * What a turner enters where nothing else is wanted: an angle, a corner radius, an element of a corner that is not
 * there.
 */
const isPlain = ({ kind, rounds, shown }: Param) =>
  rounds || (kind === "angle" && shown === "outline") || shown === "element";

/** A position or a measure that the drawing gives: nobody can suggest it. */
const isOfDrawing = ({ kind, shown, sizes, text }: Param) =>
  sizes === undefined &&
  (kind === "diameter" ||
    ((kind === "axial" || kind === "length") && shown === "outline") ||
    shown === "pitch" ||
    text === "blankAllowance");

/**
 * What an unanswered prompt may be answered with, for somebody to take: the face where a start is asked for, the usual
 * value of what is no size of the drawing, or what the operation before had there. Null where only the drawing knows.
 */
export function suggestedValue(
  cycle: Cycle,
  q: string,
  { blank, perRevolution, before = {} }: SuggestionContext,
): number | null {
  const param = cycle.params[q];
  if (!param || param.reserved) return null;
  if (param.text === "startZ") return blank.front ?? 0;
  if (param.text === "startDiameter") return blank.bore !== null && blank.bore > 0 ? null : blank.outside;
  if (isOfDrawing(param)) return null;
  const last = before[q];
  if (last !== undefined) return last;
  if (isPlain(param)) return 0;
  if (param.kind === "feed" && !perRevolution && !param.perMinute) return null;
  return firstValues(cycle)[q] ?? null;
}
