import { expect, test } from "vitest";
import { peerPrograms } from "./peer-programs.ts";
import { brokenByWay, waysOf } from "./way-laws.ts";

/** `npm run laws -- --ways` tries all peer programs. */
const solutions = peerPrograms().filter(({ name }) => /^l(?:0[27]|1[1-57]|20|22)-/.test(name));

test.each(solutions.map((peer) => [peer.name, peer] as const))("what is suggested for %s holds", (_, peer) => {
  for (const way of waysOf(peer).ways) expect([way.subject, brokenByWay(peer, way)]).toEqual([way.subject, []]);
});
