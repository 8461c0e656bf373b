import type { Place } from "../camera.ts";
import { mostThatFit, spread } from "../dimensions/spread.ts";
import { arrow, FIGURES, tallOf, widthOf, writtenAt, type Drawn, type PrintShape, type PrintSize } from "./paper.ts";
import { lineThrough, onPaperGrid } from "../dimensions/strokes.ts";

/** A note joined to a place of the part by a leader. */
export interface Leader {
  readonly size: PrintSize;
  /** Where it points, mm on paper. */
  readonly to: Place;
  /** A surface mark: its symbol precedes the text. */
  readonly isMark: boolean;
}

/**
 * Gap between notes, and between shafts and texts below them; room of a passing shaft; size of the surface symbol; mm
 * on paper.
 */
const GAP = 2.5,
  NEAR = 0.3,
  SHAFT = 1.2,
  SIGN = 2.1;
/** Height of a row of notes, and how far above the part the first one stands, mm on paper. */
export const ROW = 8;
const MOST_ROWS = 4;
const SHORT = 1.1;

const wide = ({ size, isMark }: Leader): number => widthOf(size) + (isMark ? 2.2 * SIGN : 0);

/** The symbol of a turned surface: a tick, closed because material is removed, with its line over the value. */
export function surfaceSign(apex: Place, width: number): string {
  const [x, y] = [apex.x, apex.y],
    half = SIGN / 2,
    high = SIGN * 0.866;
  const far = { x: x + 2 * half, y: y - 2 * high };
  return (
    lineThrough([{ x: x - half, y: y - high }, { x, y }, far, { x: far.x + width, y: far.y }]) +
    `M${onPaperGrid(x - half)} ${onPaperGrid(y - high)}H${onPaperGrid(x + half)}`
  );
}

interface Row {
  readonly leader: Leader;
  readonly row: number;
  /** X at which the leader rises between the texts below all rows; null without such texts. */
  readonly between: number | null;
  /** X at which the leader rises at each row up to its own. */
  readonly ways: readonly number[];
}

/** A text below all rows, between the leaders that pass it. */
export interface TextBelow {
  readonly at: number;
  readonly size: number;
}

/** Notes in rows, with the texts below them: `middles` are the places of those texts. */
interface LaidRows {
  readonly rows: readonly Row[];
  readonly count: number;
  readonly middles: readonly number[];
}

/** Notes in so many rows, or null if they do not fit. */
function inRows(leaders: readonly Leader[], rows: number, width: number, below: readonly TextBelow[]): LaidRows | null {
  const placed = leaders.map((leader, i) => ({
    leader,
    row: i % Math.max(1, rows),
    ways: [] as number[],
    at: leader.to.x,
    between: null as number | null,
  }));
  const middles: number[] = [];
  if (below.length > 0) {
    const all = [
      ...placed.map((p) => ({ at: p.at, size: SHAFT, take: (x: number) => void (p.at = p.between = x) })),
      ...below.map((text, i) => ({ ...text, take: (x: number) => void (middles[i] = x) })),
    ].sort((a, b) => a.at - b.at);
    const found = spread(all, 1, width - 1, NEAR);
    if (!found) return null;
    all.forEach(({ take, at }, i) => take(found[i] ?? at));
  }
  for (let row = 0; row < rows; row += 1) {
    const here = placed.filter((p) => p.row >= row).sort((a, b) => a.at - b.at);
    const middles = spread(
      here.map((p) => ({ at: p.at, size: p.row === row ? wide(p.leader) : SHAFT })),
      1,
      width - 1,
      GAP,
    );
    if (!middles) return null;
    here.forEach((p, i) => {
      p.at = middles[i] ?? p.at;
      p.ways.push(p.at);
    });
  }
  return { rows: placed, count: rows, middles };
}

/** Notes, the most important first, in as few rows as they need; notes that are left out have no room at all. */
export function leaderRows(leaders: readonly Leader[], width: number, below: readonly TextBelow[]): LaidRows {
  const laid = mostThatFit(leaders, (some) => {
    const sorted = some.toSorted((a, b) => a.to.x - b.to.x);
    for (let count = 1; count <= MOST_ROWS; count += 1) {
      const found = inRows(sorted, count, width, below);
      if (found) return found;
    }
    return null;
  });
  return laid ?? inRows([], 0, width, below) ?? { rows: [], count: 0, middles: [] };
}

/** Draws notes in rows above a level, each joined to its place; `band`: top and bottom of the texts below them. */
export function drawnLeaders(
  rows: readonly Row[],
  bottom: number,
  band: readonly [number, number],
): Pick<Drawn, "shapes" | "texts"> & { readonly lines: readonly (readonly Place[])[] } {
  const shapes: PrintShape[] = [];
  const lines: (readonly Place[])[] = [];
  const texts: Drawn["texts"][number][] = [];
  for (const { leader, row, between, ways } of rows) {
    const { to, size, isMark } = leader,
      level = (k: number) => bottom - k * ROW;
    const shelf = ways.at(-1) ?? to.x,
      y = level(row),
      width = wide(leader);
    // Through each row below its own the leader rises straight, and turns between them.
    const knees = ways.slice(0, row).flatMap((x, k) => [
      { x, y: level(k) + SHORT },
      { x, y: level(k) - tallOf(size) - SHORT },
    ]);
    const end = { x: shelf, y };
    const passes =
      between === null
        ? []
        : [
            { x: between, y: band[1] },
            { x: between, y: band[0] },
          ];
    const line = [to, ...passes, ...knees, end];
    lines.push(line);
    const first = line[1] ?? end;
    shapes.push({
      role: "thin",
      d:
        lineThrough(line) +
        lineThrough([
          { x: shelf - width / 2, y },
          { x: shelf + width / 2, y },
        ]),
    });
    shapes.push({ role: "arrow", d: arrow(to, to.x - first.x, to.y - first.y) });
    if (isMark) {
      const textWide = widthOf(size),
        apex = { x: shelf - width / 2 + SIGN / 2 + 0.3, y };
      shapes.push({ role: "mark", d: surfaceSign(apex, textWide + 0.6) });
      texts.push(writtenAt(size, { x: apex.x + SIGN * 0.75 + textWide / 2 + 0.4, y: y - FIGURES / 2 - 0.2 }, false));
    } else texts.push(writtenAt(size, { x: shelf, y: y - tallOf(size) / 2 - 0.1 }, false));
  }
  return { shapes, texts, lines };
}
