import type { Move } from "../kernel/plan/move.ts";
import type { Params, Topic } from "./params.ts";

/** The topics of the values that make a move, the most decisive first. */
const MADE_BY: Readonly<Record<Move["run"], readonly Topic[]>> = {
  rough: ["infeed", "roughingFeed"],
  finish: ["finishingFeed"],
};

/**
 * The Q that decides most about a move: the infeed of a roughing pass, the feed of a finishing cut; null without one.
 */
export function decidingParameter(params: Params, { run }: Pick<Move, "run">): string | null {
  const qs = MADE_BY[run].map((topic) => Object.keys(params).find((q) => params[q]?.shown === topic));
  return qs.find((q) => q !== undefined) ?? null;
}
