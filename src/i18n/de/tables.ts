import { own } from "./own.ts";
import { tools } from "./tools.ts";

export const deTables = { tools, own };
