import { catalogue } from "../../src/cycles/index.ts";
import type { ParamTextId } from "../../src/cycles/index.ts";

/** Text id of each Q parameter of each cycle. The build inlines this table instead of the whole catalogue. */
export const promptIds: Readonly<Record<number, Readonly<Record<string, ParamTextId>>>> = Object.fromEntries(
  catalogue.map(({ number, params }) => [
    number,
    Object.fromEntries(Object.entries(params).map(([q, { text }]) => [q, text as ParamTextId])),
  ]),
);
