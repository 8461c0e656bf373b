import { readJson } from "../files/bounded.ts";
import { z } from "zod";
import type { Issue } from "../../kernel/plan/issue.ts";
import { BLADE_SUPPORTS, DRILL_TYPES, TOOL_TYPES, type Tool } from "../../kernel/plan/tool.ts";
import { checkTool } from "./check-tool.ts";
import { soundHead } from "./holder-cells.ts";
import { isLimit } from "./tool-columns.ts";
import type { Mill } from "./plane-types.ts";
import { isMillRow } from "./tool-keys.ts";

/** An optional cell, which may be null. */
const cell = z.number().nullish();
/** A stated limit, mm; 0 counts as none. */
const limit = z.number().min(0).nullish();
/** Parts of a head, each by its corners [Z, X]. */
const head = z
  .array(z.array(z.tuple([z.number(), z.number()])))
  .refine(soundHead, "a part needs 3 to 16 corners that are not in line; 8 parts at most");
const row = z.object({
  T: z.number().min(0).max(32767.9),
  NAME: z.string().max(32).nullish(),
  TYPE: z.enum(TOOL_TYPES),
  TO: cell,
  RS: cell,
  ZL: cell,
  XL: cell,
  DZL: cell,
  DXL: cell,
  DYL: cell,
  DRS: cell,
  ORI: cell,
  "T-ANGLE": cell,
  "P-ANGLE": cell,
  CUTLENGTH: cell,
  CUTWIDTH: cell,
  DCW: cell,
  DAXN: limit,
  DAXX: limit,
  CDX: limit,
  CUTDIA: limit,
  DMIN: limit,
  SUPPORT: z.enum(BLADE_SUPPORTS).nullish(),
  holder: z
    .object({
      width: z.number().positive(),
      length: z.number().positive(),
      offsetZ: z.number(),
      offsetX: z.number(),
      axis: z.enum(["X", "Z"]).optional(),
      head: head.optional(),
    })
    .nullish(),
});
/** A milling tool: any row with a radius R and no turning type. */
const mill = z.object({
  T: z.number().min(0).max(32767.9),
  NAME: z.string().max(32).nullish(),
  R: z.number().min(0),
  DR: cell,
  L: cell,
  DL: cell,
  "T-ANGLE": z.number().min(0).max(180).nullish(),
  LCUTS: z.number().min(0).nullish(),
  PITCH: z.number().min(0).nullish(),
  PL: limit,
  TYPE: z
    .string()
    .refine((type) => !TOOL_TYPES.some((t) => t === type))
    .nullish(),
});
const isRecord = (value: unknown): value is Readonly<Record<string, unknown>> =>
  typeof value === "object" && value !== null;
const file = z.object({ tools: z.array(z.unknown()) }).transform(({ tools }, context) => ({
  tools: tools.flatMap((cells, i) => {
    const read = isRecord(cells) && isMillRow(cells) ? mill.safeParse(cells) : row.safeParse(cells);
    if (read.success) return [read.data];
    for (const found of read.error.issues)
      context.addIssue({ code: "custom", message: found.message, path: ["tools", i, ...found.path] });
    return [];
  }),
}));
type MillCells = z.infer<typeof mill>;
type Row = z.infer<typeof mill> | z.infer<typeof row>;
const isMill = (r: Row): r is z.infer<typeof mill> => "R" in r;

/** Data of a milling tool for a run; an empty cell is absent, and so is a length or pitch of 0. */
export function millOf(cells: MillCells): Mill {
  const type = DRILL_TYPES.find((each) => each === cells.TYPE?.toUpperCase());
  return {
    T: cells.T,
    NAME: cells.NAME ?? "",
    R: cells.R,
    DR: cells.DR ?? 0,
    ...(type && {
      TYPE: type,
      ...(cells["T-ANGLE"] && { "T-ANGLE": cells["T-ANGLE"] }),
      ...(cells.LCUTS && { LCUTS: cells.LCUTS }),
      ...(cells.PITCH && { PITCH: cells.PITCH }),
      ...(cells.PL && { PL: cells.PL }),
    }),
  };
}

/** Valid tools, and the issues of the others. */
export interface ShopTools {
  readonly tools: readonly Tool[];
  readonly refused: ReadonlyMap<number, readonly Issue[]>;
  /** Milling tools; only their radius counts. */
  readonly mills?: readonly Mill[];
}

/** Reads a tools file. An invalid file gives `problem`; a row with invalid columns is refused alone. */
export function readTools(text: string): ShopTools | { readonly problem: string } {
  let json: unknown;
  try {
    json = readJson(text);
  } catch {
    return { problem: "it is not JSON" };
  }
  const read = file.safeParse(json);
  if (!read.success) {
    const [first] = read.error.issues;
    return { problem: `${first?.path.join(".") || "the file"}: ${first?.message ?? "not a tool table"}` };
  }
  const tools: Tool[] = [];
  const mills: Mill[] = [];
  const refused = new Map<number, readonly Issue[]>();
  for (const cells of read.data.tools) {
    if (isMill(cells)) {
      mills.push(millOf(cells));
      continue;
    }
    const present = Object.fromEntries(
      Object.entries(cells).filter(
        ([column, value]) =>
          value !== null && value !== undefined && !((column === "CUTLENGTH" || isLimit(column)) && value === 0),
      ),
    );
    const problems = checkTool(present);
    if (problems.length > 0) refused.set(cells.T, problems);
    else tools.push({ NAME: "", ...present } as unknown as Tool);
  }
  return { tools, refused, ...(mills.length > 0 && { mills }) };
}

/** Merges a table into another: rows with the same number are replaced. */
export function over(base: Omit<ShopTools, "refused">, table: ShopTools): ShopTools {
  const own = table.mills ?? [];
  const replaced = new Set([...table.tools, ...own].map(({ T }) => T).concat([...table.refused.keys()]));
  const rest = <Row extends { readonly T: number }>(rows: readonly Row[]) => rows.filter(({ T }) => !replaced.has(T));
  const mills = [...rest(base.mills ?? []), ...own];
  return {
    tools: [...rest(base.tools), ...table.tools],
    refused: table.refused,
    ...(mills.length > 0 && { mills }),
  };
}
