import { issue, type Issue } from "../../kernel/plan/issue.ts";
import { type Tool, TOOL_TYPES } from "../../kernel/plan/tool.ts";

/** A row of the tool table from a file or a form: any cell may be empty. mm and degrees. */
export type ToolRow = { readonly [C in keyof Tool]?: Tool[C] | number | string | null };

interface Limits {
  readonly min?: number;
  readonly max?: number;
}

const wrong = (column: string, value: number | null, limits: Limits = {}): Issue =>
  issue("toolColumn", "error", { column, value, ...limits }, column);

const numberIn = (row: ToolRow, column: keyof Tool): number | null => {
  const cell = row[column];
  return typeof cell === "number" && Number.isFinite(cell) ? cell : null;
};

const isEmpty = (row: ToolRow, column: keyof Tool) =>
  row[column] === undefined || row[column] === null || row[column] === "";

/** Smallest radius of a round insert. */
const LEAST_ROUND = 0.001;

/** Smallest point angle of a thread insert, degrees. */
const LEAST_POINT = 1;

function tip(row: ToolRow): Issue[] {
  const found: Issue[] = [];
  const orientation = numberIn(row, "TO");
  if (orientation === null || !Number.isInteger(orientation) || orientation < 1 || orientation > 9)
    found.push(wrong("TO", orientation, { min: 1, max: 9 }));
  const nose = numberIn(row, "RS");
  const least = row.TYPE === "BUTTON" ? LEAST_ROUND : 0;
  if (nose === null || nose < least) found.push(wrong("RS", nose, { min: least }));
  const wear = numberIn(row, "DRS") ?? 0;
  if (nose !== null && nose >= least && nose + wear < least) found.push(wrong("DRS", wear, { min: least - nose }));
  return found;
}

function width(row: ToolRow): Issue[] {
  if (row.TYPE !== "RECESS" && row.TYPE !== "RECTURN") return [];
  const corners = 2 * Math.max(0, (numberIn(row, "RS") ?? 0) + (numberIn(row, "DRS") ?? 0));
  const cut = numberIn(row, "CUTWIDTH");
  if (cut === null) return [wrong("CUTWIDTH", null, { min: corners })];
  const effective = cut + (numberIn(row, "DCW") ?? 0);
  return effective <= corners ? [wrong("CUTWIDTH", cut, { min: corners - (numberIn(row, "DCW") ?? 0) })] : [];
}

function angles(row: ToolRow): Issue[] {
  const found: Issue[] = [];
  for (const column of ["T-ANGLE", "P-ANGLE"] as const) {
    const value = numberIn(row, column);
    if (isEmpty(row, column)) continue;
    if (value === null || value < 0 || value >= 180) found.push(wrong(column, value, { min: 0, max: 179.999 }));
  }
  const setting = numberIn(row, "T-ANGLE");
  const point = numberIn(row, "P-ANGLE");
  if (row.TYPE === "THREAD" && found.length === 0 && point !== null && point < LEAST_POINT)
    found.push(wrong("P-ANGLE", point, { min: LEAST_POINT }));
  const straight = row.TYPE === "ROUGH" || row.TYPE === "FINISH";
  if (straight && found.length === 0 && setting !== null && point !== null && setting + point >= 180)
    found.push(wrong("P-ANGLE", point, { max: 180 - setting }));
  return found;
}

/** Checks the cells of a turning tool; every finding names its column. Nothing found means the insert can be drawn. */
export function checkTool(row: ToolRow): Issue[] {
  const found = [...tip(row), ...width(row), ...angles(row)];
  if (!TOOL_TYPES.some((type) => type === row.TYPE)) found.unshift(wrong("TYPE", null));
  const edge = numberIn(row, "CUTLENGTH");
  if (!isEmpty(row, "CUTLENGTH") && (edge === null || edge < 0)) found.push(wrong("CUTLENGTH", edge, { min: 0 }));
  return found;
}
