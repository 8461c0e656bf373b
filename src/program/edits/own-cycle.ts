import { cycleByNumber } from "../../cycles/index.ts";
import { isUnsimulated } from "../../cycles/unsimulated-cycles.ts";
import type { StatementOf } from "../../nc/statement.ts";
import type { CycleParameter } from "../../nc/words.ts";
import { isDrilling } from "../blocks/drill-words.ts";
import { anyNumber, feedWord, readText, type Field } from "../values/field.ts";
import { parameterAsTyped } from "../values/typed-value.ts";
import { actsAtOnce, isSilent } from "../blocks/unproved-blocks.ts";

/*
 * Custom cycles of a machine or shop. A description gives them a dialog and clean text; their effect on the workpiece
 * stays unknown, so they stay unverified.
 */

/** Kinds of parameters of a custom cycle. */
export const OWN_KINDS = ["length", "angle", "feed", "choice", "number"] as const;
export type OwnKind = (typeof OWN_KINDS)[number];

/** Typed cells of a parameter; `choices` only of a choice: `0 outside, 1 inside`. */
export const OWN_CELLS = ["q", "prompt", "min", "max", "first", "choices"] as const;
export type OwnCell = (typeof OWN_CELLS)[number];
export interface OwnParameterEntry extends Readonly<Record<OwnCell, string>> {
  readonly id: string;
  readonly kind: OwnKind;
}

/** A description as typed: every field is text, so that wrong input is kept. */
export interface OwnEntry {
  readonly id: string;
  readonly number: string;
  readonly name: string;
  readonly parameters: readonly OwnParameterEntry[];
}

export interface OwnChoice {
  readonly value: number;
  readonly meaning: string;
}

/** A valid parameter of a custom cycle. */
export interface OwnParameter {
  readonly q: string;
  readonly prompt: string;
  readonly kind: OwnKind;
  readonly range: readonly [min: number, max: number];
  /** The range was described, not just the default of a control. */
  readonly bounded: boolean;
  readonly choices: readonly OwnChoice[] | null;
  /** Initial value in an inserted cycle. */
  readonly first: number | "auto";
}

/** A valid description. */
export interface OwnCycle {
  readonly number: number;
  readonly name: string;
  readonly parameters: readonly OwnParameter[];
}

/** A problem of a description, and its field: "number", "name", "parameters", or id and cell of a parameter. */
export interface OwnProblem {
  readonly at: string;
  readonly code:
    | "missing"
    | "noNumber"
    | "known"
    | "twice"
    | "characters"
    | "tooLong"
    | "noParameter"
    | "qTwice"
    | "notANumber"
    | "order"
    | "outside"
    | "choices"
    | "choiceTwice"
    | "tooMany";
  /** The wrong text, or the limit. */
  readonly text: string;
}

export interface OwnReading {
  /** Null while something is wrong. */
  readonly cycle: OwnCycle | null;
  /** The cycle number, as soon as it is valid. */
  readonly number: number | null;
  readonly problems: readonly OwnProblem[];
}

/** Size limits of a description; nobody types more. */
export const OWN_SIZES = { cycles: 200, parameters: 60, name: 60, prompt: 80, choices: 20, cell: 500 } as const;
/** Largest value of a control. */
const WIDEST = 99999.9999;
const LEAST: Readonly<Record<OwnKind, number>> = {
  length: -WIDEST,
  angle: -WIDEST,
  feed: 0,
  choice: -WIDEST,
  number: -WIDEST,
};
export const OWN_DECIMALS = 4;

export const fieldId = (parameter: string, cell: OwnCell): string => `${parameter}.${cell}`;

/** True for a number of a known cycle, simulated or not: it already has a dialog or a meaning. */
export const isKnownCycle = (number: number): boolean =>
  cycleByNumber(number) !== undefined ||
  isUnsimulated(number) ||
  isDrilling(number) ||
  actsAtOnce(number) ||
  isSilent(number);

/** Text of a line of a program: single blanks, none at its ends. */
const trimmed = (text: string): string => text.replace(/\s+/g, " ").trim();
/** The number of a cycle or a parameter, none too long. */
const WHOLE = /^\d{1,4}$/;
const Q = /^(?:Q([LR])?)?(\d{1,4})$/i;
/** Characters that end or split a line of a cycle, or represent a value. */
const NOT_IN_NAME = /[~;="\p{C}]/u;
const NOT_IN_PROMPT = /[~\p{C}]/u;

/** Name of a parameter in a program; null when invalid. */
function parameterName(typed: string): string | null {
  const m = Q.exec(typed.trim());
  return m ? `Q${(m[1] ?? "").toUpperCase()}${m[2] ?? ""}` : null;
}

type Say = (at: string, code: OwnProblem["code"], text?: string) => void;

function numberAt(typed: string, at: string, say: Say): number | null {
  if (typed.trim() === "") return null;
  const { value } = readText({ ...anyNumber, decimals: OWN_DECIMALS }, typed);
  if (value === null) say(at, "notANumber", typed.trim());
  return value;
}

function readChoices(typed: string, at: string, say: Say): readonly OwnChoice[] {
  const parts = typed
    .split(/[,;\n]/)
    .map(trimmed)
    .filter((part) => part !== "");
  const choices = parts.flatMap((part) => {
    const m = /^([+-]?\d{1,5}(?:\.\d{1,4})?)(?:[ =:](.*))?$/.exec(part);
    return m ? [{ value: Number(m[1]), meaning: (m[2] ?? "").replace(/^[ =:]+/, "") }] : [];
  });
  const twice = choices.find(({ value }, i) => choices.findIndex((each) => each.value === value) < i);
  if (choices.length < parts.length || choices.length === 0) say(at, "choices");
  else if (choices.length > OWN_SIZES.choices) say(at, "tooMany", String(OWN_SIZES.choices));
  else if (twice) say(at, "choiceTwice", String(twice.value));
  return choices;
}

/** Initial value of a new block: the typed one, or the valid one nearest to zero. */
function readFirst(
  p: OwnParameterEntry,
  [min, max]: OwnParameter["range"],
  choices: OwnParameter["choices"],
  say: Say,
): number | "auto" {
  const at = fieldId(p.id, "first");
  if (p.kind === "feed" && feedWord(p.first) === "auto") return "auto";
  const typed = numberAt(p.first, at, say);
  if (typed === null) return choices?.[0]?.value ?? Math.min(max, Math.max(min, 0));
  const fits =
    choices && choices.length > 0 ? choices.some(({ value }) => value === typed) : typed >= min && typed <= max;
  if (!fits) say(at, "outside", p.first.trim());
  return typed;
}

function readParameter(p: OwnParameterEntry, say: Say): OwnParameter {
  const at = (cell: OwnCell) => fieldId(p.id, cell);
  const q = parameterName(p.q);
  if (q === null) say(at("q"), p.q.trim() === "" ? "missing" : "noParameter", p.q.trim());
  const prompt = trimmed(p.prompt);
  if (prompt === "") say(at("prompt"), "missing");
  else if (prompt.length > OWN_SIZES.prompt) say(at("prompt"), "tooLong", String(OWN_SIZES.prompt));
  else if (NOT_IN_PROMPT.test(prompt)) say(at("prompt"), "characters", "~");
  const choices = p.kind === "choice" ? readChoices(p.choices, at("choices"), say) : null;
  const [min, max] = choices ? [null, null] : [numberAt(p.min, at("min"), say), numberAt(p.max, at("max"), say)];
  const range = [min ?? Math.min(LEAST[p.kind], max ?? 0), max ?? WIDEST] as const;
  if (range[0] > range[1]) say(at("max"), "order", p.max.trim() || String(range[1]));
  const first = readFirst(p, range, choices, say);
  return { q: q ?? "", prompt, kind: p.kind, range, bounded: min !== null || max !== null, choices, first };
}

/** Reads one description. Duplicate numbers are found in the list (own-library.ts). */
export function readOwn(entry: OwnEntry): OwnReading {
  const problems: OwnProblem[] = [];
  const say: Say = (at, code, text = "") => problems.push({ at, code, text });
  const digits = entry.number.trim();
  const number = WHOLE.test(digits) && Number(digits) > 0 ? Number(digits) : null;
  if (digits === "") say("number", "missing");
  else if (number === null) say("number", "noNumber", digits);
  else if (isKnownCycle(number)) say("number", "known", digits);
  const name = trimmed(entry.name);
  if (name === "") say("name", "missing");
  else if (name.length > OWN_SIZES.name) say("name", "tooLong", String(OWN_SIZES.name));
  else if (NOT_IN_NAME.test(name) || /^[.]/.test(name)) say("name", "characters", '~ ; = "');
  if (entry.parameters.length > OWN_SIZES.parameters) say("parameters", "tooMany", String(OWN_SIZES.parameters));
  const parameters = entry.parameters.map((p) => readParameter(p, say));
  parameters.forEach(({ q }, i) => {
    const isSecond = q !== "" && parameters.findIndex((each) => each.q === q) < i;
    if (isSecond) say(fieldId(entry.parameters[i]?.id ?? "", "q"), "qTwice", q);
  });
  return { cycle: number !== null && problems.length === 0 ? { number, name, parameters } : null, number, problems };
}

/** Field of a prompt of a custom cycle. */
export const ownField = ({ q, kind, range, choices }: OwnParameter): Field => ({
  id: q,
  kind,
  range,
  ...(choices && { choices: choices.map(({ value }) => value) }),
  optional: false,
  decimals: OWN_DECIMALS,
  rapid: kind === "feed",
});

/** The block of the cycle in a program. */
export const ownStatement = ({ number, name, parameters }: OwnCycle): StatementOf<"cycle"> => ({
  kind: "cycle",
  cycle: number,
  name,
  parameters: parameters.map(({ q, prompt, first }) => ({ q, value: first, label: prompt })),
});

export const newParameter = (id: string, given: Partial<Omit<OwnParameterEntry, "id">> = {}): OwnParameterEntry => ({
  id,
  q: "",
  prompt: "",
  kind: "number",
  min: "",
  max: "",
  first: "",
  choices: "",
  ...given,
});

/** Words of a parameter label that clearly name its kind. */
const WORDS: readonly (readonly [RegExp, OwnKind])[] = [
  [/\bFEED(?!ER)|VORSCHUB|\bAVANCE|进给/i, "feed"],
  [/\bANG(?:LE|\b)|WINKEL|角/i, "angle"],
  [
    /DIAMETER|DURCHMESSER|DIAM[EÈ]TRE|\bDEPTH|TIEFE|PROFONDEUR|LENGTH|LAENGE|LÄNGE|LONGUEUR|CLEARANCE|ABSTAND|DISTANCE|直径|深度|长度/i,
    "length",
  ],
];

function kindOf({ value, label }: CycleParameter): OwnKind {
  if (value === "auto" || value === "max") return "feed";
  return WORDS.find(([words]) => words.test(label ?? ""))?.[1] ?? "number";
}

/** Proposes a description from a block: number, name, parameters with the prompts behind `;`, and values. */
export function describedFrom(s: StatementOf<"cycle">, id: string): OwnEntry {
  const named = s.parameters.filter(({ q }, i) => s.parameters.findIndex((each) => each.q === q) === i);
  return {
    id,
    number: String(s.cycle),
    name: trimmed(s.name.replace(new RegExp(NOT_IN_NAME, "gu"), " ")),
    parameters: named.slice(0, OWN_SIZES.parameters).map((p, i) => {
      const value = typeof p.value === "number" || p.value === "auto" ? parameterAsTyped(p.value) : "";
      const prompt = trimmed((p.label ?? "").replace(new RegExp(NOT_IN_PROMPT, "gu"), " "));
      return newParameter(`p${i + 1}`, { q: p.q, prompt, kind: kindOf(p), first: value });
    }),
  };
}
