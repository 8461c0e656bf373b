import type { FieldFacts } from "../../../nc/blocks/define.ts";
import type { FieldName } from "../../../nc/blocks/names.ts";
import type { Statement } from "../../../nc/statement.ts";

/** One field of a block's dialog, read from the statement and written back into it. */
export interface WordField<S = Statement> extends FieldFacts<FieldName> {
  /** A number with a sign key. */
  readonly numeric: boolean;
  readonly read: (s: S) => string;
  /** The statement with the typed text; null where it can not be read. */
  readonly write: (s: S, typed: string) => S | null;
  /** A switch beside the value, for incremental coordinates. */
  readonly incremental?: {
    readonly read: (s: S) => boolean;
    readonly write: (s: S, on: boolean) => S;
  };
}
