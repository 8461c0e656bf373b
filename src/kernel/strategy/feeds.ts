import type { Feed } from "../units.ts";

/**
 * Feeds of a cycle, resolved: FAUTO replaced by the feed of the tool call, a plunging feed of 0 by the roughing feed.
 */
export interface Feeds {
  readonly rough: number;
  readonly plunge: number;
  readonly finish: number;
}

/** Resolves the feeds of a cycle; `auto` is the feed of the tool call, or null when none was given (then 0). */
export function feedsOf(
  q: { rough: Feed | "auto"; finish: Feed | "auto"; plunge?: Feed | "auto" },
  auto: Feed | null,
): Feeds {
  const value = (f: Feed | "auto") => (f === "auto" ? (auto ?? 0) : f);
  const rough = value(q.rough);
  const plunge = q.plunge === undefined ? 0 : value(q.plunge);
  return { rough, finish: value(q.finish), plunge: plunge > 0 ? plunge : rough };
}
