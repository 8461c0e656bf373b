import { catalogue } from "../../src/cycles/index.ts";
import type { ParamTextId } from "../../src/cycles/index.ts";

/**
 * Which text asks for each Q parameter of each cycle. The build takes these names over in place of the whole catalogue.
 */
export const promptIds: Readonly<Record<number, Readonly<Record<string, ParamTextId>>>> = Object.fromEntries(
  catalogue.map(({ number, params }) => [
    number,
    Object.fromEntries(Object.entries(params).map(([q, { text }]) => [q, text as ParamTextId])),
  ]),
);
