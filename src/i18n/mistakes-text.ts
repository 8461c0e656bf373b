import type { ParamTextId } from "../cycles/index.ts";
import type { Kind } from "../cycles/params.ts";

/** What is often done wrong with a value: of its kind, and of some parameters in particular. */
export interface MistakesTexts {
  readonly kinds: Readonly<Record<Kind, readonly string[]>>;
  readonly of: Partial<Readonly<Record<ParamTextId, readonly string[]>>>;
}
