import type { Statement } from "../statement.ts";
import { grammarOf } from "./grammar.ts";
import { blocks } from "./index.ts";

/** The blocks that a control reads. */
export const klartext = grammarOf<Statement>(blocks);
