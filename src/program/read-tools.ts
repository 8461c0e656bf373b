import { z } from "zod";
import type { Issue } from "../kernel/issue.ts";
import { TOOL_TYPES, type Tool } from "../kernel/tool.ts";
import { checkTool } from "./check-tool.ts";

/** A cell that may be left out or written as null. */
const cell = z.number().nullish();
const row = z.object({
  T: z.number().min(0).max(32767.9), NAME: z.string().max(32).nullish(), TYPE: z.enum(TOOL_TYPES), TO: cell, RS: cell,
  ZL: cell, XL: cell, DZL: cell, DXL: cell, DRS: cell, ORI: cell, "T-ANGLE": cell, "P-ANGLE": cell, CUTLENGTH: cell, CUTWIDTH: cell, DCW: cell,
  holder: z.object({ width: z.number().positive(), length: z.number().positive(), offsetZ: z.number(), offsetX: z.number() }).nullish(),
});
const file = z.object({ tools: z.array(row) });

/** Tools that can cut, and for the others what is wrong with their columns. */
export interface ToolTable {
  readonly tools: readonly Tool[];
  readonly refused: ReadonlyMap<number, readonly Issue[]>;
}

/** Reads the text of a tools file. A file that is no table gives `problem`; a row with impossible columns is refused alone. */
export function readTools(text: string): ToolTable | { readonly problem: string } {
  let json: unknown;
  try {
    json = JSON.parse(text);
  } catch {
    return { problem: "it is not JSON" };
  }
  const read = file.safeParse(json);
  if (!read.success) {
    const [first] = read.error.issues;
    return { problem: `${first?.path.join(".") || "the file"}: ${first?.message ?? "not a tool table"}` };
  }
  const tools: Tool[] = [];
  const refused = new Map<number, readonly Issue[]>();
  for (const cells of read.data.tools) {
    const present = Object.fromEntries(Object.entries(cells).filter(([, value]) => value !== null && value !== undefined));
    const problems = checkTool(present);
    if (problems.length > 0) refused.set(cells.T, problems);
    else tools.push({ NAME: "", ...present } as unknown as Tool);
  }
  return { tools, refused };
}

/** A table over another: rows of the same number are replaced. */
export function over(base: readonly Tool[], table: ToolTable): ToolTable {
  const replaced = new Set([...table.tools.map((t) => t.T), ...table.refused.keys()]);
  return { tools: [...base.filter((t) => !replaced.has(t.T)), ...table.tools], refused: table.refused };
}
