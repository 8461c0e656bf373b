import { autocompletion, type Completion, type CompletionContext, type CompletionResult } from "@codemirror/autocomplete";
import type { EditorState, Extension } from "@codemirror/state";
import { hoverTooltip } from "@codemirror/view";
import type { Cycle } from "../../cycles/define.ts";
import { cycleByNumber, type ParamTextId } from "../../cycles/index.ts";
import type { Param } from "../../cycles/params.ts";
import type { Texts } from "../../i18n/index.ts";
import type { Language } from "../../i18n/languages.ts";
import { ncLabels } from "../../i18n/nc-labels.ts";
import { formatNumber } from "../../i18n/number.ts";
import { blockAt } from "../../nc/reread.ts";
import { NUMBER_PARAMETER } from "../../nc/value.ts";
import { unitOf } from "../dialog/write-value.ts";
import { readingField } from "./reading-field.ts";

/** The cycle of the catalogue that the block at an offset defines, and the parameters that stand there. */
function cycleAt(
  state: EditorState,
  offset: number,
): { readonly cycle: Cycle; readonly present: readonly string[]; readonly continued: boolean } | null {
  const reading = state.field(readingField);
  let index = blockAt(reading, offset);
  // What is just being typed behind a cycle may not belong to it yet.
  while (index > 0 && reading.program.blocks[index]?.number === null && reading.program.blocks[index]?.statement.kind !== "cycle")
    index -= 1;
  const block = reading.program.blocks[index];
  if (block?.statement.kind !== "cycle") return null;
  const cycle = cycleByNumber(block.statement.cycle);
  return cycle ? { cycle, present: block.statement.parameters.map((p) => p.q), continued: /~[^\S\r\n]*[\r\n]/.test(block.raw) } : null;
}

const rangeText = (t: Texts, language: Language, param: Param): string =>
  param.choices
    ? param.choices.join(" / ")
    : "" + (t.dialog.range(formatNumber(language, param.range[0], param.decimals), formatNumber(language, param.range[1], param.decimals)))
      + ` ${t.dialog.units[unitOf(param, true)]}`;

function helpElement(t: Texts, language: Language, q: string, param: Param): HTMLElement {
  const words = t.params[param.text as ParamTextId];
  const box = document.createElement("div");
  box.className = "nc-help";
  const add = (tag: "b" | "p" | "li", text: string, to: HTMLElement = box) => {
    const element = document.createElement(tag);
    element.textContent = text;
    to.append(element);
  };
  add("b", `${q} ${words.prompt}`);
  add("p", `${t.dialog.rangeLabel}: ${rangeText(t, language, param)}`);
  if ("choices" in words) {
    const list = document.createElement("ul");
    for (const [choice, meaning] of Object.entries(words.choices)) add("li", `${choice}: ${meaning}`, list);
    box.append(list);
  }
  add("p", words.explanation);
  return box;
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
  const labels = ncLabels(language);
  const missing = Object.entries(at.cycle.params).filter(([q]) => !at.present.includes(q) || q === typed.text.trim().toUpperCase());
  return {
    from: typed.from + typed.text.search(/Q/i),
    validFor: /^Q\d*$/i,
    options: missing.map(([q, param]): Completion => ({
      label: q,
      detail: t.params[param.text as ParamTextId].label,
      type: "property",
      apply: `${q}=${param.example >= 0 ? "+" : ""}${param.example} ;${labels.label(param.text)}${at.continued ? " ~" : ""}`,
      info: () => helpElement(t, language, q, param),
    })),
  };
}

function blockWords(context: CompletionContext): CompletionResult | null {
  const typed = context.matchBefore(/^\s*\/?\d*\s*[A-Z][A-Z ]*/i);
  if (!typed) return null;
  const word = /[A-Z][A-Z ]*$/i.exec(typed.text)?.[0] ?? "";
  if (!context.explicit && word.length < 2) return null;
  return { from: context.pos - word.length, validFor: /^[A-Z ]*$/i, options: KEYWORDS.map((label) => ({ label, type: "keyword" })) };
}

const PARAMETERS = new RegExp(NUMBER_PARAMETER, "gi");

/** Completion and hover help of a screen language: what a Q parameter asks and allows in the cycle of its block. */
export function cycleHelp(t: Texts, language: Language): Extension {
  return [
    autocompletion({ override: [(context) => parameters(t, language, context) ?? blockWords(context)], icons: false }),
    hoverTooltip((view, offset) => {
      const line = view.state.doc.lineAt(offset);
      const found = [...line.text.matchAll(PARAMETERS)].find((m) =>
        offset >= line.from + m.index && offset <= line.from + m.index + m[0].length
      );
      const at = found && cycleAt(view.state, offset);
      const q = found?.[0].toUpperCase() ?? "";
      const param = at?.cycle.params[q];
      if (!found || !param) return null;
      const pos = line.from + found.index;
      return { pos, end: pos + q.length, above: true, create: () => ({ dom: helpElement(t, language, q, param) }) };
    }),
  ];
}
