import { own } from "./own.ts";
import { tools } from "./tools.ts";

export const zhTables = { tools, own };
