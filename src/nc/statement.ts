import type { BlockDefinition, StatementOfWords } from "./blocks/define.ts";
import type { blocks } from "./blocks/index.ts";

/** The content of a block: its kind, and the words of its declaration. */
export type Statement = StatementIn<(typeof blocks)[number]>;
type StatementIn<B> = B extends BlockDefinition<infer K, infer W> ? StatementOfWords<K, W> : never;

/** A block of one kind, or of several. */
export type StatementOf<K extends Statement["kind"]> = Extract<Statement, { kind: K }>;
