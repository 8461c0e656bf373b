import { LESSON_LANGUAGES } from "../../src/course/whole.ts";

/** What a schema of zod says of itself, as far as its fields go. */
interface Definition {
  readonly type: string;
  readonly shape?: Readonly<Record<string, Schema>>;
  readonly innerType?: Schema;
  readonly element?: Schema;
  readonly options?: readonly Schema[];
  readonly items?: readonly Schema[];
}
export interface Schema {
  readonly def: Definition;
}

const languages: readonly string[] = LESSON_LANGUAGES;

/**
 * Every field of a schema by its path: "part.threads[].pitch". Of a choice the fields of all that may stand there; the languages are one,
 * "words.en".
 */
export function fieldsOf({ def }: Schema, path = ""): string[] {
  if (def.shape) {
    return Object.entries(def.shape).flatMap(([name, inner]) => {
      if (languages.includes(name) && name !== languages[0]) return [];
      const own = path === "" ? name : `${path}.${name}`;
      const below = fieldsOf(inner, own);
      return [own, ...below];
    });
  }
  if (def.innerType) return fieldsOf(def.innerType, path);
  if (def.element) return fieldsOf(def.element, `${path}[]`);
  const any = def.options ?? [];
  return [...new Set(any.flatMap((option) => fieldsOf(option, path)))];
}
