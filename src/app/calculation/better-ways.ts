import type { BetterWay, Candidate, Search } from "../../report/better-ways/better-ways.ts";
import type { Conditions } from "../../report/better-ways/situation.ts";
import type { ProgramWork } from "../document/work.ts";
import { requestOfOther } from "./other-outcome.ts";
import { askAgain } from "./worker-life.ts";

/** Looks for changes that may be better, to be tried one by one; null if the program cannot be calculated. */
export async function searchBetterWays(
  program: ProgramWork,
  conditions: Omit<Conditions, "tools">,
): Promise<Search | null> {
  try {
    const request = await requestOfOther(program);
    return await askAgain((engine) => engine.searchBetterWays(request, conditions));
  } catch {
    return null;
  }
}

/** Tries one of them; null unless it is better. */
export async function tryBetterWay(
  program: ProgramWork,
  { baseline }: Search,
  candidate: Candidate,
): Promise<BetterWay | null> {
  try {
    const request = await requestOfOther(program);
    return await askAgain((engine) => engine.tryBetterWay(candidate, baseline, request));
  } catch {
    return null;
  }
}
