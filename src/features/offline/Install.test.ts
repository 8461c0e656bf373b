import { expect, test } from "vitest";
import { installsByHand } from "./Install.tsx";

test.each([
  ["Safari on a phone", { standalone: false, maxTouchPoints: 5 }, true],
  ["started from the home screen", { standalone: true, maxTouchPoints: 5 }, false],
  ["Safari on a Mac", { standalone: false, maxTouchPoints: 0 }, false],
  ["Chrome on a tablet", { maxTouchPoints: 5 }, false],
])("the way by hand in %s", (_, navigator, shown) => expect(installsByHand(navigator)).toBe(shown));
