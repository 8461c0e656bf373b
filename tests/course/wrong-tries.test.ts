import { expect, test } from "vitest";
import { markText } from "../../src/features/course/task/mark-words.ts";
import { answerOf } from "../../src/course/judge/answer.ts";
import { judge } from "../../src/course/judge/judge.ts";
import { programOfLines } from "../../src/course/task-start.ts";
import { taskSchema, type Task } from "../../src/course/task.ts";
import { texts } from "../../src/i18n/index.ts";
import { courseTask } from "../../src/i18n/en/course-task.ts";
import shoulderFile from "../../src/course/tasks/l03-first-shoulder.json";
import byHandFile from "../../src/course/tasks/l01-turn-by-hand.json";
import discFile from "../../src/course/tasks/l15-jammed-chip.json";
import seatFile from "../../src/course/tasks/l05-chamfered-seat.json";
import rodFile from "../../src/course/tasks/l16-drawn-rod.json";

const [shoulder, rod, seat, byHand, disc] = [shoulderFile, rodFile, seatFile, byHandFile, discFile].map((file) =>
  taskSchema.parse(file),
) as [Task, Task, Task, Task, Task];

/** The messages for the solution with one change, the first one first. */
function markTexts(task: Task, from: string, to: string): string[] {
  const right = programOfLines(task.solution ?? []);
  expect(right).toContain(from);
  const answer = answerOf(right.replace(from, to));
  const marks = judge(task, answer).marks.filter(({ passed }) => !passed);
  return marks.map((mark) => markText(mark, { t: courseTask, texts: texts("en"), language: "en", task, answer }));
}
const { wrongSide: turnedRound } = courseTask.wrong;

test.each([
  ["a forgotten minus", "Q494=-27.4", "Q494=+27.4", "Q494 End Z: Z+27.4 is in front of the workpiece. -27.4?: block 7"],
  [
    "a diameter doubled",
    "Q493=+48.2",
    "Q493=+96.4",
    "Q493 End ⌀: ⌀96.4 is larger than the blank, ⌀63.5, exactly twice as much: a diameter entered as a radius?: block 7",
  ],
  ["a start within the steel", "8 L X+63.5 Z+2", "8 L X+40 Z+2", `${turnedRound.inside}: block 9`],
])("%s is reported by its effect on the cycle, not as a wrong tool", (_, from, to, said) => {
  expect(markTexts(shoulder, from, to)[0]).toBe(said);
});

test("half of a wanted diameter is questioned as a radius", () => {
  expect(markTexts(shoulder, "Q493=+48.2", "Q493=+24.1")).toContainEqual(
    expect.stringMatching(/^⌀ 24\.1 instead of ⌀ 48\.2 ±\S+ exactly half of it: a radius\?/),
  );
});

test("every place with material left names the call that should have cut it; allowed residue is not marked", () => {
  const places = markTexts(shoulder, "8 L X+63.5 Z+2", "8 L X+63.5 Z-5").filter((line) =>
    line.startsWith("Material left"),
  );
  expect(places).toHaveLength(1);
  expect(places[0]).toMatch(/^Material left, up to 0\.2\d mm thick at ⌀48\.\d+, Z-0\.\d+: block 9, shaped by Q493 /);
  expect(
    markTexts(shoulder, "Q494=-27.4", "Q494=+27.4").filter(
      (line) => line.startsWith("Material left") && !line.includes(": block 9"),
    ),
  ).toEqual([]);
});

test.each([
  ["a chamfer at the beginning left out", seat, /Q501=\+1/, "Q501=+0", "Q501"],
  ["left out with its size", seat, /Q501=\+1(.*\n.*)Q502=\+1\.2/, "Q501=+0$1Q502=+0", "Q501"],
  ["a rounding in place of a chamfer", seat, /Q501=\+1/, "Q501=+2", "Q501"],
  ["a size too small", seat, /Q502=\+1\.2/, "Q502=+0.6", "Q502"],
  ["a diameter too large", seat, /Q493=\+52\.8/, "Q493=+53.2", "Q493"],
  ["a shoulder too short", shoulder, /Q494=-27\.4/, "Q494=-20", "Q494"],
  ["a shoulder too long", shoulder, /Q494=-27\.4/, "Q494=-40", "Q494"],
  ["a diameter too small", seat, /Q493=\+52\.8/, "Q493=+50", "Q493"],
  ["a rounding left out", seat, /Q500=\+1/, "Q500=+0", "Q500"],
  ["a chamfer far too small", seat, /Q502=\+1\.2/, "Q502=+0.12", "Q502"],
  ["an end element too large", seat, /Q504=\+0\.6/, "Q504=+1", "Q504"],
  ["an end element without its size", seat, /Q504=\+0\.6/, "Q504=+0", "Q504"],
])("wrong material is explained by the value that makes the contour there: %s", (_, task, from, to, q) => {
  const right = programOfLines(task.solution ?? []);
  const wrong = right.replace(from, to);
  expect(wrong).not.toBe(right);
  const found = judge(task, answerOf(wrong)).marks.find(
    ({ rule, passed }) => (rule === "residue" || rule === "missing") && !passed,
  );
  expect(found?.shapedBy).toEqual({ q });
});

test("material left by blocks without a cycle names the block that cut beside it", () => {
  expect(markTexts(byHand, "X+44.6", "X+45.6")[0]).toMatch(/^Material left, up to 0\.\d+ mm thick at .*: block 11$/);
});

test("a bite that is too deep names the prompt that limits it", () => {
  const said = /^A pass is 13\.5 mm deep; 4 mm are allowed: block 9, pass 1, set by Q463 /;
  expect(markTexts(disc, "Q463=+4", "Q463=+0")).toContainEqual(expect.stringMatching(said));
});

test("where nothing was cut, no dimension is the reason", () => {
  expect(markTexts(shoulder, "TOOL CALL 1", "TOOL CALL 5").filter((line) => line.includes("shaped by"))).toEqual([]);
});

test("a thread of another pitch is reported once, by its pitch; a missing one as missing", () => {
  const pitch = markTexts(rod, "Q472=+1.5", "Q472=+2").filter((line) => line.includes("Z-"));
  expect(pitch).toEqual(["Thread M30×1.5 has a pitch of 2 mm instead of 1.5 at ⌀30, Z-12: block 9"]);
  expect(markTexts(rod, "Q494=-24", "Q494=+24")).toContainEqual(
    expect.stringMatching(/^Thread M30×1\.5 is missing: no groove is cut .* at ⌀30, Z-12/),
  );
});

test.each([
  ["Q215=+0", "Q215=+2", /^A pass is 7\.\d+ mm deep; 2\.5 mm are allowed: block 9, finishing cut, set by Q215 /],
  ["Q483=+0.5", "Q483=+16", /^A pass is 7\.\d+ mm deep; .*, finishing cut, set by Q483 /],
  ["Q484=+0.2", "Q484=+2", /^A pass is 7\.\d+ mm deep; .*, finishing cut, set by Q484 /],
  ["Q463=+2.5", "Q463=+25", /^A pass is 7\.4 mm deep; 2\.5 mm are allowed: block 9, pass 1, set by Q463 /],
])("a pass that is too deep names the prompt that decides it: %s → %s", (from, to, said) => {
  expect(markTexts(shoulder, from, to)).toContainEqual(expect.stringMatching(said));
});
