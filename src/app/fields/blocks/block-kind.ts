import { klartext } from "../../../nc/blocks/klartext.ts";
import type { BlockKind } from "../../../nc/blocks/names.ts";
import type { Statement } from "../../../nc/statement.ts";

/** Block kind of a statement, which gives its name. */
export const kindOf = (s: Statement): BlockKind => klartext.nameOf(s) as BlockKind;
