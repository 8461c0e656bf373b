import { isUnsimulated, labelsOfUnsimulated } from "../../../cycles/unsimulated-cycles.ts";
import type { Field, Typed, ValueField } from "../../../nc/blocks/define.ts";
import type { Grammar } from "../../../nc/blocks/grammar.ts";
import { klartext } from "../../../nc/blocks/klartext.ts";
import type { FieldName } from "../../../nc/blocks/names.ts";
import { shownLabel, typedLabel } from "../../../nc/blocks/words.ts";
import { parse } from "../../../nc/parse.ts";
import { statementLines } from "../../../nc/print.ts";
import type { Statement } from "../../../nc/statement.ts";
import { LAYOUTS } from "../../../nc/style.ts";
import { NUMBER_PARAMETER } from "../../../nc/value.ts";
import { typedFunctions } from "../../../program/edits/approach-draft.ts";
import { feedWord } from "../../../program/values/field.ts";
import {
  blockValue,
  feedAsTyped,
  parameterAsTyped,
  typedFeed,
  valueAsTyped,
} from "../../../program/values/typed-value.ts";
import type { WordField } from "./field.ts";

/** Shows a value in a field, and reads typed text; undefined if the text cannot be read. */
interface Entry<T> {
  readonly numeric?: true;
  shown(value: T): string;
  taken(typed: string): T | undefined;
}

/** A tool with its index, as in 5.1, or in a parameter; anything else is a number or a name. */
const TOOL_VALUE = new RegExp(String.raw`^\s*(?:\d{1,9}\.\d\s*$|${NUMBER_PARAMETER})`, "i");
const plain: Entry<string> = { shown: (text) => text, taken: (typed) => typed };
const optionalValue = (typed: string) => (typed.trim() === "" ? null : (blockValue(typed) ?? undefined));

const ENTRIES: { readonly [E in keyof Typed]: Entry<Typed[E]> } = {
  choice: plain,
  text: plain,
  value: { numeric: true, shown: valueAsTyped, taken: optionalValue },
  feed: { shown: feedAsTyped, taken: typedFeed },
  tool: {
    shown: (tool) => (tool === null ? "" : shownLabel(tool)),
    taken(typed) {
      if (typed.trim() === "") return null;
      return TOOL_VALUE.test(typed) ? (blockValue(typed) ?? undefined) : typedLabel(typed);
    },
  },
  // M functions as one types them: `M8 M303`, or `8 303`.
  functions: {
    shown: (functions) => functions.map((m) => `M${m}`).join(" "),
    taken: (typed) => typedFunctions(typed) ?? undefined,
  },
  retract: {
    shown: (retract) => (retract === "max" ? "MAX" : valueAsTyped(retract)),
    taken: (typed) => (/^\s*max\s*$/i.test(typed) ? "max" : optionalValue(typed)),
  },
  parameter: { numeric: true, shown: parameterAsTyped, taken: (typed) => feedWord(typed) ?? blockValue(typed) },
};

/** A statement as one line of text, without number. */
export const statementLine = (s: Statement): string => statementLines(s, LAYOUTS.tnc7)[0] ?? "";

/** Dialog fields of a grammar's blocks: the grammar declares them, this file says how values are typed. */
export function fieldsIn<S extends { readonly kind: string }>(grammar: Grammar<S>) {
  const lineOf = (s: S) => grammar.lines(s, LAYOUTS.tnc7)[0] ?? "";
  const typedField = (field: Field<S>): WordField<S> => {
    const name = field.name as FieldName | { readonly word: string };
    if (field.entry === "line")
      return {
        ...field,
        name,
        numeric: false,
        read: (s) => field.shown(lineOf(s)),
        write(s, typed) {
          const { blocks } = parse(field.line(s, typed));
          const made = blocks.length === 1 ? blocks[0]?.statement : undefined;
          return made && (!field.keeps || made.kind === s.kind) ? (made as unknown as S) : null;
        },
      };
    const { get, put } = field as ValueField<S>;
    const entry = ENTRIES[field.entry] as Entry<Typed[keyof Typed]>;
    return {
      ...field,
      name,
      numeric: entry.numeric ?? false,
      read: (s) => entry.shown(get(s)),
      write(s, typed) {
        const value = entry.taken(typed);
        return value === undefined ? null : (put(s, value) ?? null);
      },
    };
  };
  return (s: S): readonly WordField<S>[] => grammar.fields(s).map(typedField);
}

const klartextFields = fieldsIn(klartext);

/** The fields of a block's dialog, in the order of its words. */
export function fieldsOf(s: Statement): readonly WordField[] {
  const fields = klartextFields(s);
  if (s.kind !== "cycle" || !isUnsimulated(s.cycle)) return fields;
  // Parameter names of a cycle that is not simulated, for parameters without text in the program.
  const labels = labelsOfUnsimulated(s.cycle);
  return fields.map((field, i) =>
    s.parameters[i]?.label === null
      ? { ...field, name: { word: `${field.id} ${labels.get(field.id) ?? ""}`.trim() } }
      : field,
  );
}
