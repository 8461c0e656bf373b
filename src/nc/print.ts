import { valueText } from "./number-text.ts";
import { assignmentText, textAssignmentText } from "./print-formula.ts";
import { feedText, unsigned, wordsText } from "./print-words.ts";
import type {
  ContourArea,
  CycleParameter,
  FileName,
  Label,
  NamedWord,
  OutlineSource,
  Statement,
  StatementOf,
  Value,
} from "./statement.ts";
import type { Style } from "./style.ts";

const labelText = (label: Label) =>
  typeof label === "number" ? String(label) : /^QS\d/i.test(label) ? label : `"${label}"`;
const optional = (word: string, value: Value | null, style: Style) =>
  value === null ? "" : ` ${word}${valueText(value, style)}`;
const bare = (word: string, value: Value | null, style: Style) =>
  value === null ? "" : ` ${word}${unsigned(value, style)}`;

/** R of APPR CT and DEP CT and LEN of the LN forms carry a sign; the others are bare. */
const signsOf = (form: string) => ({ length: form.endsWith("LN"), radius: form === "CT" || form === "PCT" });

/** A value of a cycle as it is written; nothing for one that is not set. */
export function parameterValueText(value: CycleParameter["value"], style: Style): string {
  if (value === null) return "";
  if (value === "auto") return "FAUTO";
  return value === "max" ? "FMAX" : valueText(value, style);
}

const parameterText = (p: CycleParameter, style: Style) =>
  `${style.indent}${p.q}=${parameterValueText(p.value, style)}${p.label === null ? "" : ` ;${p.label}`}`;

const namedText = (words: readonly NamedWord[], style: Style, colon = "") =>
  words.map((w) => ` ${w.name}${colon}${unsigned(w.value, style)}`).join("");

const outlineText = (from: OutlineSource) =>
  "file" in from ? fileText(from.file, false) : `LBL ${labelText(from.label)}`;
const fileText = (file: FileName, isBare: boolean) =>
  typeof file === "object" ? file.parameter : isBare ? file : `"${file}"`;

function areaText({ from, depth }: Pick<ContourArea, "from" | "depth">, style: Style): string {
  const of =
    "file" in from
      ? fileText(from.file, false)
      : `LBL ${typeof from.label === "object" ? from.label.parameter : labelText(from.label)}`;
  return `${of}${depth === null ? "" : ` DEPTH${unsigned(depth, style)}`}`;
}

/** What only free contours have stands between the end point and the feed; a control reads any order. */
const freeText = (s: StatementOf<"free">, style: Style) =>
  `${s.form}${wordsText(s.words, style)}${s.given.map((w) => ` ${w.name}${givenText(w, style)}`).join("")}`;
/** Blocks that are referred to are bare numbers, and CLSD has a sign alone. */
function givenText({ name, value }: NamedWord, style: Style): string {
  if (name === "CLSD") return value === -1 ? "-" : "+";
  return /^(?:PAR|RCC?.*|RPR|RPA|RAN|R[XYZ])$/.test(name) ? unsigned(value, style) : valueText(value, style);
}

/** The lines of a statement without block number and line ends; only cycles have more than one. */
export function statementLines(s: Statement, style: Style): string[] {
  if (s.kind !== "cycle") return [statementText(s, style)];
  const lines = [
    `CYCL DEF ${s.cycle}${s.name === "" ? "" : `${style.wide ? "  " : " "}${s.name}`}`,
    ...s.parameters.map((p) => parameterText(p, style)),
  ];
  return style.continued ? lines.map((line, i) => (i < lines.length - 1 ? `${line} ~` : line)) : lines;
}

function statementText(s: Exclude<Statement, { kind: "cycle" }>, style: Style): string {
  const two = style.wide ? "  " : " ";
  switch (s.kind) {
    case "empty":
      return "";
    case "comment":
      return `;${s.text}`;
    case "structure":
      return `* - ${s.text}`;
    case "begin":
      return `BEGIN PGM ${s.name} ${s.unit}`;
    case "end":
      return `END PGM ${s.name} ${s.unit}`;
    case "blankBox": {
      const axes = s.axes.map((w) => ` ${w.incremental ? "I" : ""}${w.axis}${valueText(w.value, style)}`).join("");
      return `BLK FORM 0.${s.corner}${s.axis ? ` ${s.axis}` : ""}${axes}`;
    }
    case "blankCylinder":
      return (
        `BLK FORM CYLINDER ${s.axis}${s.outside ? bare(s.outside.measure, s.outside.value, style) : ""}${bare("L", s.length, style)}` +
        `${optional("DIST", s.distance, style)}${s.inside ? bare(s.inside.measure, s.inside.value, style) : ""}`
      );
    case "blankRotation":
      return (
        `BLK FORM ROTATION ${s.axis} DIM_${s.measure} ${outlineText(s.outline)}` +
        (s.inner === null ? "" : ` LBLIN ${labelText(s.inner)}`)
      );
    case "blankFile":
      return `BLK FORM FILE "${s.file}"${s.target === null ? "" : ` TARGET "${s.target}"`}`;
    case "toolDefinition":
      return `TOOL DEF ${labelText(s.tool)}${optional("L", s.length, style)}${optional("R", s.radius, style)}`;
    case "toolCall": {
      const tool =
        s.tool === null ? "" : ` ${typeof s.tool === "object" ? unsigned(s.tool, style) : labelText(s.tool)}`;
      const feed = s.feed === null ? "" : ` ${feedText(s.feed, style)}`;
      const extra = s.extra.map((word) => ` ${word}`).join("");
      return (
        `TOOL CALL${tool}${s.axis ? ` ${s.axis}` : ""}${bare("S", s.speed, style)}${feed}` +
        `${optional("DL", s.deltaLength, style)}${optional("DR", s.deltaRadius, style)}${extra}`
      );
    }
    case "mode":
      return `FUNCTION MODE ${s.mode}${s.kinematics === null ? "" : ` "${s.kinematics}"`}`;
    case "spin":
      return (
        `FUNCTION TURNDATA SPIN VCONST:${s.constantSurface ? "ON" : "OFF"}${bare("VC:", s.cuttingSpeed, style)}` +
        `${bare("S", s.speed, style)}${bare("SMAX", s.limit, style)}${bare("GEARRANGE:", s.gear ?? null, style)}`
      );
    case "turnCorrection":
      return `FUNCTION TURNDATA CORR-${s.system}:${s.plane}${namedText(s.words, style, ":")}`;
    case "turnBlank":
      return `FUNCTION TURNDATA BLANK ${s.blank === "off" ? "OFF" : outlineText(s.blank)}`;
    case "path":
      return `${s.path}${wordsText(s.words, style, { length: true, radius: s.path !== "RND" })}`;
    case "chamfer":
      return `CHF${s.length === null ? "" : two + unsigned(s.length, style)}${wordsText(s.words, style)}`;
    case "approach":
      return `${s.departing ? "DEP" : "APPR"} ${s.form}${wordsText(s.words, { ...style, wide: false }, signsOf(s.form))}`;
    case "free":
      return s.form === "FSELECT" ? `FSELECT ${unsigned(s.given[0]?.value ?? 1, style)}` : freeText(s, style);
    case "undercut":
      return `UDC ${s.form}${namedText(s.words, style)}`;
    case "groove":
      return `GRV ${s.form}${namedText(s.words, style)}`;
    case "label":
      return `LBL${s.label === 0 ? " " : two}${labelText(s.label)}`;
    case "call": {
      const target = typeof s.label === "object" ? unsigned(s.label, style) : labelText(s.label);
      return `CALL LBL ${target}${s.repeat === null ? "" : ` REP ${unsigned(s.repeat, style)}`}`;
    }
    case "cycleLine":
      return `CYCL DEF ${s.cycle}.${s.line}${s.text === "" ? "" : two + s.text}`;
    case "cycleCall":
      return `CYCL CALL${s.how === "" ? "" : ` ${s.how}`}${wordsText(s.words, { ...style, wide: false })}`;
    case "selectContour":
      return `SEL CONTOUR ${fileText(s.file, false)}`;
    case "contourDefinition":
      return `CONTOUR DEF${s.areas.map((a) => ` ${a.role}${a.number} = ${areaText(a, style)}`).join("")}`;
    case "declareContour":
      return `DECLARE CONTOUR ${s.contour} = ${areaText(s, style)}`;
    case "contourFormula":
      return `${s.target} = ${s.terms.join(" ")}`;
    case "raise":
      return `FN 14: ERROR=${unsigned(s.error, style)}`;
    case "callProgram":
    case "selectProgram":
      return `${s.kind === "callProgram" ? "CALL" : "SEL"} PGM ${fileText(s.file, s.bare)}`;
    case "callSelected":
      return "CALL SELECTED PGM";
    case "assignText":
      return textAssignmentText(s, style);
    case "assign":
      return assignmentText(s, style);
    case "jump": {
      const signed = (value: Value) => valueText(value, { ...style, plus: true });
      const target = typeof s.label === "object" ? unsigned(s.label, style) : labelText(s.label);
      return (
        `${s.fn === null ? "" : `FN ${s.fn}: `}IF ${signed(s.left)} ${s.compare}` +
        `${s.right === null ? "" : ` ${signed(s.right)}`} GOTO LBL ${target}`
      );
    }
    case "datum":
      return (
        "TRANS DATUM " +
        (s.shift === "reset"
          ? "RESET"
          : `AXIS${s.shift.map((w) => ` ${w.incremental ? "I" : ""}${w.axis}${valueText(w.value, style)}`).join("")}`)
      );
    case "datumTable":
      return `TRANS DATUM TABLE${s.row === "" ? "" : ` ${s.row}`}`;
    case "mirror":
      return `TRANS MIRROR ${s.axes === "reset" ? "RESET" : `AXIS ${s.axes.join(" ")}`}`;
    case "rotation":
      return (
        "TRANS ROTATION " +
        (s.angle === "reset" ? "RESET" : `${s.angle.incremental ? "I" : ""}ROT${valueText(s.angle.value, style)}`)
      );
    case "scale":
      return `TRANS SCALE ${s.factor === "reset" ? "RESET" : `SCL${unsigned(s.factor, style)}`}`;
    case "functions":
      return wordsText(s.words, style).trimStart();
    case "stop":
      return `STOP${wordsText(s.words, { ...style, wide: false })}`;
    case "plane":
    case "unknown":
      return s.text;
  }
}

/** What stands in front of a statement: number and skip mark. The TNC 640 sets two blanks before the older cycles. */
export function headText(number: number | null, skip: boolean, s: Statement, style: Style): string {
  const mark = skip ? "/" : "";
  return number === null ? mark : `${mark}${number}${style.wide && s.kind === "cycleLine" ? "  " : " "}`;
}

/** A block with number and line end. */
export function blockText(
  number: number | null,
  s: Statement,
  style: Style,
  more: { readonly skip?: boolean; readonly comment?: string | null } = {},
): string {
  const lines = statementLines(s, style);
  const comment = more.comment === undefined || more.comment === null ? "" : ` ;${more.comment}`;
  return (
    headText(number, more.skip ?? false, s, style) +
    lines.map((line, i) => line + (i === 0 ? comment : "") + style.newLine).join("")
  );
}

/** A program of statements, numbered from 0, or without numbers. Blank lines carry no number. */
export function programText(statements: readonly Statement[], style: Style, numbered = true): string {
  let next = 0;
  return statements.map((s) => blockText(numbered && s.kind !== "empty" ? next++ : null, s, style)).join("");
}
