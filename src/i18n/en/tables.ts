import { own } from "./own.ts";
import { tools } from "./tools.ts";

export const enTables = { tools, own };
