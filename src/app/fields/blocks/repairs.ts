import { threadRepairs } from "./thread-repairs.ts";
import { insertion, type Repair } from "./repair.ts";
import { blockRepairs } from "./block-repairs.ts";
import { valueRepairs } from "./value-repairs.ts";
import { withBlock, withInserted } from "../../../nc/edit.ts";
import { klartext } from "../../../nc/blocks/klartext.ts";
import { blockNumbers, startLines, type Program } from "../../../nc/program.ts";
import { withListTildes } from "../../../nc/list-tildes.ts";
import type { Statement } from "../../../nc/statement.ts";
import { noWords } from "../../../nc/words.ts";
import { roundedTo } from "../../../program/values/field.ts";
import { startOfCut, INTENDED_CUT } from "../../../program/state/intended-cuts.ts";
import { placeInSorted } from "../../../program/run/path-index.ts";
import type { NcOutput } from "../../../program/machine/nc-output.ts";
import { outputIn } from "../../../program/edits/output-in.ts";
import { STOPS_SPINDLE } from "../../../program/blocks/spindle-start.ts";
import { POSITION_DECIMALS, positionAsTyped } from "../../../program/values/typed-value.ts";
import { ncLabels } from "../../../i18n/nc-labels.ts";
import { ncLanguageOf, type Language } from "../../../i18n/languages.ts";
import type { FindingEntry } from "../../findings/entry.ts";
import { inProgram } from "./block-prompts.ts";
import { labelRepairs } from "./label-repairs.ts";
import { withContour, withContourNamed } from "./missing-contour.ts";

/** Index of the block that a finding belongs to; -1 when it belongs to none. */
export function indexOf(program: Program, { line, block }: Pick<FindingEntry, "line" | "block">): number {
  if (line !== null) return placeInSorted(startLines(program), line + 1) - 1;
  return block === null ? -1 : blockNumbers(program).indexOf(block);
}

const lastOf = (program: Program, before: number, is: (s: Statement) => boolean): number =>
  program.blocks.slice(0, before).findLastIndex(({ statement }) => is(statement));

/** The tool call that is active at a block; -1 without one. */
export const toolCallBefore = (program: Program, index: number): number =>
  lastOf(program, index, (s) => s.kind === "toolCall" && s.tool !== null);

/** Changes the tool call before a block. */
export function withTool(program: Program, index: number, tool: number): Program {
  const at = toolCallBefore(program, index);
  const s = program.blocks[at]?.statement;
  return s?.kind === "toolCall" ? withBlock(program, at, { ...s, tool }) : program;
}

/** Where FUNCTION MODE TURN belongs: before the tool call, unless milling was chosen after it. */
function placeOfMode(program: Program, index: number): number {
  const tool = toolCallBefore(program, index);
  const mode = lastOf(program, index, (s) => s.kind === "mode");
  return tool > mode ? tool : mode >= 0 ? mode + 1 : placeBehindFrame(program, index);
}

/** After BEGIN PGM, blank and mode, so that the tool call comes before all positioning. */
const placeBehindFrame = (program: Program, index: number): number =>
  lastOf(program, index, (s) => s.kind === "begin" || s.kind === "mode" || klartext.has(s, "blank")) + 1;

/** After a definition and the block that positions to its start point. */
function placeOfCall(program: Program, definition: number): number {
  const next = program.blocks[definition + 1]?.statement;
  return definition + (next?.kind === "path" ? 2 : 1);
}

/** Before the first subprogram after the last call of the main program, or before the program end. */
function placeOfEnd(program: Program): number {
  const { blocks } = program;
  const last = blocks.findLastIndex(({ statement: s }) => s.kind === "cycleCall" || s.kind === "toolCall");
  const label = blocks.findIndex(({ statement: s }, i) => i > last && s.kind === "label");
  const end = blocks.findIndex(({ statement: s }) => s.kind === "end");
  return label >= 0 ? label : end >= 0 ? end : blocks.length;
}

function placeOfLabelEnd(program: Program, label: number): number {
  const { blocks } = program;
  const next = blocks.findIndex(({ statement: s }, i) => i > label && (s.kind === "label" || s.kind === "end"));
  return next >= 0 ? next : blocks.length;
}

/** Cycle 14 with the first label of the program that is a contour. */
function contourLines(program: Program, language: Language): readonly Statement[] {
  const label = program.blocks.find(({ statement: s }) => s.kind === "label" && s.label !== 0)?.statement;
  if (label?.kind !== "label") return [];
  const { title, label: word } = ncLabels(ncLanguageOf(language)).contour;
  const named = typeof label.label === "number" ? String(label.label) : ` "${label.label}"`;
  return [
    { kind: "cycleLine", cycle: 14, line: 0, text: title },
    { kind: "cycleLine", cycle: 14, line: 1, text: `${word}${named}` },
  ];
}

/** Puts R0 into the last block that switched radius compensation on. */
function withoutCompensation(program: Program, index: number): Repair | null {
  const at = lastOf(
    program,
    index + 1,
    (s) =>
      "words" in s && "compensation" in s.words && s.words.compensation !== undefined && s.words.compensation !== "R0",
  );
  const s = program.blocks[at]?.statement;
  if (s?.kind !== "path") return null;
  const next = () => withBlock(program, at, { ...s, words: { ...s.words, compensation: "R0" } });
  return { kind: "write", text: "R0", block: String(blockNumbers(program)[at] ?? ""), next, open: at };
}

/** Removes a parameter that is not part of the definition, or is there twice. */
function withoutParameter(program: Program, index: number, q: string): Repair | null {
  const s = program.blocks[index]?.statement;
  if (s?.kind !== "cycle") return null;
  const at = s.parameters.findLastIndex((p) => p.q === q);
  if (at < 0) return null;
  return {
    kind: "remove",
    text: q,
    block: "",
    open: index,
    next: () => withBlock(program, index, { ...s, parameters: s.parameters.toSpliced(at, 1) }),
  };
}

/** Changes the start point of a call: in its positioning block, or in a new block right before the call. */
function withStart(program: Program, index: number, start: { readonly x: number; readonly z: number }): Repair {
  const [x, z] = [inProgram(program, start.x), inProgram(program, start.z)];
  const axes = [
    { axis: "X", value: roundedTo(x, POSITION_DECIMALS), incremental: false },
    {
      axis: "Z",
      value: roundedTo(z, POSITION_DECIMALS),
      incremental: false,
    },
  ] as const;
  const before = index - 1;
  const s = program.blocks[before]?.statement;
  if (s?.kind !== "path" || s.path !== "L" || s.words.feed !== "max")
    return insertion(program, index, [{ kind: "path", path: "L", words: { ...noWords, axes, feed: "max" } }], index);
  const others = s.words.axes.filter((w) => w.axis !== "X" && w.axis !== "Z");
  const next = () => withBlock(program, before, { ...s, words: { ...s.words, axes: [axes[0], ...others, axes[1]] } });
  return {
    kind: "write",
    text: `X${signed(x)} Z${signed(z)}`,
    block: String(blockNumbers(program)[before] ?? ""),
    next,
    open: before,
  };
}

const signed = (mm: number) => positionAsTyped(mm).replace(/^(?!-)/, "+");

const toolCallOf = (tool: number): Statement => ({
  kind: "toolCall",
  tool,
  axis: null,
  speed: null,
  feed: null,
  deltaLength: null,
  deltaRadius: null,
  extra: [],
});

/** Distance of a proposed start point from the blank, in ⌀ and Z, mm. */
const CLEAR = 2;

/** Inserts a start point outside the blank, with the spindle on, before a call that has none. */
function withKnownStart(program: Program, index: number, spindleOn: number): Repair | null {
  const called = program.blocks[index]?.statement;
  const blank = program.blocks.find(({ statement: s }) => s.kind === "blankCylinder")?.statement;
  if (called?.kind !== "cycleCall" || blank?.kind !== "blankCylinder") return null;
  const { outside, distance } = blank;
  if (
    outside?.measure !== "D" ||
    typeof outside.value !== "number" ||
    (typeof distance === "object" && distance !== null)
  )
    return null;
  const axes = [
    { axis: "X" as const, value: outside.value, incremental: false },
    {
      axis: "Z" as const,
      value: roundedTo(distance ?? 0, POSITION_DECIMALS) + inProgram(program, CLEAR),
      incremental: false,
    },
  ];
  const start: Statement = {
    kind: "path",
    path: "L",
    words: { ...noWords, axes, feed: "max", functions: [spindleOn] },
  };
  return asking([insertion(program, index, [start], index)])[0] ?? null;
}

/** M functions per block that every control accepts. */
const MOST_FUNCTIONS = 2;

/** Starts the spindle in the positioning block of a call, or in a new block right before the call. */
function withSpindleStarted(program: Program, call: number, spindleOn: number): Repair {
  const moves = program.blocks[call]?.statement.kind === "path" ? call : call - 1;
  const block = program.blocks[moves];
  const s = block?.statement;
  const hasRoom =
    s?.kind === "path" &&
    !block?.skip &&
    s.words.functions.length < MOST_FUNCTIONS &&
    !s.words.functions.some((m) => STOPS_SPINDLE.includes(m));
  if (!hasRoom)
    return insertion(program, call, [{ kind: "functions", words: { ...noWords, functions: [spindleOn] } }], call);
  const next = () =>
    withBlock(program, moves, { ...s, words: { ...s.words, functions: [...s.words.functions, spindleOn] } });
  return { kind: "write", text: `M${spindleOn}`, block: String(blockNumbers(program)[moves] ?? ""), next, open: moves };
}

/** Switches to feed per revolution where it was switched off, or after the tool call. */
function withFeedPerRevolution(program: Program, index: number): Repair {
  const [perRevolution, perMinute] = [136, 137];
  const at = lastOf(
    program,
    index,
    (s) => "words" in s && "functions" in s.words && s.words.functions.includes(perMinute),
  );
  const s = program.blocks[at]?.statement;
  if (at > toolCallBefore(program, index) && s && "words" in s && "functions" in s.words) {
    const functions = s.words.functions.map((m) => (m === perMinute ? perRevolution : m));
    const next = () => withBlock(program, at, { ...s, words: { ...s.words, functions } } as Statement);
    return { kind: "write", text: `M${perRevolution}`, block: String(blockNumbers(program)[at] ?? ""), next, open: at };
  }
  let place = Math.max(toolCallBefore(program, index) + 1, placeBehindFrame(program, index));
  while (program.blocks[place]?.statement.kind === "spin") place += 1;
  return insertion(program, place, [{ kind: "functions", words: { ...noWords, functions: [perRevolution] } }], index);
}

/** Changes the length or radius of an approach or departure. */
function withLead(program: Program, index: number, word: "LEN" | "R", mm: number): Repair | null {
  const s = program.blocks[index]?.statement,
    value = inProgram(program, mm);
  if (s?.kind !== "approach") return null;
  const next = () =>
    withBlock(program, index, { ...s, words: { ...s.words, [word === "LEN" ? "length" : "radius"]: value } });
  return {
    kind: "write",
    text: `${word}${value}`,
    block: String(blockNumbers(program)[index] ?? ""),
    next,
    open: index,
  };
}

/** Label of a contour in a program that has no label yet. */
const FIRST_LABEL = 1;

const asking = (repairs: readonly Repair[]): readonly Repair[] => repairs.map((repair) => ({ ...repair, asks: true }));

/** Changes that fix a finding, most certain first; none if only the operator can decide. */
export function repairsOf(
  program: Program,
  entry: FindingEntry,
  language: Language,
  output: NcOutput,
): readonly Repair[] {
  const index = indexOf(program, entry);
  const { issue, at } = entry;
  const insert = (place: number, ...statements: Statement[]) => [insertion(program, place, statements, index)];
  const withSpeed = () =>
    insert(toolCallBefore(program, index) + 1, {
      kind: "spin",
      constantSurface: true,
      cuttingSpeed: 180,
      speed: null,
      limit: 2500,
      gear: null,
    });
  const maybe = (repair: Repair | null) => (repair ? [repair] : []);
  switch (issue.code as string) {
    case "notInTurnMode":
      return insert(placeOfMode(program, index), { kind: "mode", mode: "TURN", kinematics: null });
    case "cycleNeverCalled":
      return insert(placeOfCall(program, index), { kind: "cycleCall", how: "", words: noWords });
    case "spindleMissing":
      return asking(withSpeed());
    case "spindleStopped":
      if ("how" in issue.data && issue.data.how === "noSpeed") return asking(withSpeed());
      if ("how" in issue.data && issue.data.how === "hand") return [];
      return [withSpindleStarted(program, index, outputIn(program, output).spindleOn)];
    case "noToolCalled":
      return asking(insert(placeBehindFrame(program, index), toolCallOf(1)));
    case "startUnknown":
      return maybe(withKnownStart(program, index, outputIn(program, output).spindleOn));
    case "feedUnlikely":
      return "unit" in issue.data && issue.data.unit === "mm/min" ? [withFeedPerRevolution(program, index)] : [];
    case "programEndMissing":
      return insert(placeOfEnd(program), { kind: "functions", words: { ...noWords, functions: [output.end] } });
    case "listWithoutTilde":
      return [{ kind: "tie", text: "~", block: "", open: index, next: () => withListTildes(program) }];
    case "cutBelowContour": {
      const at = startOfCut(program.blocks, index);
      const next = () => withInserted(program, at, { kind: "comment", text: ` ${INTENDED_CUT}` });
      return [{ kind: "meant", text: INTENDED_CUT, block: "", open: index + 1, next }];
    }
    case "blankMissing":
      return asking(
        insert(lastOf(program, program.blocks.length, (s) => s.kind === "begin") + 1, {
          kind: "blankCylinder",
          axis: "Z",
          outside: { measure: "D", value: inProgram(program, 80) },
          length: inProgram(program, 100),
          distance: inProgram(program, 1),
          inside: null,
        }),
      );
    case "labelNotClosed":
      return insert(placeOfLabelEnd(program, index), { kind: "label", label: 0 });
    case "contourNotNamed": {
      const lines = contourLines(program, language);
      const definition = lastOf(program, index + 1, (s) => s.kind === "cycle");
      if (lines.length > 0) return insert(Math.max(definition, 0), ...lines);
      const number = "cycle" in issue.data ? Number(issue.data.cycle) : 0;
      const contour = definition < 0 ? null : withContour(program, number, FIRST_LABEL);
      const next = () => withContourNamed(contour ?? program, definition, FIRST_LABEL, language);
      return contour
        ? [{ kind: "insert", text: `CYCL DEF 14, LBL ${FIRST_LABEL}`, block: "", open: definition, next }]
        : [];
    }
    case "labelMissing": {
      const missing = "label" in issue.data ? String(issue.data.label) : "";
      const before = lastOf(program, index + 1, (s) => s.kind === "cycle");
      const behind = program.blocks.findIndex(({ statement: s }, i) => i > index && s.kind === "cycle");
      const definition = program.blocks[before >= 0 ? before : behind]?.statement;
      const label = /^\d+$/.test(missing) ? Number(missing) : missing;
      const contour =
        definition?.kind === "cycle" && missing !== "" ? withContour(program, definition.cycle, label) : null;
      const made: readonly Repair[] = contour
        ? [{ kind: "insert", text: `LBL ${missing}`, block: "", open: index, next: () => contour }]
        : [];
      return [...labelRepairs(program, missing), ...made];
    }
    case "compensationActive":
      return maybe(withoutCompensation(program, index));
    case "parameterForeign": {
      const q = at ?? ("name" in issue.data ? String(issue.data.name) : null);
      return q === null ? [] : maybe(withoutParameter(program, index, q));
    }
  }
  if (issue.code === "betterTool") {
    const { tool } = issue.data;
    if (toolCallBefore(program, index) < 0) {
      return insert(placeBehindFrame(program, index), toolCallOf(tool));
    }
  }
  if (issue.code === "threadOverruns") return threadRepairs(program, index, issue);
  if (issue.code === "startOnWrongSide") return [withStart(program, index, issue.data)];
  if (issue.code === "approachValueCutsContour")
    return maybe(withLead(program, index, issue.data.word, issue.data.nearest));
  return [...blockRepairs(program, entry, index), ...valueRepairs(entry, program, index)];
}
