import { LESSON_LANGUAGES } from "../../src/i18n/languages.ts";

/** The definition of a zod schema, as far as its fields need it. */
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

/** Whether the value of a schema is optional. */
const canBeLeft = ({ def }: Schema): boolean => def.type === "optional" || def.type === "default";

/** The fields that are required where their group is present; for a union, the required fields of each branch. */
export function neededFields({ def }: Schema, path = ""): string[] {
  if (def.shape) {
    return Object.entries(def.shape).flatMap(([name, inner]) => {
      if (languages.includes(name) && name !== languages[0]) return [];
      const own = path === "" ? name : `${path}.${name}`;
      return [...(canBeLeft(inner) ? [] : [own]), ...neededFields(inner, own)];
    });
  }
  if (def.innerType) return neededFields(def.innerType, path);
  if (def.element) return neededFields(def.element, `${path}[]`);
  const all = (def.options ?? []).map((option) => ({ has: fieldsOf(option, path), needs: neededFields(option, path) }));
  return [...new Set(all.flatMap(({ needs }) => needs))].filter((name) =>
    all.every(({ has, needs }) => !has.includes(name) || needs.includes(name)),
  );
}

/**
 * Every field of a schema by its path: "part.threads[].pitch". A union contributes the fields of all branches; the
 * languages count as one, "words.en".
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
