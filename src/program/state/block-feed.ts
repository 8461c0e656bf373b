import { feed as feedNumber, type Feed as FeedNumber } from "../../kernel/units.ts";
import type { FeedWord } from "../../nc/words.ts";
import { programIssue } from "./issue.ts";
import type { Machine } from "./machine.ts";

/** Limits of plausible feeds: the slowest in mm/min, the fastest in mm/rev. */
const SLOWEST = 1;
const FASTEST = 2;

/** A valid feed that is surely a typing error. */
export const isUnlikely = (n: number, perRevolution: boolean): boolean =>
  perRevolution ? n > FASTEST : n > 0 && n < SLOWEST;

/** A number behind F: mm/rev or mm/min. FU is per revolution in either mode. */
function feedOf(machine: Machine, feed: Exclude<FeedWord, string>, index: number): FeedNumber | null {
  const n = machine.number(feed.value, index);
  return n === null ? null : machine.feedOf(n);
}

/** Sets the feed of a block without motion. F stays in force; FMAX counts for its block only. */
export function takeFeed(machine: Machine, feed: FeedWord | undefined, index: number): void {
  if (feed === undefined || feed === "max") return;
  machine.set({ feedWord: feed === "auto" ? "FAUTO" : "F" });
  machine.set({
    feed:
      feed === "auto" ? (machine.now.toolFeed ?? feedNumber(0)) : (feedOf(machine, feed, index) ?? machine.now.feed),
  });
}

/** Reports the fault of a feed at its first motion. */
function judge(machine: Machine, feed: FeedNumber, index: number): void {
  const { perRevolution } = machine.now,
    { feedUnit } = machine;
  const now = `${feed} ${feedUnit} ${machine.now.feedWord}`;
  if (now === machine.now.judged) return;
  machine.set({ judged: now });
  if (!(feed > 0))
    machine.log.report(
      programIssue("feedZero", "error", { word: machine.now.feedWord === "FAUTO" ? "FAUTO" : `F${feed}` }, "F"),
      index,
    );
  else if (isUnlikely(feed, perRevolution))
    machine.log.report(programIssue("feedUnlikely", "warning", { feed, unit: feedUnit }, "F"), index);
}

/** The feed of a block that moves: null is rapid. */
export function blockFeed(machine: Machine, feed: FeedWord | undefined, index: number): FeedNumber | null {
  if (feed === "max") {
    machine.set({ lastFeed: null });
    return null;
  }
  takeFeed(machine, feed, index);
  if (machine.now.feed === null) machine.log.reportOnce(programIssue("feedMissing", "error", {}), index);
  else {
    judge(machine, machine.now.feed, index);
    machine.set({ lastFeed: machine.now.feed });
  }
  // Without a feed the control stops; the path is still shown, and never as a rapid.
  return machine.now.feed ?? feedNumber(0);
}

/** Feed of M140 or another function with its own feed; rapid without one. The path feed is unchanged. */
export function functionFeed(machine: Machine, feed: FeedWord | undefined, index: number): FeedNumber | null {
  if (feed === undefined || feed === "max") return null;
  return feed === "auto" ? machine.now.toolFeed : feedOf(machine, feed, index);
}
