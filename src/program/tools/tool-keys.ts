import { HOLDER_CELLS, isToolType, LIMIT_CELLS, MILL_TABLE, POINT_LENGTH, TOOL_COLUMNS } from "./tool-columns.ts";

/** A key of a tools file that means nothing; `at` is its place in the file, `nearest` the known key it may stand for. */
export interface UnknownKey {
  readonly at: string;
  readonly key: string;
  readonly nearest: string | null;
}

const TURNING_KEYS: readonly string[] = [...TOOL_COLUMNS, ...LIMIT_CELLS, "holder"];
const MILL_KEYS: readonly string[] = ["T", "NAME", "TYPE", ...MILL_TABLE, POINT_LENGTH];

const isRecord = (value: unknown): value is Readonly<Record<string, unknown>> =>
  typeof value === "object" && value !== null && !Array.isArray(value);

/** Whether a row of a tools file is a milling tool or a drill: it has a radius R and no turning type. */
export const isMillRow = (row: Readonly<Record<string, unknown>>): boolean =>
  "R" in row && !isToolType(String(row["TYPE"]));

/** Number of letters to put in, take out, change or swap with the next one to make one word of another. */
function editsBetween(a: string, b: string): number {
  const rows = [Array.from({ length: b.length + 1 }, (_, j) => j)];
  const at = (i: number, j: number) => rows[i]?.[j] ?? 0;
  for (let i = 1; i <= a.length; i++) {
    rows.push([i]);
    for (let j = 1; j <= b.length; j++) {
      const change = at(i - 1, j - 1) + (a[i - 1] === b[j - 1] ? 0 : 1);
      const isSwap = i > 1 && j > 1 && a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1];
      rows[i]?.push(Math.min(change, at(i - 1, j) + 1, at(i, j - 1) + 1, isSwap ? at(i - 2, j - 2) + 1 : Infinity));
    }
  }
  return at(a.length, b.length);
}

const LONGEST = 40;

/** The known word that an unknown one is nearest to; null when none is near. */
export function nearestWord(word: string, known: readonly string[]): string | null {
  if (word.length > LONGEST) return null;
  const plain = (text: string) => text.toUpperCase().replace(/[^A-Z0-9]/g, "");
  const rated = known.map((each) => [each, editsBetween(plain(word), plain(each))] as const);
  const [best] = rated.toSorted((a, b) => a[1] - b[1]);
  return best && best[1] <= Math.floor(best[0].length / 3) ? best[0] : null;
}

const unknownIn = (record: Readonly<Record<string, unknown>>, known: readonly string[], at: string): UnknownKey[] =>
  Object.keys(record)
    .filter((key) => !known.includes(key))
    .map((key) => ({ at, key, nearest: nearestWord(key, known) }));

/** Keys of a tools file (JSON) that nothing reads, in the order of the file. */
export function unknownToolKeys(json: unknown): readonly UnknownKey[] {
  if (!isRecord(json)) return [];
  const { tools } = json;
  const rows: readonly unknown[] = Array.isArray(tools) ? tools : [];
  return [
    ...unknownIn(json, ["tools"], ""),
    ...rows.flatMap((row, i) => {
      if (!isRecord(row)) return [];
      const { holder } = row;
      return [
        ...unknownIn(row, isMillRow(row) ? MILL_KEYS : TURNING_KEYS, `tools.${i}`),
        ...(isRecord(holder) ? unknownIn(holder, HOLDER_CELLS, `tools.${i}.holder`) : []),
      ];
    }),
  ];
}
