import { klartext } from "../../../nc/blocks/klartext.ts";
import type { BlockKind } from "../../../nc/blocks/names.ts";
import type { Statement } from "../../../nc/statement.ts";

/** What kind of block a statement is, for its name. */
export const kindOf = (s: Statement): BlockKind => klartext.nameOf(s) as BlockKind;
