import {
  autocompletion,
  type Completion,
  type CompletionContext,
  type CompletionResult,
} from "@codemirror/autocomplete";
import type { EditorState, Extension } from "@codemirror/state";
import { hoverTooltip } from "@codemirror/view";
import { cycleByNumber, type ParamTextId } from "../../../cycles/index.ts";
import type { Param } from "../../../cycles/params.ts";
import type { Texts } from "../../../i18n/index.ts";
import { ncLanguageOf, type Language } from "../../../i18n/languages.ts";
import { ncLabels } from "../../../i18n/nc-labels.ts";
import { formatNumber } from "../../../i18n/number.ts";
import { blockAt } from "../../../nc/reread.ts";
import { NUMBER_PARAMETER } from "../../../nc/value.ts";
import { OWN_DECIMALS, type OwnParameter } from "../../../program/edits/own-cycle.ts";
import { ownCycle } from "../../document/own-reading.ts";
import { unitOf } from "../dialog/write-value.ts";
import { readingField } from "./reading-field.ts";

/** Name and help of a parameter: from the catalogue in the screen language, or from the description of an own cycle. */
interface Known {
  readonly q: string;
  readonly name: string;
  /** Text after its value when it is inserted. */
  readonly text: string;
  readonly help: () => HTMLElement;
}

interface Defined {
  readonly number: number;
  readonly present: readonly string[];
  readonly continued: boolean;
}

/** The cycle that the block at an offset defines, and the parameters in that block. */
function cycleAt(state: EditorState, offset: number): Defined | null {
  const reading = state.field(readingField);
  let index = blockAt(reading, offset);
  // A line being typed after a cycle may not belong to it yet.
  while (
    index > 0 &&
    reading.program.blocks[index]?.number === null &&
    reading.program.blocks[index]?.statement.kind !== "cycle"
  )
    index -= 1;
  const block = reading.program.blocks[index];
  if (block?.statement.kind !== "cycle") return null;
  const { cycle, parameters } = block.statement;
  return { number: cycle, present: parameters.map((p) => p.q), continued: /~[^\S\r\n]*[\r\n]/.test(block.raw) };
}

const rangeText = (t: Texts, language: Language, param: Param): string =>
  param.choices
    ? param.choices.join(" / ")
    : "" +
      t.dialog.range(
        formatNumber(language, param.range[0], param.decimals),
        formatNumber(language, param.range[1], param.decimals),
      ) +
      ` ${t.dialog.units[unitOf(param, true)]}`;

/** Help of a parameter: question, range, choices and effect. */
function helpElement(
  t: Texts,
  title: string,
  range: string,
  choices: Readonly<Record<string, string>>,
  about: string,
): HTMLElement {
  const box = document.createElement("div");
  box.className = "nc-help";
  const add = (tag: "b" | "p" | "li", text: string, to: HTMLElement = box) => {
    const element = document.createElement(tag);
    element.textContent = text;
    to.append(element);
  };
  add("b", title);
  if (range !== "") add("p", `${t.dialog.rangeLabel}: ${range}`);
  if (Object.keys(choices).length > 0) {
    const list = document.createElement("ul");
    for (const [choice, meaning] of Object.entries(choices)) add("li", `${choice}: ${meaning}`, list);
    box.append(list);
  }
  add("p", about);
  return box;
}

const assigned = (q: string, value: number | "auto", label: string): string =>
  `${q}=${value === "auto" ? "FAUTO" : (value >= 0 ? "+" : "") + String(value)} ;${label}`;

function ownParameter(
  t: Texts,
  language: Language,
  { q, prompt, range, bounded, choices, first }: OwnParameter,
): Known {
  const [min, max] = range.map((n) => formatNumber(language, n, OWN_DECIMALS));
  const shown = bounded ? t.dialog.range(min ?? "", max ?? "") : "";
  const meanings = Object.fromEntries((choices ?? []).map(({ value, meaning }) => [String(value), meaning]));
  return {
    q,
    name: prompt,
    text: assigned(q, first, prompt),
    help: () => helpElement(t, `${q} ${prompt}`, shown, meanings, t.editor.ownUnproved),
  };
}

/** The parameters of a cycle in order, from the catalogue or the operator's description. */
function parametersOf(t: Texts, language: Language, number: number): readonly Known[] {
  const labels = ncLabels(ncLanguageOf(language));
  const known = cycleByNumber(number);
  if (!known) return ownCycle(number)?.parameters.map((p) => ownParameter(t, language, p)) ?? [];
  return Object.entries<Param>(known.params).map(([q, param]) => {
    const words = t.params[param.text as ParamTextId];
    const choices: Readonly<Record<string, string>> = "choices" in words ? words.choices : {};
    return {
      q,
      name: words.label,
      text: assigned(q, param.example, labels.label(param.text)),
      help: () => helpElement(t, `${q} ${words.prompt}`, rangeText(t, language, param), choices, words.explanation),
    };
  });
}

/** Blocks that can be begun by typing. */
const KEYWORDS = [
  "BEGIN PGM",
  "BLK FORM CYLINDER Z",
  "BLK FORM ROTATION Z",
  "BLK FORM 0.1 Z",
  "TOOL CALL",
  "TOOL DEF",
  "FUNCTION MODE TURN",
  "FUNCTION MODE MILL",
  "FUNCTION TURNDATA SPIN VCONST:ON VC:",
  "FUNCTION TURNDATA BLANK",
  "FUNCTION TURNDATA CORR-TCS:Z/X",
  "CYCL DEF",
  "CYCL CALL",
  "CALL LBL",
  "LBL",
  "SEL CONTOUR",
  "APPR LT",
  "APPR LN",
  "APPR CT",
  "APPR LCT",
  "DEP LT",
  "DEP LN",
  "DEP CT",
  "DEP LCT",
  "RND",
  "CHF",
  "UDC TYPE_E",
  "GRV RADIAL",
  "GRV AXIAL",
  "STOP",
  "END PGM",
];

function parameters(t: Texts, language: Language, context: CompletionContext): CompletionResult | null {
  const typed = context.matchBefore(/^\s*Q\d*/i);
  const at = typed && cycleAt(context.state, context.pos);
  if (!typed || !at) return null;
  const typedName = typed.text.trim().toUpperCase();
  const missing = parametersOf(t, language, at.number).filter(({ q }) => !at.present.includes(q) || q === typedName);
  return {
    from: typed.from + typed.text.search(/Q/i),
    validFor: /^Q\d*$/i,
    options: missing.map(({ q, name, text, help }): Completion => ({
      label: q,
      detail: name,
      type: "property",
      apply: `${text}${at.continued ? " ~" : ""}`,
      info: help,
    })),
  };
}

function blockWords(context: CompletionContext): CompletionResult | null {
  const typed = context.matchBefore(/^\s*(?:\/\d*\s*|\d+\s*)?[A-Z][A-Z ]*/i);
  if (!typed) return null;
  const word = typed.text.replace(/^[^A-Z]+/i, "");
  if (!context.explicit && word.length < 2) return null;
  return {
    from: context.pos - word.length,
    validFor: /^[A-Z ]*$/i,
    options: KEYWORDS.map((label) => ({ label, type: "keyword" })),
  };
}

/** What can be typed at a place of a program: the parameters of its cycle that are missing, or how a block begins. */
export const completionsAt = (t: Texts, language: Language, context: CompletionContext): CompletionResult | null =>
  parameters(t, language, context) ?? blockWords(context);

const PARAMETERS = new RegExp(NUMBER_PARAMETER, "gi");

/** Completion and hover help of a screen language: what a Q parameter asks and allows in the cycle of its block. */
export function cycleHelp(t: Texts, language: Language): Extension {
  return [
    autocompletion({ override: [(context) => completionsAt(t, language, context)], icons: false }),
    hoverTooltip((view, offset) => {
      const line = view.state.doc.lineAt(offset);
      const found = [...line.text.matchAll(PARAMETERS)].find(
        (m) => offset >= line.from + m.index && offset <= line.from + m.index + m[0].length,
      );
      const at = found && cycleAt(view.state, offset);
      const q = found?.[0].toUpperCase() ?? "";
      const known = at ? parametersOf(t, language, at.number).find((p) => p.q === q) : undefined;
      if (!found || !known) return null;
      const pos = line.from + found.index;
      return { pos, end: pos + q.length, above: true, create: () => ({ dom: known.help() }) };
    }),
  ];
}
