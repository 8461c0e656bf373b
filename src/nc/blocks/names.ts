import type { AnyWord, BlockDefinition } from "./define.ts";
import type { blocks } from "./index.ts";

type Kinds = (typeof blocks)[number];
type NamesOf<B> = B extends BlockDefinition<string, readonly AnyWord[], infer N> ? N : never;
type FieldsOf<B> = B extends { readonly words: readonly (infer E)[]; readonly fieldNames?: infer F }
  ? F | NameIn<E>
  : never;
type NameIn<E> = E extends { readonly names?: infer N } ? N : never;

/** The names that blocks go by: a text for each of them. */
export type BlockKind = NamesOf<Kinds>;
/** The names of what forms ask for: a text for each of them. */
export type FieldName = NonNullable<FieldsOf<Kinds>> | "text";
