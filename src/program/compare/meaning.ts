import type { Block } from "../../nc/program.ts";
import { valueText } from "../../nc/number-text.ts";
import { parameterValueText, statementLines } from "../../nc/print.ts";
import { feedText } from "../../nc/print-words.ts";
import type {
  AxisWord,
  Label,
  NamedWord,
  Parameter,
  PolarWord,
  Statement,
  StatementOf,
  Value,
  Words,
} from "../../nc/statement.ts";
import { LAYOUTS, type Style } from "../../nc/style.ts";
import { CONTOUR_CYCLE, contourLabels } from "../state/contour-names.ts";
import { PROGRAM_CYCLE } from "../blocks/program-calls.ts";

/** What a block says, apart from how it is written. */
export interface Meaning {
  /** What it is: only blocks of one kind are ever set against each other. */
  readonly kind: string;
  /** The same with what names it: cycle, label, axes, target. */
  readonly like: string;
  /** Each word with its value in one spelling; what has no name of its own stands under "". */
  readonly words: ReadonlyMap<string, string>;
  /** The same for two blocks exactly when they mean the same. */
  readonly key: string;
}

/** Blocks that say nothing to the control. */
export const isSaid = ({ statement: { kind } }: Block): boolean =>
  kind !== "empty" && kind !== "comment" && kind !== "structure";

const BARE: Style = { ...LAYOUTS.tnc7, plus: false };
const SIGNED: Style = { ...BARE, plus: true };
const text = (value: Value): string => valueText(value, BARE);
const signed = (value: Value): string => valueText(value, SIGNED);

/** Words of a block under their names; what comes twice is one word with both values. */
class Said {
  readonly words = new Map<string, string>();

  put(name: string, value: string | null | undefined): this {
    if (value === null || value === undefined) return this;
    const before = this.words.get(name);
    this.words.set(name, before === undefined ? value : `${before} ${value}`);
    return this;
  }

  number(name: string, value: Value | null | undefined): this {
    return this.put(name, value === null || value === undefined ? null : text(value));
  }

  axes(axes: readonly AxisWord[], lead = ""): this {
    for (const { axis, value, incremental } of axes) this.put(`${lead}${incremental ? "I" : ""}${axis}`, signed(value));
    return this;
  }

  polar(name: string, word: PolarWord | undefined): this {
    return word ? this.put(`${word.incremental ? "I" : ""}${name}`, signed(word.value)) : this;
  }

  named(words: readonly NamedWord[]): this {
    for (const { name, value } of words) this.number(name, value);
    return this;
  }

  path(words: Words): this {
    this.axes(words.axes).polar("PR", words.polarRadius).polar("PA", words.polarAngle);
    this.number("CCA", words.centreAngle).number("LEN", words.length).number("R", words.radius);
    if (words.turn) this.put("DR", words.turn === "ccw" ? "+" : "-");
    this.axes(words.linear, "LIN_").put("", words.compensation);
    if (words.feed) this.put("F", feedText(words.feed, BARE).replace(/^F(?=[\d.-])/, ""));
    if (words.functions.length > 0) this.put("M", words.functions.toSorted((a, b) => a - b).join(", "));
    if (words.retract !== undefined) this.put("MB", words.retract === "max" ? "MAX" : signed(words.retract));
    if (words.functionFeed) this.put("M F", feedText(words.functionFeed, BARE));
    for (const word of words.extra) this.put("", plainText(word));
    return this;
  }
}

const QUOTED = /("[^"]*")/;
const NUMBER =
  /(?<![\w.,])([+-]?)[ \t]*(\d+(?:[.,]\d*)?|[.,]\d+)(?![\w.,])|(?<=[A-Z])([+-]?)(\d+[.,]\d*|[.,]\d+)(?![\w.,])/gi;
const plainNumber = (sign: string, digits: string): string => {
  const size = Number(digits.replace(",", "."));
  return `${sign === "-" && size !== 0 ? "-" : ""}${size}`;
};

/** Text in one spelling: case, blanks and the way numbers are written count only between quotes. */
function plainText(raw: string): string {
  return raw
    .split(QUOTED)
    .map((part, i) =>
      i % 2 === 1
        ? part
        : part
            .toUpperCase()
            .replace(
              NUMBER,
              (
                _,
                sign: string | undefined,
                digits: string | undefined,
                behind: string | undefined,
                more: string | undefined,
              ) => plainNumber(sign ?? behind ?? "", digits ?? more ?? "0"),
            )
            .replace(/\s+/g, " ")
            .replace(/ ?([=*/()]) ?/g, "$1"),
    )
    .join("")
    .trim();
}

/**
 * Words of four letters and more in the lines of an older cycle are of a language: CONTOUR LABEL, KONTURLABEL, WINKEL.
 */
const LANGUAGE_WORD = /(?<![A-Z.\\:_])[A-Z.]{4,}(?![\\:_])/gi;

function cycleLineText({ cycle, line, text: written }: StatementOf<"cycleLine">): string {
  // The first line only names the cycle.
  if (line === 0) return "";
  if (cycle === CONTOUR_CYCLE) return contourLabels(written).map(labelText).join(" ");
  return cycle === PROGRAM_CYCLE ? plainText(written) : plainText(written.replace(LANGUAGE_WORD, " "));
}

const labelText = (label: Label | Parameter): string =>
  typeof label === "object" ? text(label) : typeof label === "string" ? `"${label}"` : String(label);

/** Values of a cycle that the reader could not make out, as they are written. */
function unread(raw: string, q: string): string {
  const found = new RegExp(String.raw`(?:^|[^A-Z\d])${q}[ \t]*=?[ \t]*([^;~\r\n]*)`, "i").exec(raw);
  return plainText(found?.[1] ?? "");
}

function cycleWords(s: StatementOf<"cycle">, raw: string): Said {
  const said = new Said();
  for (const { q, value } of s.parameters)
    said.put(q, value === null ? unread(raw, q) : parameterValueText(value, BARE));
  return said;
}

const axesOf = ({ axes }: Words): string =>
  axes
    .map(({ axis }) => axis)
    .sort()
    .join("");

/** A block as it stands, without its number, its comment and its line ends. */
export const bareText = ({ raw, number, skip }: Pick<Block, "raw" | "number" | "skip">): string =>
  raw
    .replace(skip || number !== null ? /^\s*\/?[ \t]*(?:N?\d+(?![\d.,]))?[ \t]*\/?/i : /^\s*/, "")
    .replace(/;[^\r\n"]*(?=[\r\n]|$)/g, "");

type Spoken = readonly [kind: string, like: string, said: Said];

/**
 * Statements whose words can be set against each other one by one; undefined for any other, which is compared as a
 * whole.
 */
function spoken(s: Statement, raw: string): Spoken | undefined {
  const said = new Said();
  switch (s.kind) {
    case "begin":
    case "end":
      return [s.kind, s.kind, said.put("", s.unit)];
    case "blankBox":
      return [s.kind, `${s.kind} ${s.corner}`, said.put("", s.axis).axes(s.axes)];
    case "blankCylinder":
      return [
        s.kind,
        s.kind,
        said
          .put("", s.axis)
          .number(s.outside?.measure ?? "D", s.outside?.value)
          .number("L", s.length)
          .number("DIST", s.distance)
          .number(s.inside?.measure ?? "DI", s.inside?.value),
      ];
    case "toolDefinition":
      return [
        s.kind,
        `${s.kind} ${s.tool}`,
        said.put("T", labelText(s.tool)).number("L", s.length).number("R", s.radius),
      ];
    case "toolCall":
      return [
        s.kind,
        s.tool === null ? "toolWords" : s.kind,
        said
          .put("T", s.tool === null ? null : labelText(s.tool))
          .put("", s.axis)
          .number("S", s.speed)
          .put("F", s.feed && feedText(s.feed, BARE).replace(/^F(?=[\d.-])/, ""))
          .number("DL", s.deltaLength)
          .number("DR", s.deltaRadius)
          .put("", s.extra.length > 0 ? plainText(s.extra.join(" ")) : null),
      ];
    case "spin":
      return [
        s.kind,
        s.kind,
        said
          .put("VCONST", s.constantSurface ? "ON" : "OFF")
          .number("VC", s.cuttingSpeed)
          .number("S", s.speed)
          .number("SMAX", s.limit)
          .number("GEARRANGE", s.gear),
      ];
    case "turnCorrection":
      return [s.kind, s.kind, said.put("", `${s.system} ${s.plane}`).named(s.words)];
    case "path":
      return ["path", `${s.path} ${axesOf(s.words)}`, said.put("", s.path).path(s.words)];
    case "free":
      return [s.kind, s.form, said.put("", s.form).named(s.given).path(s.words)];
    case "chamfer":
      return ["path", s.kind, said.put("", "CHF").number("LEN", s.length).path(s.words)];
    case "approach":
      return [
        `${s.kind} ${s.departing}`,
        `${s.kind} ${s.departing}`,
        said.put("", `${s.departing ? "DEP" : "APPR"} ${s.form}`).path(s.words),
      ];
    case "undercut":
    case "groove":
      return [s.kind, s.kind, said.put("", s.form).named(s.words)];
    case "label":
      return [s.kind, `${s.kind} ${labelText(s.label)}`, said.put("LBL", labelText(s.label))];
    case "call":
      return [s.kind, s.kind, said.put("LBL", labelText(s.label)).number("REP", s.repeat)];
    case "cycleLine":
      return [`${s.kind} ${s.cycle}`, `${s.kind} ${s.cycle}.${s.line}`, said.put("", cycleLineText(s))];
    case "cycle":
      return [`${s.kind} ${s.cycle}`, `${s.kind} ${s.cycle}`, cycleWords(s, raw)];
    case "cycleCall":
      return [s.kind, s.kind, said.put("", s.how === "" ? null : s.how).path(s.words)];
    case "functions":
    case "stop":
      return [s.kind, s.kind, said.path(s.words)];
    case "datum":
      return [s.kind, s.kind, s.shift === "reset" ? said.put("", "RESET") : said.axes(s.shift)];
    case "assign":
      return [
        s.kind,
        `${s.kind} ${s.target}`,
        said.put(
          s.target,
          plainText(
            statementLines(s.fn === 0 ? { ...s, fn: null } : s, BARE)
              .join(" ")
              .replace(/^[^=]*=/, ""),
          ),
        ),
      ];
    default:
      return undefined;
  }
}

const wholeText = (s: Statement): string => {
  if (s.kind === "callProgram" || s.kind === "selectProgram")
    return statementLines({ ...s, bare: false }, BARE)
      .join(" ")
      .toUpperCase();
  return plainText(statementLines(s.kind === "jump" ? { ...s, fn: null } : s, BARE).join(" "));
};

/**
 * What a block says, in one spelling: case, blanks, order of words, names of cycles and labels of their parameters do
 * not count.
 */
export function meaningOf(block: Block): Meaning {
  const { statement: s, raw, skip, issues } = block;
  const found = spoken(s, raw);
  const [kind, like] = found ?? [
    s.kind,
    s.kind === "unknown" ? `unknown ${/^\S*/.exec(s.text.toUpperCase())?.[0] ?? ""}` : s.kind,
  ];
  // What the reader did not wholly take up is compared as it stands.
  const said =
    issues.length > 0 && s.kind !== "cycle"
      ? new Said().put("", plainText(bareText(block)))
      : (found?.[2] ?? new Said().put("", wholeText(s)));
  if (skip) said.put("/", "/");
  const words = new Map([...said.words].sort(([a], [b]) => (a < b ? -1 : 1)));
  return { kind, like, words, key: JSON.stringify([kind, like, ...[...words].flat()]) };
}

/** One word of a block and what became of it; null where one of the two has no such word. */
export interface WordChange {
  /** X, F, Q463; "" for what has no name. */
  readonly name: string;
  readonly from: string | null;
  readonly to: string | null;
}

/** What differs between two blocks, word by word, in the order of their names. */
export function wordChanges(a: Meaning, b: Meaning): readonly WordChange[] {
  const names = [...new Set([...a.words.keys(), ...b.words.keys()])];
  return names
    .flatMap((name) => {
      const [from, to] = [a.words.get(name) ?? null, b.words.get(name) ?? null];
      return from === to ? [] : [{ name, from, to }];
    })
    .sort((one, other) => one.name.localeCompare(other.name, "en", { numeric: true }));
}
