import { readFileSync } from "node:fs";
import { expect, it } from "vitest";
import { answerOf } from "../../src/course/judge/answer.ts";
import { judge } from "../../src/course/judge/judge.ts";
import { taskSchema } from "../../src/course/task.ts";

/** Tasks, with changes that another good programmer might make to the stored solution. */
const OTHER_WAYS: readonly {
  readonly id: string;
  readonly changes: readonly (readonly [from: string, to: string])[];
}[] = [
  { id: "l22-pin", changes: [["TOOL CALL 3", "TOOL CALL 4"]] },
  { id: "l22-pin", changes: [["TOOL CALL 1", "TOOL CALL 3"]] },
  // The middle of the tolerance instead of the nominal size.
  {
    id: "l22-pin",
    changes: [
      ["L X+25 Z+0", "L X+24.99 Z+0"],
      ["L X+28 Z-1.5", "L X+27.99 Z-1.5"],
    ],
  },
  { id: "l22-hub-flange", changes: [["Q493=+40 ", "Q493=+40.012 "]] },
  { id: "l22-clamp-shaft", changes: [["Q468=+0", "Q468=+1"]] },
  {
    id: "l18-finish-neck",
    changes: [
      ["APPR LT X+40 Z+0 LEN2", "APPR CT X+40 Z+0 CCA60 R+3"],
      ["DEP LT LEN3", "DEP CT CCA90 R+2"],
    ],
  },
  {
    id: "l18-finish-neck",
    changes: [
      ["APPR LT X+40 Z+0 LEN2", "APPR LCT X+40 Z+0 R3"],
      ["DEP LT LEN3", "DEP LCT X+70 Z-26 R2"],
    ],
  },
  // The middle of a tolerance.
  { id: "l20-diameter-as-radius", changes: [["Q493=+38 ", "Q493=+37.99 "]] },
  { id: "l07-second-tool", changes: [["Q493=+42.8 ", "Q493=+42.795 "]] },
  { id: "l20-start-inside", changes: [["L X+79 Z-29.5", "L X+80 Z-33.5"]] },
  { id: "l20-rapid-into-work", changes: [["L X+84 Z-24 FMAX M303", "L X+100 Z-24 FMAX M303"]] },
  { id: "l17-way-out", changes: [["L X+39 FMAX", "L X+36 FMAX"]] },
  { id: "l16-into-the-collar", changes: [["Q466=+1.5", "Q466=+2"]] },
  {
    id: "l21-mirror",
    changes: [
      ["TOOL CALL 3", "TOOL CALL 1"],
      ["Q505=+0.085", "Q505=+0.12"],
    ],
  },
  // Another contour label instead of the number in cycle 14.
  {
    id: "l09-lost-contour",
    changes: [
      ["CONTOUR LABEL7", "CONTOUR LABEL1"],
      ["LBL 7", "LBL 1"],
    ],
  },
  // The contour in the opposite direction instead of Q499.
  {
    id: "l10-inside-out",
    changes: [
      ["Q499=+1", "Q499=+0"],
      ["15 L X+38 Z+0", "15 L X+84 Z-11.4"],
      ["16 L Z-6.2", "16 L X+66"],
      ["17 RND R2", "17 RND R1"],
      ["18 L X+58", "18 L X+58 Z-6.2"],
      ["19 L X+66 Z-11.4", "19 L X+38"],
      ["20 RND R1", "20 RND R2"],
      ["21 L X+84", "21 L Z+0"],
    ],
  },
  {
    id: "l10-deep-first-pass",
    changes: [
      ["L X+88 Y+0 Z+2", "L X+92 Y+0 Z+1"],
      ["Q463=+2.4", "Q463=+1.1"],
    ],
  },
  { id: "l11-ridge", changes: [["TOOL CALL 2", "TOOL CALL 4"]] },
  { id: "l11-undercut", changes: [["TOOL CALL 2", "TOOL CALL 3"]] },
  {
    id: "l12-820-empty",
    changes: [
      ["CONTOUR LABEL2", "CONTOUR LABEL9"],
      ["LBL 2", "LBL 9"],
      ["VC:180", "VC:140"],
      ["Q463=+3", "Q463=+2.2"],
    ],
  },
  // From the inner wall, with the tool in front of the middle of the groove.
  {
    id: "l13-seal-groove",
    changes: [
      ["Q491=+62.4", "Q491=+53"],
      ["Q493=+53", "Q493=+62.4"],
      ["L X+62.4 Y+0", "L X+57.7 Y+0"],
    ],
  },
  { id: "l13-careful-setter", changes: [["Q463=+1 ", "Q463=+1.5 "]] },
  {
    id: "l14-852-empty",
    changes: [
      ["L X+75 Y+0 Z+2", "L X+62.5 Y+0 Z-19"],
      ["Q507=+0", "Q507=+1"],
    ],
  },
  { id: "l14-series", changes: [["L X+75 Y+0 Z-18", "L X+75 Y+0 Z-19"]] },
  {
    id: "l14-842-oil-groove",
    changes: [
      ["L X+68 Y+0 Z-24", "L X+72 Y+0 Z-30"],
      ["Q463=+1.5", "Q463=+1.6"],
    ],
  },
  {
    id: "l15-retaining-ring",
    changes: [
      ["Q492=-30 ", "Q492=-32.15 "],
      ["Q494=-32.15", "Q494=-30"],
    ],
  },
  { id: "l15-jammed-chip", changes: [["Q463=+4", "Q463=+2.5"]] },
];

it.each(OTHER_WAYS)("$id is passed in another way as well: $changes", ({ id, changes }) => {
  const file = new URL(`../../src/course/tasks/${id}.json`, import.meta.url);
  const task = taskSchema.parse(JSON.parse(readFileSync(file, "utf8")));
  const stored = (task.solution ?? []).join("\n");
  const other = changes.reduce((text: string, [from, to]) => {
    expect(text).toContain(from);
    return text.replaceAll(from, to);
  }, stored);
  expect(judge(task, answerOf(other)).marks.filter((mark) => !mark.passed)).toEqual([]);
});
