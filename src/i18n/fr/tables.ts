import type { TableTexts } from "../index.ts";
import { own } from "./tables/own.ts";
import { tools } from "./tables/tools.ts";
import { typeset } from "./typography/typeset.ts";

export const tables: TableTexts = typeset({ tools, own });
