import type { ParamTextId } from "../cycles/index.ts";
import type { Kind } from "../cycles/params.ts";

/** Common mistakes with a value: by its kind, and for some parameters in particular. */
export interface MistakesTexts {
  readonly kinds: Readonly<Record<Kind, readonly string[]>>;
  readonly of: Partial<Readonly<Record<ParamTextId, readonly string[]>>>;
}
