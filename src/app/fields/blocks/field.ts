import type { EditorTexts } from "../../../i18n/en/workplace/editor.ts";
import type { Label, Parameter, Statement, Value } from "../../../nc/statement.ts";
import { blockValue } from "../../../program/values/typed-value.ts";

type PlainName = {
  [K in keyof EditorTexts["fields"]]: EditorTexts["fields"][K] extends string ? K : never;
}[keyof EditorTexts["fields"]];
/** What a field is called: one of the texts, or a word of the program itself. */
export type FieldName = PlainName | { readonly word: string };

/** One field of a block's dialog, read from the statement and written back into it. */
export interface WordField {
  /** The same for the same field, whatever the block holds. */
  readonly id: string;
  readonly name: FieldName;
  /** Choices show their own words, or the text of their key; an empty one is "none". */
  readonly choices?: readonly string[];
  /** Longer text, as wide as the dialog. */
  readonly wide?: boolean;
  /** A number with a sign key. */
  readonly numeric?: boolean;
  readonly unit?: string;
  readonly read: (s: Statement) => string;
  /** The statement with the typed text; null where it can not be read. */
  readonly write: (s: Statement, typed: string) => Statement | null;
  /** A switch beside the value, for incremental coordinates. */
  readonly incremental?: {
    readonly read: (s: Statement) => boolean;
    readonly write: (s: Statement, on: boolean) => Statement;
  };
}

/** A field of statements of one kind; on any other statement it does nothing. */
export function fieldOf<K extends Statement["kind"]>(
  kind: K,
  name: FieldName,
  read: (s: Extract<Statement, { kind: K }>) => string,
  write: (s: Extract<Statement, { kind: K }>, typed: string) => Statement | null,
  more: Partial<Pick<WordField, "choices" | "wide" | "numeric" | "unit" | "id">> = {},
): WordField {
  const own = (s: Statement): s is Extract<Statement, { kind: K }> => s.kind === kind;
  return {
    id: typeof name === "string" ? name : name.word,
    name,
    ...more,
    read: (s) => (own(s) ? read(s) : ""),
    write: (s, typed) => (own(s) ? write(s, typed) : null),
  };
}

/** A value that may be left out. `put` takes null where nothing was typed. */
export const optionalValue = <S>(typed: string, put: (value: Value | null) => S): S | null => {
  if (typed.trim() === "") return put(null);
  const value = blockValue(typed);
  return value === null ? null : put(value);
};

export const shownLabel = (label: Label | Parameter): string =>
  typeof label === "object" ? label.parameter : String(label);

/** A typed label: digits are its number, anything else its name. */
export const labelAsTyped = (typed: string): Label | null => {
  const text = typed.trim().replaceAll('"', "");
  if (text === "" || /[\r\n]/.test(text)) return null;
  return /^\d{1,9}$/.test(text) ? Number(text) : text;
};

/** One line of text without what would end or cut it. */
export const singleLine = (typed: string): string | null => (/[\r\n]/.test(typed) ? null : typed);
