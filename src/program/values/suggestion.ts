import type { Cycle } from "../../cycles/define.ts";
import { firstValues } from "../../cycles/first-values.ts";
import type { Param } from "../../cycles/params.ts";

/** Context of a suggestion: the faces of a set blank, ⌀ and Z, mm. */
export interface SuggestionContext {
  readonly blank: { readonly outside: number | null; readonly bore: number | null; readonly front: number | null };
  /** Feeds are per revolution, like the usual values. */
  readonly perRevolution: boolean;
  /** Values of the previous operation, by Q. */
  readonly before?: Readonly<Partial<Record<string, number>>>;
}

/** Default of plain parameters: an angle, a corner radius, an absent corner element. */
const isPlain = ({ kind, rounds, shown }: Param) =>
  rounds || (kind === "angle" && shown === "outline") || shown === "element";

/** A position or dimension of the drawing: it cannot be suggested. */
export const isOfDrawing = ({ kind, shown, sizes, text }: Param) =>
  sizes === undefined &&
  (kind === "diameter" ||
    ((kind === "axial" || kind === "length") && shown === "outline") ||
    shown === "pitch" ||
    text === "blankAllowance");

/**
 * Suggestion for an open prompt: the face for a start, the usual value where the drawing does not decide, or the
 * previous operation's value. Null where only the drawing decides.
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
