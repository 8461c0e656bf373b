import { isKept, keptLabels } from "../../../cycles/kept-cycles.ts";
import { GROOVE_WORDS } from "../../../kernel/contour/groove.ts";
import { UNDERCUT_FORMS, UNDERCUT_WORDS } from "../../../kernel/contour/undercut.ts";
import { parse } from "../../../nc/parse.ts";
import { statementLines } from "../../../nc/print.ts";
import {
  APPROACH_FORMS,
  type AxisName,
  type FileName,
  type OutlineSource,
  type PathKind,
  type Statement,
} from "../../../nc/statement.ts";
import { LAYOUTS } from "../../../nc/style.ts";
import { NUMBER_PARAMETER, parameterOf } from "../../../nc/value.ts";
import { feedWord } from "../../../program/values/field.ts";
import { formOf, formWord } from "../../../program/blocks/recess-words.ts";
import {
  blockValue,
  feedAsTyped,
  parameterAsTyped,
  typedFeed,
  valueAsTyped,
} from "../../../program/values/typed-value.ts";
import { fieldOf, optionalValue, labelAsTyped, singleLine, shownLabel, type WordField } from "./field.ts";
import {
  axisFields,
  compensationField,
  feedField,
  freeFields,
  functionsField,
  listedAxis,
  namedFields,
  polarWord,
  retractField,
  turnField,
  valueWord,
} from "./word-fields.ts";

const AXES = ["X", "Y", "Z"] as const satisfies readonly AxisName[];
const TARGET = new RegExp(String.raw`^\s*${NUMBER_PARAMETER}\s*$`, "i");
/** A tool with its index, as in 5.1, or in a parameter; anything else is a number or a name. */
const TOOL_VALUE = new RegExp(String.raw`^\s*(?:\d{1,9}\.\d\s*$|${NUMBER_PARAMETER})`, "i");
/** What a parameter of a cycle that is kept is called where the program does not say it. */
const labelOf = (cycle: number, q: string): string => (isKept(cycle) ? (keptLabels(cycle).get(q) ?? "") : "");
const isAxis = (typed: string): typed is AxisName => /^[XYZABCUVW]$/.test(typed);
const tail = [compensationField, feedField, functionsField];
const polar = [polarWord("polarRadius", "polarRadius", "mm"), polarWord("polarAngle", "polarAngle", "°")];
const radius = valueWord("radius", "radius");

/** The first statement that a text means; null where it is not of this kind. */
export const statementOf = <K extends Statement["kind"]>(
  text: string,
  kind: K,
): Extract<Statement, { kind: K }> | null => {
  const blocks = parse(text).blocks;
  const s = blocks[0]?.statement;
  return blocks.length === 1 && s?.kind === kind ? (s as Extract<Statement, { kind: K }>) : null;
};

/** A statement as one line of text, without number. */
export const statementLine = (s: Statement): string => statementLines(s, LAYOUTS.tnc7)[0] ?? "";

/** The whole statement as text, for what has no words of its own. */
const wholeText: WordField = {
  id: "text",
  name: "text",
  wide: true,
  read: (s) => (s.kind === "unknown" ? s.text : statementLine(s)),
  write: (_, typed) => {
    const blocks = parse(typed).blocks;
    return blocks.length === 1 ? (blocks[0]?.statement ?? null) : null;
  },
};

const paths: Readonly<Record<PathKind, (s: Statement) => readonly WordField[]>> = {
  L: (s) => [
    ...axisFields(s, AXES),
    ...tail,
    ...(s.kind === "path" && s.words.retract !== undefined ? [retractField] : []),
  ],
  LP: (s) => [...polar, ...axisFields(s, []), ...tail],
  C: (s) => [...axisFields(s, AXES), turnField, ...tail],
  CP: (s) => [polar[1] as WordField, ...axisFields(s, []), turnField, ...tail],
  CR: (s) => [...axisFields(s, AXES), radius, turnField, ...tail],
  CT: (s) => [...axisFields(s, AXES), ...tail],
  CTP: (s) => [...polar, ...axisFields(s, []), ...tail],
  CC: (s) => axisFields(s, AXES),
  RND: () => [radius, feedField],
};

const frame = (kind: "begin" | "end"): readonly WordField[] => [
  fieldOf(
    kind,
    "name",
    (s) => s.name,
    (s, typed) => (/^\S{1,60}$/.test(typed.trim()) ? { ...s, name: typed.trim() } : null),
  ),
  fieldOf(
    kind,
    "unit",
    (s) => s.unit,
    (s, typed) => ({ ...s, unit: typed === "INCH" ? "INCH" : "MM" }),
    { choices: ["MM", "INCH"] },
  ),
];

/** A corner of a box names three coordinates. */
const cornerField = (axis: AxisName): WordField =>
  listedAxis(
    axis,
    (s) => (s.kind === "blankBox" ? s.axes : null),
    (s, axes) => (s.kind === "blankBox" ? { ...s, axes } : s),
  );
const shiftField = (axis: AxisName): WordField =>
  listedAxis(
    axis,
    (s) => (s.kind === "datum" && s.shift !== "reset" ? s.shift : null),
    (s, shift) => (s.kind === "datum" ? { ...s, shift } : s),
  );

const lineWords = [valueWord("length", "lineLength"), ...tail];
const arcWords = [
  radius,
  turnField,
  valueWord("length", "lineLength"),
  valueWord("centreAngle", "centreAngle", "°"),
  ...tail,
];
const present = (s: Statement) => polar.filter((field) => field.read(s) !== "");

/** What can be given of the forms of a free contour. */
function freeForm(s: Extract<Statement, { kind: "free" }>): readonly WordField[] {
  switch (s.form) {
    case "FSELECT":
      return [wholeText];
    case "FPOL":
      return axisFields(s, AXES);
    case "FL":
    case "FLT":
      return [...axisFields(s, AXES), ...present(s), ...freeFields(s, ["AN"]), ...lineWords];
    case "FC":
    case "FCT":
      return [...axisFields(s, AXES), ...present(s), ...freeFields(s, ["CCX", "CCY"]), ...arcWords];
  }
}

const undercutWords = (word: string): readonly string[] => {
  const form = formOf(word);
  return form ? UNDERCUT_WORDS[form] : [];
};

/** Where the outline of a blank stands, as its fields show it. */
const sourceOf = (from: OutlineSource) => ("file" in from ? "file" : "label");
const labelIn = (from: OutlineSource) => ("label" in from ? shownLabel(from.label) : "");
const fileIn = (from: OutlineSource) =>
  "label" in from ? "" : typeof from.file === "object" ? from.file.parameter : from.file;
const outlineFrom = (source: string): OutlineSource => (source === "file" ? { file: "BLANK.H" } : { label: 1 });
const fileAsTyped = (typed: string): FileName | null => {
  if (typed === "" || /["\r\n]/.test(typed)) return null;
  const held = parameterOf(typed);
  return held?.parameter.startsWith("QS") ? held : typed;
};

type Table = { readonly [K in Statement["kind"]]: (s: Extract<Statement, { kind: K }>) => readonly WordField[] };

/** The fields of every kind of block: the one description that all their dialogs are made from. */
const table: Table = {
  empty: () => [],
  comment: () => [
    fieldOf(
      "comment",
      "text",
      (s) => s.text,
      (s, typed) => {
        const text = singleLine(typed);
        return text === null ? null : { ...s, text };
      },
      { wide: true },
    ),
  ],
  structure: () => [
    fieldOf(
      "structure",
      "text",
      (s) => s.text,
      (s, typed) => {
        const text = singleLine(typed);
        return text === null ? null : { ...s, text: text.trimStart() };
      },
      { wide: true },
    ),
  ],
  begin: () => frame("begin"),
  end: () => frame("end"),
  blankBox: (s) => [
    ...(s.corner === 1
      ? [
          fieldOf(
            "blankBox",
            "toolAxis",
            (b) => b.axis ?? "",
            (b, typed) => ({ ...b, axis: isAxis(typed) ? typed : null }),
            { choices: ["X", "Y", "Z"] },
          ),
        ]
      : []),
    ...AXES.map(cornerField),
  ],
  blankCylinder: () => [
    fieldOf(
      "blankCylinder",
      "toolAxis",
      (s) => s.axis,
      (s, typed) => (isAxis(typed) ? { ...s, axis: typed } : null),
      {
        choices: ["X", "Y", "Z"],
      },
    ),
    fieldOf(
      "blankCylinder",
      "outside",
      (s) => valueAsTyped(s.outside?.value),
      (s, typed) =>
        optionalValue(typed, (value) => ({
          ...s,
          outside: value === null ? null : { measure: s.outside?.measure ?? "D", value },
        })),
      {
        numeric: true,
        unit: "mm",
      },
    ),
    fieldOf(
      "blankCylinder",
      "outsideMeasure",
      (s) => s.outside?.measure ?? "D",
      (s, typed) => (s.outside ? { ...s, outside: { ...s.outside, measure: typed === "R" ? "R" : "D" } } : s),
      { choices: ["D", "R"] },
    ),
    fieldOf(
      "blankCylinder",
      "length",
      (s) => valueAsTyped(s.length),
      (s, typed) => optionalValue(typed, (length) => ({ ...s, length })),
      {
        numeric: true,
        unit: "mm",
      },
    ),
    fieldOf(
      "blankCylinder",
      "distance",
      (s) => valueAsTyped(s.distance),
      (s, typed) => optionalValue(typed, (distance) => ({ ...s, distance })),
      { numeric: true, unit: "mm" },
    ),
    fieldOf(
      "blankCylinder",
      "inside",
      (s) => valueAsTyped(s.inside?.value),
      (s, typed) =>
        optionalValue(typed, (value) => ({
          ...s,
          inside: value === null ? null : { measure: s.inside?.measure ?? "DI", value },
        })),
      {
        numeric: true,
        unit: "mm",
      },
    ),
    fieldOf(
      "blankCylinder",
      "insideMeasure",
      (s) => (s.inside?.measure === "RI" ? "R" : "D"),
      (s, typed) => (s.inside ? { ...s, inside: { ...s.inside, measure: typed === "R" ? "RI" : "DI" } } : s),
      { choices: ["D", "R"] },
    ),
  ],
  blankRotation: () => [
    fieldOf(
      "blankRotation",
      "toolAxis",
      (s) => s.axis,
      (s, typed) => (isAxis(typed) ? { ...s, axis: typed } : null),
      {
        choices: ["X", "Y", "Z"],
      },
    ),
    fieldOf(
      "blankRotation",
      "measure",
      (s) => s.measure,
      (s, typed) => ({ ...s, measure: typed === "R" ? "R" : "D" }),
      {
        choices: ["D", "R"],
      },
    ),
    fieldOf(
      "blankRotation",
      "blankSource",
      (s) => sourceOf(s.outline),
      (s, typed) => (sourceOf(s.outline) === typed ? s : { ...s, outline: outlineFrom(typed) }),
      { choices: ["label", "file"] },
    ),
    fieldOf(
      "blankRotation",
      "label",
      (s) => labelIn(s.outline),
      (s, typed) => {
        const label = labelAsTyped(typed);
        return label === null ? null : { ...s, outline: { label } };
      },
    ),
    fieldOf(
      "blankRotation",
      "file",
      (s) => fileIn(s.outline),
      (s, typed) => {
        const file = fileAsTyped(typed);
        return file === null ? null : { ...s, outline: { file } };
      },
    ),
  ],
  blankFile: () => [wholeText],
  toolDefinition: () => [
    fieldOf(
      "toolDefinition",
      "tool",
      (s) => shownLabel(s.tool),
      (s, typed) => {
        const tool = labelAsTyped(typed);
        return tool === null ? null : { ...s, tool };
      },
    ),
    fieldOf(
      "toolDefinition",
      "length",
      (s) => valueAsTyped(s.length),
      (s, typed) => optionalValue(typed, (length) => ({ ...s, length })),
      {
        numeric: true,
        unit: "mm",
      },
    ),
    fieldOf(
      "toolDefinition",
      "toolRadius",
      (s) => valueAsTyped(s.radius),
      (s, typed) => optionalValue(typed, (r) => ({ ...s, radius: r })),
      { numeric: true, unit: "mm" },
    ),
  ],
  toolCall: () => [
    fieldOf(
      "toolCall",
      "tool",
      (s) => (s.tool === null ? "" : shownLabel(s.tool)),
      (s, typed) => {
        if (typed.trim() === "") return { ...s, tool: null };
        const value = TOOL_VALUE.test(typed) ? blockValue(typed) : labelAsTyped(typed);
        return value === null ? null : { ...s, tool: value };
      },
    ),
    fieldOf(
      "toolCall",
      "toolAxis",
      (s) => s.axis ?? "",
      (s, typed) => ({ ...s, axis: isAxis(typed) ? typed : null }),
      {
        choices: ["", "X", "Y", "Z"],
      },
    ),
    fieldOf(
      "toolCall",
      "speed",
      (s) => valueAsTyped(s.speed),
      (s, typed) => optionalValue(typed, (speed) => ({ ...s, speed })),
      {
        numeric: true,
      },
    ),
    fieldOf(
      "toolCall",
      "feed",
      (s) => feedAsTyped(s.feed),
      (s, typed) => {
        const feed = typedFeed(typed);
        return feed === undefined ? null : { ...s, feed };
      },
    ),
    fieldOf(
      "toolCall",
      "deltaLength",
      (s) => valueAsTyped(s.deltaLength),
      (s, typed) => optionalValue(typed, (deltaLength) => ({ ...s, deltaLength })),
      { numeric: true, unit: "mm" },
    ),
    fieldOf(
      "toolCall",
      "deltaRadius",
      (s) => valueAsTyped(s.deltaRadius),
      (s, typed) => optionalValue(typed, (deltaRadius) => ({ ...s, deltaRadius })),
      { numeric: true, unit: "mm" },
    ),
  ],
  mode: () => [
    fieldOf(
      "mode",
      "mode",
      (s) => s.mode,
      (s, typed) => ({ ...s, mode: typed === "MILL" ? "MILL" : "TURN" }),
      {
        choices: ["TURN", "MILL"],
      },
    ),
    fieldOf(
      "mode",
      "kinematics",
      (s) => s.kinematics ?? "",
      (s, typed) => (/["\r\n]/.test(typed) ? null : { ...s, kinematics: typed === "" ? null : typed }),
    ),
  ],
  spin: () => [
    fieldOf(
      "spin",
      "constantSurface",
      (s) => (s.constantSurface ? "on" : "off"),
      (s, typed) => ({ ...s, constantSurface: typed === "on" }),
      { choices: ["on", "off"] },
    ),
    fieldOf(
      "spin",
      "cuttingSpeed",
      (s) => valueAsTyped(s.cuttingSpeed),
      (s, typed) => optionalValue(typed, (cuttingSpeed) => ({ ...s, cuttingSpeed })),
      { numeric: true, unit: "m/min" },
    ),
    fieldOf(
      "spin",
      "speed",
      (s) => valueAsTyped(s.speed),
      (s, typed) => optionalValue(typed, (speed) => ({ ...s, speed })),
      {
        numeric: true,
      },
    ),
    fieldOf(
      "spin",
      "speedLimit",
      (s) => valueAsTyped(s.limit),
      (s, typed) => optionalValue(typed, (limit) => ({ ...s, limit })),
      {
        numeric: true,
      },
    ),
  ],
  turnCorrection: (s) => [
    fieldOf(
      "turnCorrection",
      "system",
      (c) => c.system,
      (c, typed) => ({ ...c, system: typed === "WPL" ? "WPL" : "TCS" }),
      {
        choices: ["TCS", "WPL"],
      },
    ),
    fieldOf(
      "turnCorrection",
      "plane",
      (c) => c.plane,
      (c, typed) => (/^[A-Z](\/[A-Z])?$/i.test(typed.trim()) ? { ...c, plane: typed.trim().toUpperCase() } : null),
    ),
    ...namedFields(s, ["DZL", "DXL"]),
  ],
  turnBlank: () => [
    fieldOf(
      "turnBlank",
      "blankSource",
      (s) => (s.blank === "off" ? "off" : sourceOf(s.blank)),
      (s, typed) => {
        const from = s.blank === "off" ? "off" : sourceOf(s.blank);
        return from === typed ? s : { ...s, blank: typed === "off" ? "off" : outlineFrom(typed) };
      },
      { choices: ["off", "label", "file"] },
    ),
    fieldOf(
      "turnBlank",
      "label",
      (s) => (s.blank === "off" ? "" : labelIn(s.blank)),
      (s, typed) => {
        const label = labelAsTyped(typed);
        return label === null ? null : { ...s, blank: { label } };
      },
    ),
    fieldOf(
      "turnBlank",
      "file",
      (s) => (s.blank === "off" ? "" : fileIn(s.blank)),
      (s, typed) => {
        const file = fileAsTyped(typed);
        return file === null ? null : { ...s, blank: { file } };
      },
    ),
  ],
  path: (s) => paths[s.path](s),
  chamfer: () => [
    fieldOf(
      "chamfer",
      "chamfer",
      (s) => valueAsTyped(s.length),
      (s, typed) => optionalValue(typed, (length) => ({ ...s, length })),
      {
        numeric: true,
        unit: "mm",
      },
    ),
    feedField,
  ],
  approach: (s) => [
    fieldOf(
      "approach",
      "form",
      (a) => a.form,
      (a, typed) => {
        const form = APPROACH_FORMS.find((f) => f === typed);
        return form ? { ...a, form } : null;
      },
      { choices: APPROACH_FORMS },
    ),
    ...(s.form.startsWith("P") ? polar : axisFields(s, AXES)),
    valueWord("length", "lineLength"),
    valueWord("centreAngle", "centreAngle", "°"),
    radius,
    ...tail,
  ],
  undercut: (s) => [
    fieldOf(
      "undercut",
      "form",
      (u) => u.form,
      (u, typed) => ({ ...u, form: typed }),
      { choices: UNDERCUT_FORMS.map(formWord) },
    ),
    ...namedFields(s, undercutWords(s.form)),
  ],
  groove: (s) => [
    fieldOf(
      "groove",
      "form",
      (g) => g.form,
      (g, typed) => ({ ...g, form: typed === "AXIAL" ? "AXIAL" : "RADIAL" }),
      {
        choices: ["RADIAL", "AXIAL"],
      },
    ),
    ...namedFields(s, GROOVE_WORDS),
  ],
  label: () => [
    fieldOf(
      "label",
      "label",
      (s) => shownLabel(s.label),
      (s, typed) => {
        const label = labelAsTyped(typed);
        return label === null ? null : { ...s, label };
      },
    ),
  ],
  call: () => [
    fieldOf(
      "call",
      "label",
      (s) => shownLabel(s.label),
      (s, typed) => {
        const label = labelAsTyped(typed);
        return label === null ? null : { ...s, label };
      },
    ),
    fieldOf(
      "call",
      "repeat",
      (s) => valueAsTyped(s.repeat),
      (s, typed) => optionalValue(typed, (repeat) => ({ ...s, repeat })),
      {
        numeric: true,
      },
    ),
  ],
  cycleLine: () => [
    fieldOf(
      "cycleLine",
      "cycleLine",
      (s) => s.text,
      (s, typed) => {
        const text = singleLine(typed);
        return text === null ? null : { ...s, text };
      },
      { wide: true },
    ),
  ],
  cycle: (s) =>
    s.parameters.map((p) =>
      fieldOf(
        "cycle",
        { word: `${p.q} ${(p.label ?? labelOf(s.cycle, p.q)).trim()}`.trim() },
        (c) => parameterAsTyped(c.parameters.find((each) => each.q === p.q)?.value),
        (c, typed) => {
          const value = feedWord(typed) ?? blockValue(typed);
          return value === null
            ? null
            : { ...c, parameters: c.parameters.map((each) => (each.q === p.q ? { ...each, value } : each)) };
        },
        { id: p.q, numeric: true },
      ),
    ),
  cycleCall: () => [
    fieldOf(
      "cycleCall",
      "how",
      (s) => (s.how === "" ? "here" : s.how),
      (s, typed) => ({ ...s, how: typed === "POS" || typed === "PAT" ? typed : "" }),
      { choices: ["here", "POS", "PAT"] },
    ),
    feedField,
    functionsField,
  ],
  selectContour: () => [
    fieldOf(
      "selectContour",
      "file",
      (s) => (typeof s.file === "object" ? s.file.parameter : s.file),
      (s, typed) => (/["\r\n]/.test(typed) ? null : { ...s, file: parameterOf(typed.trim()) ?? typed }),
      { wide: true },
    ),
  ],
  contourDefinition: () => [wholeText],
  declareContour: () => [wholeText],
  contourFormula: () => [wholeText],
  raise: () => [wholeText],
  callProgram: () => [wholeText],
  selectProgram: () => [wholeText],
  callSelected: () => [],
  jump: () => [wholeText],
  datum: (s) => (s.shift === "reset" ? [wholeText] : AXES.map(shiftField)),
  datumTable: () => [wholeText],
  mirror: () => [wholeText],
  rotation: (s) =>
    s.angle === "reset"
      ? [wholeText]
      : [
          fieldOf(
            "rotation",
            { word: "ROT" },
            (r) => (r.angle === "reset" ? "" : valueAsTyped(r.angle.value)),
            (r, typed) => {
              const value = blockValue(typed);
              return value === null || r.angle === "reset" ? null : { ...r, angle: { ...r.angle, value } };
            },
            { numeric: true, unit: "°" },
          ),
        ],
  scale: (s) =>
    s.factor === "reset"
      ? [wholeText]
      : [
          fieldOf(
            "scale",
            { word: "SCL" },
            (f) => (f.factor === "reset" ? "" : valueAsTyped(f.factor)),
            (f, typed) => {
              const factor = blockValue(typed);
              return factor === null ? null : { ...f, factor };
            },
            { numeric: true },
          ),
        ],
  plane: () => [wholeText],
  free: freeForm,
  assign: (s) => [
    fieldOf(
      "assign",
      "target",
      (a) => a.target,
      (a, typed) => (TARGET.test(typed) ? { ...a, target: typed.trim().toUpperCase() } : null),
    ),
    fieldOf(
      "assign",
      "formula",
      (a) => statementLine(a).replace(/^.*?=\s*/, ""),
      (a, typed) => statementOf(`${s.fn === null ? "" : `FN ${s.fn}: `}${a.target} = ${typed}`, "assign"),
      { wide: true },
    ),
  ],
  assignText: () => [wholeText],
  functions: () => [functionsField],
  stop: () => [functionsField],
  unknown: () => [wholeText],
};

/** The fields of a block's dialog, in the order of its words. */
export const fieldsOf = (s: Statement): readonly WordField[] =>
  (table[s.kind] as (of: Statement) => readonly WordField[])(s);
