import type { FinishedPart } from "../src/planning/part/finished-part.ts";
import { readPart } from "../src/planning/part/part-file.ts";

/** Steps of the shaft with three features each: a chamfer, a cylinder and a groove. */
const STEPS = 10;
/** Length of a step, ⌀ of the first and rise of the ⌀ from one to the next, mm. */
const [LENGTH, FIRST, RISE] = [12, 20, 4];
/** Distance of a groove from its shoulder, its breadth and its depth on the ⌀, mm. */
const [BESIDE, BREADTH, DEPTH] = [5, 3, 3];

const stepRows = (_: unknown, i: number) => {
  const [x, front] = [FIRST + RISE * i, -LENGTH * i];
  return [
    { x },
    { kind: "CHF", r: 0.5 },
    { z: front - BESIDE },
    { x: x - DEPTH },
    { z: front - BESIDE - BREADTH },
    { x },
    { z: front - LENGTH },
  ];
};

/** A shaft of thirty features: chamfers, cylinders and grooves. Throws where it is no part. */
export function longShaft(): FinishedPart {
  const outside = FIRST + RISE * STEPS;
  const { part, problems } = readPart(
    JSON.stringify({
      format: "turnwise-part/1",
      name: "LONG SHAFT",
      material: "c45",
      blank: { outside, bore: 0, length: LENGTH * STEPS + 45, allowance: 1.5 },
      clamping: {
        kind: "chuckOutside",
        words: { D: outside, LENGTH: 35, FACE: -LENGTH * STEPS - 8.5, SIZE: 200 },
      },
      outside: [{ x: 0, z: 0 }, ...Array.from({ length: STEPS }, stepRows).flat()],
      unmachinedBehind: true,
    }),
  );
  if (!part) throw new Error(JSON.stringify(problems));
  return part;
}
