import { expect, test } from "vitest";
import { leaderRows, type Leader } from "./leaders.ts";

/** Notes at places along the part, the most important first, mm on paper. */
const notes = (places: readonly number[]): readonly Leader[] =>
  places.map((x, i) => ({ size: { text: `⌀123.4${i}` }, to: { x, y: 0 }, isMark: false }));

test.each([
  ["all notes with room stay", [10, 40, 70], 100, ["0", "1", "2"]],
  ["the least important goes, on the left", [70, 60, 50, 40, 30, 20, 10], 30, ["0", "1", "2", "3"]],
  ["and on the right", [10, 20, 30, 40, 50, 60, 70], 30, ["0", "1", "2", "3"]],
])("%s", (_, places, width, kept) => {
  const { rows } = leaderRows(notes(places), width, []);
  expect(rows.map(({ leader }) => leader.size.text.at(-1)).toSorted()).toEqual(kept);
});
