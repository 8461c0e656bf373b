import { readdirSync, readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import { answerOf } from "../../src/course/judge/answer.ts";
import { judge, judgeUnplaced } from "../../src/course/judge/judge.ts";
import type { Answer, Slip } from "../../src/course/judge/judgement.ts";
import { BY_DIMENSIONS, findSlip, hasSlip, wantedSizes, withoutSlip, withSlip } from "../../src/course/judge/slips.ts";
import { everySlip } from "../../src/course/judge/possible-slips.ts";
import { programOfLines } from "../../src/course/task-start.ts";
import { taskSchema, type Task } from "../../src/course/task.ts";

const folder = new URL("../../src/course/tasks/", import.meta.url);
const tasks = readdirSync(folder).map((file) =>
  taskSchema.parse(JSON.parse(readFileSync(new URL(file, folder), "utf8"))),
);
const runOf = (text: string) => Promise.resolve(answerOf(text));

/** The slip that a change makes: its reverse is what the learner has to be told. */
const UNDONE: Readonly<Record<Slip["kind"], Slip["kind"]>> = {
  sign: "sign",
  exchanged: "exchanged",
  reversed: "reversed",
  point: "point",
  side: "side",
  relative: "relative",
  order: "order",
  call: "call",
  radius: "doubled",
  doubled: "radius",
  tools: "tools",
  tool: "tool",
};
const reverse = ({ kind, values }: Slip): Slip => ({
  kind: UNDONE[kind],
  values: values.map(({ value, better, ...where }) => ({ ...where, value: better, better: value })),
});

/** Whether a slip is one in a size of the part: of the start points, nobody doubles one. */
function isInSize({ x, z }: ReturnType<typeof wantedSizes>, { kind, values }: Slip): boolean {
  const sizes = kind === "sign" ? z : kind === "exchanged" ? [...x, ...z] : x;
  return values.every(({ value }) => kind === "reversed" || sizes.some((size) => Math.abs(size - value) < 0.001));
}

/** Kinds that are planted in every task; the others have tables of their own below. */
const KINDS = ["sign", "exchanged", "reversed", "radius", "doubled"] as const satisfies readonly Slip["kind"][];
/** Kinds planted in one task: each begins with another one. LAW_SLIPS=5 plants all of them. */
const EACH = Number(process.env["LAW_SLIPS"] ?? 1);

type Planted = { readonly slip: Slip; readonly text: string } | undefined;
const plantedIn = new Map<string, Planted>();

/** The first slip of a kind in the solution of a task that the part suffers from, as it has to be named. */
function planted(task: Task, kind: Slip["kind"]): Planted {
  const key = `${task.id} ${kind}`;
  if (plantedIn.has(key)) return plantedIn.get(key);
  const { solution = [], ...asked } = task,
    wanted = wantedSizes(task);
  const found = everySlip(programOfLines(solution)).find(
    ({ slip, text }) =>
      UNDONE[slip.kind] === kind &&
      isInSize(wanted, slip) &&
      judgeUnplaced(asked, answerOf(text)).marks.some(({ passed, rule }) => !passed && BY_DIMENSIONS.has(rule)),
  );
  const named = found && { slip: reverse(found.slip), text: found.text };
  plantedIn.set(key, named);
  return named;
}

/** Of the kinds, beginning with the one whose turn it is, the first that a task can suffer from. */
function plantedAtTurn(task: Task, turn: number): readonly NonNullable<Planted>[] {
  const found: NonNullable<Planted>[] = [];
  for (let i = 0; i < KINDS.length && found.length < EACH; i += 1) {
    const each = planted(task, KINDS[(turn + i) % KINDS.length] as Slip["kind"]);
    if (each) found.push(each);
  }
  return found;
}

describe("a slip in a task's solution is the first that a check names, with its value", () => {
  const solved = tasks.filter(({ solution }) => solution);
  test.each(solved.map((task, turn) => [task.id, task, turn] as const))("%s", async (_, task, turn) => {
    // Undone, most slips are the same right program.
    const answers = new Map<string, Promise<Answer>>();
    const runOnce = (text: string) => {
      const answer = answers.get(text) ?? runOf(text);
      answers.set(text, answer);
      return answer;
    };
    for (const { slip, text } of plantedAtTurn(task, turn)) {
      const answer = answerOf(text),
        judgement = judge(task, answer);
      const found = await findSlip(task, answer, judgement, runOnce);
      expect(found?.slip).toEqual(slip);
      if (found) expect(withSlip(judgement, found).marks[0]?.slip).toEqual(slip);
    }
  });
});

test("the tasks together plant every kind of slip", () => {
  const contours = tasks.filter(({ id }) => /^l0[59]/.test(id));
  expect(KINDS.filter((kind) => !contours.some((task) => planted(task, kind)))).toEqual([]);
});

const taskOf = (id: string): Task => {
  const task = tasks.find((each) => each.id === id);
  if (!task) throw new Error(`no task ${id}`);
  return task;
};

/** The slip that a check of a task's solution with some texts replaced names, as kind and values. */
async function namedWith(id: string, ...changes: readonly (readonly [from: string | RegExp, to: string])[]) {
  const task = taskOf(id);
  const right = programOfLines(task.solution ?? []);
  const wrong = changes.reduce((text, [from, to]) => text.replace(from, to), right);
  expect(wrong).not.toBe(right);
  const answer = answerOf(wrong);
  const slip = (await findSlip(task, answer, judge(task, answer), runOf))?.slip;
  return slip ? [slip.kind, ...slip.values.map(({ block, q, value }) => (q === "" ? block : `${q} ${value}`))] : null;
}

test.each([
  ["a decimal point forgotten", "l03-first-shoulder", [["Q493=+48.2", "Q493=+482"]], ["point", "Q493 482"]],
  ["a decimal point too far left", "l03-first-shoulder", [["Q494=-27.4", "Q494=-2.74"]], ["point", "Q494 -2.74"]],
  ["a chamfer ten times too long", "l05-chamfered-seat", [["Q502=+1.2", "Q502=+12"]], ["point", "Q502 12"]],
  ["a radius ten times too long", "l05-chamfered-seat", [["Q500=+1", "Q500=+10"]], ["point", "Q500 10"]],
  ["a minus before a diameter", "l05-chamfered-seat", [["Q493=+52.8", "Q493=-52.8"]], ["sign", "Q493 -52.8"]],
  ["a minus before an X", "l01-turn-by-hand", [["X+44.6", "X-44.6"]], ["sign", "X -44.6"]],
  ["a minus before a retraction", "l01-turn-by-hand", [["12 L X+54", "12 L X-54"]], ["sign", "X -54"]],
  [
    "diameter and length exchanged",
    "l03-first-shoulder",
    [
      ["Q493=+48.2", "Q493=+27.4"],
      ["Q494=-27.4", "Q494=-48.2"],
    ],
    ["exchanged", "Q493 27.4", "Q494 -48.2"],
  ],
  [
    "diameter and length exchanged, the minus too",
    "l03-first-shoulder",
    [
      ["Q493=+48.2", "Q493=-27.4"],
      ["Q494=-27.4", "Q494=+48.2"],
    ],
    ["exchanged", "Q493 -27.4", "Q494 48.2"],
  ],
  ["a width as Z", "l15-retaining-ring", [["Q494=-32.15", "Q494=-2.15"]], ["relative", "Q494 -2.15"]],
  ["a depth as a diameter", "l15-retaining-ring", [["Q493=+47", "Q493=+1.5"]], ["relative", "Q493 1.5"]],
  ["towards the free end", "l15-retaining-ring", [["Q494=-32.15", "Q494=-27.85"]], ["side", "Q494 -27.85"]],
  [
    "sizes of two edges exchanged",
    "l05-chamfered-seat",
    [
      ["Q502=+1.2", "Q502=+0.6"],
      ["Q504=+0.6", "Q504=+1.2"],
    ],
    ["exchanged", "Q502 0.6", "Q504 1.2"],
  ],
  [
    "diameter and length exchanged in two blocks",
    "l01-turn-by-hand",
    [
      ["X+44.6", "X+22.4"],
      ["Z-22.4", "Z-44.6"],
    ],
    ["exchanged", "X 22.4", "Z -44.6"],
  ],
  [
    "blocks in the wrong order",
    "l01-turn-by-hand",
    [[/10 L (.*)\n11 L (.*)\n/, "10 L $2\n11 L $1\n"]],
    ["order", 10, 11],
  ],
  ["a cycle without its call", "l03-first-shoulder", [["9 CYCL CALL\n", ""]], ["call", 7]],
] as const)("%s is named: %s", async (_, id, changes, named) => {
  expect(await namedWith(id, ...changes)).toEqual(named);
});

test.each([
  // A cut that is too short or too long has no slip; neither has a block that was left out.
  ["l01-turn-by-hand", "X-1.6 F0.2", "X-0.6 F0.2"],
  ["l01-turn-by-hand", "10 L X+44.6 FMAX\n", ""],
  ["l09-cap-contour", "16 L X+39.4\n", ""],
  ["l05-chamfered-seat", "Q504=+0.6", "Q504=+0"],
])("no value that is right is suspected: %s, %s → %s", async (id, from, to) => {
  expect(await namedWith(id, [from, to])).toBeNull();
});

test("a wrong part without a slip has none, and a right one is not searched", async () => {
  const task = taskOf("l03-first-shoulder");
  const right = programOfLines(task.solution ?? []);
  const slipOf = async (text: string) => {
    const answer = answerOf(text);
    return findSlip(task, answer, judge(task, answer), runOf);
  };
  expect(await slipOf(right.replace("Q493=+48.2", "Q493=+51.7"))).toBeNull();
  expect(await slipOf(right.replace("Q494=-27.4", "Q494=-19.6"))).toBeNull();
  const none = () => Promise.reject(new Error("a right part is searched"));
  const answer = answerOf(right);
  expect(await findSlip(task, answer, judge(task, answer), none)).toBeNull();
});

test.each([
  ["l15-retaining-ring", { Q491: 25, Q493: 23.5 }, "radius"],
  ["l05-chamfered-seat", { Q491: 132, Q493: 105.6 }, "doubled"],
] as const)("%s: all diameters of the cycle are named: %j", async (id, values, kind) => {
  const task = taskOf(id);
  const text = Object.entries(values).reduce(
    (now, [q, value]) => now.replace(new RegExp(String.raw`\b${q}=\S+`), `${q}=+${value}`),
    programOfLines(task.solution ?? []),
  );
  const answer = answerOf(text);
  const slip = (await findSlip(task, answer, judge(task, answer), runOf))?.slip;
  expect(slip?.kind).toBe(kind);
  expect(slip?.values.map(({ q, value }) => [q, value])).toEqual(Object.entries(values));
});

test("what the slip causes is not reported beside it; a slip that the task itself contains is not named", async () => {
  const shoulder = taskOf("l03-first-shoulder");
  const answer = answerOf(programOfLines(shoulder.solution ?? []).replace("Q494=-27.4", "Q494=+27.4"));
  const judgement = judge(shoulder, answer);
  expect(judgement.marks.filter(({ passed, rule }) => !passed && rule === "errors")).toHaveLength(1);
  const found = await findSlip(shoulder, answer, judgement, runOf);
  const told = found && withSlip(judgement, found).marks.filter(({ passed }) => !passed);
  expect(told?.map(({ rule, issue }) => (issue ? issue.code : rule)).slice(0, 2)).toEqual(["errors", "residue"]);

  const fault = taskOf("l20-diameter-as-radius");
  const text = "program" in fault.start ? programOfLines(fault.start.program) : "";
  const unmended = answerOf(text);
  const slip = (await findSlip(fault, unmended, judge(fault, unmended), runOf))?.slip;
  expect(slip?.kind).toBe("radius");
  expect(slip && hasSlip(fault, text, slip)).toBe(true);
  expect(slip && hasSlip(fault, programOfLines(fault.solution ?? []), slip)).toBe(false);
});

describe("the tools are named first where they explain the fault", () => {
  const swapped = (task: Task, one: number, other: number) =>
    programOfLines(task.solution ?? []).replaceAll(/TOOL CALL (\d+)/g, (call, tool) =>
      Number(tool) === one ? `TOOL CALL ${other}` : Number(tool) === other ? `TOOL CALL ${one}` : call,
    );
  test.each([
    // Roughing and finishing, with the sides of the part.
    ["l07-second-tool", [1, 3], "tools"],
    ["l07-tools-exchanged", [1, 3], "tools"],
    // Facing and boring.
    ["l22-hub-flange", [15, 5], "tools"],
    // An outside tool in a bore, and an inside one outside.
    ["l17-bush", [5, 1], "tool"],
    ["l03-first-shoulder", [1, 5], "tool"],
    ["l14-852-values", [8, 10], "tool"],
  ] as const)("%s: %j", async (id, [one, other], kind) => {
    const task = taskOf(id);
    const answer = answerOf(swapped(task, one, other));
    const judgement = judge(task, answer);
    expect(judgement.passed).toBe(false);
    const found = await findSlip(task, answer, judgement, runOf);
    expect(found?.slip.kind).toBe(kind);
    expect(found?.slip.values.map(({ value }) => value)).toEqual(
      kind === "tools" ? expect.arrayContaining([one, other]) : [other],
    );
    expect(found && withSlip(judgement, found).marks[0]?.slip).toEqual(found?.slip);
  });
});

test("a refused tool that no slip explains is to blame itself", async () => {
  const fault = taskOf("l02-wrong-row");
  const unmended = answerOf("program" in fault.start ? programOfLines(fault.start.program) : "");
  const judgement = judge(fault, unmended);
  expect(await findSlip({ ...fault, solution: undefined }, unmended, judgement, runOf)).toBeNull();
  const alone = { ...fault, solution: undefined };
  expect(withoutSlip(alone, unmended, judgement).marks[0]).toMatchObject({
    issue: { code: "toolUnfit" },
    isByTool: true,
  });
});

test("a tool of the solution is refused for its values, not for itself", () => {
  const family = taskOf("l19-another-size");
  const answer = answerOf(programOfLines(family.solution ?? []).replace(/Q2 =\+35\.4/, "Q2 =+354"));
  const [first] = withoutSlip(family, answer, judge(family, answer)).marks;
  expect(first).toMatchObject({ issue: { code: "diameterOutside" } });
  expect(first?.isByTool).toBeUndefined();
});
