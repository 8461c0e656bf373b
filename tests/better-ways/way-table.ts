import type { BetterWay } from "../../src/report/better-ways/better-ways.ts";
import { peerPrograms } from "./peer-programs.ts";
import { brokenByWay, takenInTurn, waysOf } from "./way-laws.ts";

/** Most ways that are taken one after the other: more of them would be a circle. */
const MOST_IN_TURN = 15;

const told = ({ subject: { kind, units, ...more }, before, after, gains }: BetterWay): string =>
  `${kind} ${JSON.stringify({ units, ...more })} | ${gains.join()} | ${before.seconds.toFixed(1)} → ${after.seconds.toFixed(1)} s`;

/** All suggestions for the peer programs, a line each, with what they break. Yields as they are found. */
export function* wayTable(only = "", inTurn = false): Generator<string> {
  let broken = 0;
  for (const peer of peerPrograms().filter(({ name }) => name.includes(only))) {
    const { ways, tried } = waysOf(peer);
    yield `${peer.name}: ${tried} tried`;
    for (const way of ways) {
      const faults = brokenByWay(peer, way);
      broken += faults.length;
      yield `  ${told(way)}${faults.map((fault) => `\n    BROKEN ${fault}`).join("")}`;
    }
    const taken = inTurn ? [...takenInTurn(peer, MOST_IN_TURN)] : [];
    if (taken.length === MOST_IN_TURN) broken += 1;
    if (taken.length === MOST_IN_TURN) yield `  BROKEN no end: ${taken.map(({ subject }) => subject.kind).join(", ")}`;
  }
  yield `${broken} broken`;
}
