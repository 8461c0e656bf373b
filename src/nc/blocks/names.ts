import type { AnyWord, BlockDefinition } from "./define.ts";
import type { blocks } from "./index.ts";

type Kinds = (typeof blocks)[number];
type NamesOf<B> = B extends BlockDefinition<string, readonly AnyWord[], infer N> ? N : never;
type FieldsOf<B> = B extends { readonly words: readonly (infer E)[]; readonly fieldNames?: infer F }
  ? F | NameIn<E>
  : never;
type NameIn<E> = E extends { readonly names?: infer N } ? N : never;

/** The names of blocks: one text for each. */
export type BlockKind = NamesOf<Kinds>;
/** The names of form fields: one text for each. */
export type FieldName = NonNullable<FieldsOf<Kinds>> | "text";
