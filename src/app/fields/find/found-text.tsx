import type { ReactNode } from "react";
import { matchesIn, type Match } from "./text-search.ts";

/** What is searched in a text that is only read, and the occurrence that is shown. */
export interface PrintedSearchState {
  readonly sought: string;
  readonly shown: Match | null;
}

/** A line with its occurrences marked. `shown`: where in it the shown one begins. */
export function foundIn(line: string, sought: string, shown: number | null): ReactNode {
  const matches = matchesIn(line, sought);
  if (matches.length === 0) return line;
  return matches.flatMap(({ from, to }, i) => [
    line.slice(matches[i - 1]?.to ?? 0, from),
    <mark key={from} className={`nc-found${from === shown ? " shown" : ""}`}>
      {line.slice(from, to)}
    </mark>,
    i === matches.length - 1 ? line.slice(to) : "",
  ]);
}
