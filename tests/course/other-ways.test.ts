import { readFileSync } from "node:fs";
import { expect, it } from "vitest";
import { answerOf } from "../../src/course/judge/answer.ts";
import { judge } from "../../src/course/judge/judge.ts";
import { taskSchema } from "../../src/course/task.ts";

/** Task, and what another good programmer writes in place of the stored solution. */
const OTHER_WAYS: readonly { readonly id: string; readonly changes: readonly (readonly [from: string, to: string])[] }[] = [
  { id: "l22-pin", changes: [["TOOL CALL 3", "TOOL CALL 4"]] },
  { id: "l22-pin", changes: [["TOOL CALL 1", "TOOL CALL 3"]] },
  // The middle of the tolerance in place of the nominal size.
  { id: "l22-pin", changes: [["L X+25 Z+0", "L X+24.99 Z+0"], ["L X+28 Z-1.5", "L X+27.99 Z-1.5"]] },
  { id: "l22-hub-flange", changes: [["Q493=+40 ", "Q493=+40.012 "]] },
  { id: "l22-clamp-shaft", changes: [["Q468=+0", "Q468=+1"]] },
  { id: "l18-finish-neck", changes: [["APPR LT X+40 Z+0 LEN2", "APPR CT X+40 Z+0 CCA60 R+3"], ["DEP LT LEN3", "DEP CT CCA90 R+2"]] },
  { id: "l18-finish-neck", changes: [["APPR LT X+40 Z+0 LEN2", "APPR LCT X+40 Z+0 R3"], ["DEP LT LEN3", "DEP LCT X+70 Z-26 R2"]] },
  { id: "l20-start-inside", changes: [["L X+79 Z-29.5", "L X+80 Z-33.5"]] },
  { id: "l20-rapid-into-work", changes: [["L X+84 Z-24 FMAX M303", "L X+100 Z-24 FMAX M303"]] },
  { id: "l17-way-out", changes: [["L X+39 FMAX", "L X+36 FMAX"]] },
  { id: "l16-into-the-collar", changes: [["Q466=+1.5", "Q466=+2"]] },
  { id: "l21-mirror", changes: [["TOOL CALL 3", "TOOL CALL 1"], ["Q505=+0.085", "Q505=+0.12"]] },
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
