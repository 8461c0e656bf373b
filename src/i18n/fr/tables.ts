import { own } from "./own.ts";
import { tools } from "./tools.ts";
import { typeset } from "./typeset.ts";

export const frTables = typeset({ tools, own });
