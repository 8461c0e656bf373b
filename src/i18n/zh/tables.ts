import type { TableTexts } from "../index.ts";
import { own } from "./tables/own.ts";
import { tools } from "./tables/tools.ts";

export const tables: TableTexts = { tools, own };
