import { feedText } from "../print-words.ts";
import type { Statement, StatementOf } from "../statement.ts";
import type { AxisName, AxisWord, FunctionNumber, Label, Parameter, Value } from "../words.ts";
import { coordinateTexts } from "./coordinates.ts";
import { parameterWord } from "./older-cycles.ts";
import {
  bareValue,
  coordinatesOfAxes,
  ISO_STYLE,
  polarCoordinates,
  saysOnly,
  signedValue,
  tailTexts,
  wordsBlock,
} from "./print-words.ts";
import { FIRST_CYCLE, isoWordFor, type IsoBlockName, type IsoPath } from "./words.ts";

const blockWord = (block: IsoBlockName) => isoWordFor({ kind: "block", block });
const planeWord = (axis: AxisName) => isoWordFor({ kind: "plane", axis });

/** A label after L: its number, its name in quotes, or the parameter that holds it. */
function labelText(label: Label | Parameter): string {
  if (typeof label === "number") return String(label);
  if (typeof label === "object") return bareValue(label);
  return /^QS\d/i.test(label) ? label : `"${label}"`;
}

const CENTRE: Partial<Record<AxisName, string>> = { X: "I", Y: "J", Z: "K" };

function poleText(words: StatementOf<"path">["words"]): string | null {
  if (!saysOnly(words, "axes")) return null;
  if (words.axes.length === 0) return wordsBlock(words, { word: blockWord("polePosition") });
  const coordinates = words.axes.flatMap((w) =>
    CENTRE[w.axis] === undefined ? [] : [{ ...w, name: CENTRE[w.axis] ?? "" }],
  );
  return coordinates.length < words.axes.length ? null : wordsBlock(words, { coordinates });
}

function pathText({ path, words }: StatementOf<"path">): string | null {
  if (path === "CC") return poleText(words);
  const axes = coordinatesOfAxes(words.axes);
  if (path === "RND")
    return words.radius !== undefined && saysOnly(words, "radius")
      ? wordsBlock(words, { word: blockWord("rounding"), more: [`R${bareValue(words.radius)}`] })
      : null;
  const made = (on: IsoPath) => isoWordFor({ kind: "path", path: on, ...(words.turn && { turn: words.turn }) });
  const polar = path === "LP" || path === "CP" || path === "CTP";
  const rapid = (path === "L" || path === "LP") && words.feed === "max";
  switch (path) {
    case "C":
    case "CP":
      if (words.turn === undefined) return null;
      break;
    case "CR":
      if (words.turn === undefined || words.radius === undefined || !saysOnly(words, "axes", "turn", "radius"))
        return null;
      return wordsBlock(words, { word: made("C"), coordinates: axes, more: [`R${signedValue(words.radius)}`] });
    default:
      if (words.turn !== undefined) return null;
  }
  if (!saysOnly(words, "axes", "turn", ...(polar ? (["polarRadius", "polarAngle"] as const) : []))) return null;
  const word = rapid ? isoWordFor({ kind: "path", path, rapid: true }) : made(path);
  return word && wordsBlock(words, { word, coordinates: polar ? [...axes, ...polarCoordinates(words)] : axes, rapid });
}

function toolCallText(s: StatementOf<"toolCall">): string | null {
  const plane = s.axis === null ? "" : planeWord(s.axis);
  if (plane === null || s.extra.length > 0) return null;
  const tool = s.tool === null ? "" : labelText(s.tool);
  return [
    `${blockWord("toolCall")}${tool}`,
    ...(plane === "" ? [] : [plane]),
    ...(s.speed === null ? [] : [`S${bareValue(s.speed)}`]),
    ...(s.feed === null ? [] : [feedText(s.feed, ISO_STYLE)]),
    ...(s.deltaLength === null ? [] : [`DL${signedValue(s.deltaLength)}`]),
    ...(s.deltaRadius === null ? [] : [`DR${signedValue(s.deltaRadius)}`]),
  ].join(" ");
}

const measure = (word: string, value: Value | null) => (value === null ? "" : ` ${word}${signedValue(value)}`);

function blankText(corner: 1 | 2, axis: AxisName | null, axes: readonly AxisWord[]): string | null {
  const plane = axis === null ? "" : planeWord(axis);
  if (plane === null || (corner === 2 && plane !== "")) return null;
  const words = coordinateTexts(coordinatesOfAxes(axes));
  const absolute = axes.every((w) => !w.incremental);
  // As printed: the smallest corner is absolute without a word for it, behind the plane.
  return corner === 2
    ? [blockWord("blankMaximum"), ...words].join(" ")
    : [blockWord("blankMinimum"), ...(plane === "" ? [] : [plane]), ...(absolute ? words.slice(1) : words)].join(" ");
}

/** The words of a cycle with Q parameters, on one line. */
export const parametersText = (s: StatementOf<"cycle">): string =>
  s.parameters
    .map(
      ({ q, value }) =>
        ` ${q}=${value === "max" || value === "auto" ? feedText(value, ISO_STYLE) : value === null ? "" : signedValue(value)}`,
    )
    .join("");

function cycleText(s: StatementOf<"cycle">): string | null {
  const word =
    s.cycle >= FIRST_CYCLE && s.cycle < 1000 ? `G${s.cycle}` : isoWordFor({ kind: "shiftedCycle", cycle: s.cycle });
  return word && word + parametersText(s);
}

/** The operands of an FN function; null unless it is written with two values. */
function operands(fn: FunctionNumber, { formula: f }: StatementOf<"assign">): Value[] | null {
  if (fn === 0) return f.kind === "value" ? [f.value] : null;
  if (f.kind === "call") return f.of.kind === "value" ? [f.of.value] : null;
  return "left" in f && f.left.kind === "value" && f.right.kind === "value" ? [f.left.value, f.right.value] : null;
}

function assignText(s: StatementOf<"assign">): string | null {
  const values = s.fn === null ? null : operands(s.fn, s);
  const word = s.fn === null ? null : isoWordFor({ kind: "function", fn: s.fn });
  return values && word
    ? [word, s.target, ...values.map((v, i) => `${parameterWord(i + 1)} ${signedValue(v)}`)].join(" ")
    : null;
}

/** The comparison of each jump. */
export const JUMPS = { 9: "EQU", 10: "NE", 11: "GT", 12: "LT" } as const;

function jumpText(s: StatementOf<"jump">): string | null {
  if (s.fn === null || s.right === null || JUMPS[s.fn] !== s.compare) return null;
  return `${isoWordFor({ kind: "jump", fn: s.fn })} P01 ${signedValue(s.left)} P02 ${signedValue(s.right)} P03 ${labelText(s.label)}`;
}

/** The text of one Klartext block in DIN/ISO, without number and ` *`; null when there is no word for it. */
export function isoStatement(s: Statement): string | null {
  switch (s.kind) {
    case "blankBox":
      return blankText(s.corner, s.axis, s.axes);
    case "toolDefinition":
      return `${blockWord("toolDefinition")} T${labelText(s.tool)}${measure("L", s.length)}${measure("R", s.radius)}`;
    case "toolCall":
      return toolCallText(s);
    case "path":
      return pathText(s);
    case "chamfer":
      return s.length !== null && saysOnly(s.words)
        ? wordsBlock(s.words, { word: blockWord("chamfer"), more: [`R${bareValue(s.length)}`] })
        : null;
    case "label":
      return `${blockWord("label")} L${labelText(s.label)}`;
    case "call":
      return `${blockWord("call")}${labelText(s.label)},${s.repeat === null ? "0" : bareValue(s.repeat)}`;
    case "cycle":
      return cycleText(s);
    case "cycleCall":
      return s.how === "" && saysOnly(s.words) ? wordsBlock(s.words, { word: blockWord("cycleCall") }) : null;
    case "stop":
      return saysOnly(s.words) ? wordsBlock(s.words, { word: blockWord("stop") }) : null;
    case "functions":
      return s.words.feed === undefined && s.words.compensation === undefined && saysOnly(s.words)
        ? tailTexts(s.words).join(" ")
        : null;
    case "callProgram":
      return `%${typeof s.file === "object" ? s.file.parameter : s.bare ? s.file : `"${s.file}"`}`;
    case "raise":
      return `${blockWord("raise")} P01 ${bareValue(s.error)}`;
    case "assign":
      return assignText(s);
    case "jump":
      return jumpText(s);
    default:
      return null;
  }
}
