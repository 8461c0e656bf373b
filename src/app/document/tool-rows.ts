import { z } from "zod/mini";
import { LONGEST_CELL } from "../../program/files/bounded.ts";
import { BESIDE_CELLS, MILL_COLUMNS, TOOL_COLUMNS } from "../../program/tools/tool-columns.ts";

const cellText = z.string().check(z.maxLength(LONGEST_CELL));
const cells = z.partialRecord(z.enum([...TOOL_COLUMNS, ...MILL_COLUMNS, ...BESIDE_CELLS]), cellText);

export const toolRow = z.object({ id: cellText, cells });
/** Most rows of a tool table, far above what a magazine and its store hold. */
export const MOST_TOOLS = 20_000;

/** Rows of a tool table from untrusted data. */
export const toolRows = z.array(toolRow).check(z.maxLength(MOST_TOOLS));
