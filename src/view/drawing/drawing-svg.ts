import { textWidth } from "../dimensions/labels.ts";
import { FIGURES, NEXT, nominalWidth, SMALL, STACKED, widthOf, type PrintText } from "./paper.ts";
import { onPaperGrid as n } from "../dimensions/strokes.ts";
import { escapedText } from "../markup.ts";
import type { PartDrawing } from "./part-drawing.ts";

/** A fact of a title block, with its label. */
export interface TitleCell {
  readonly label: string;
  readonly text: string;
}

/** The title block under a drawing. */
export interface SheetTitle {
  readonly name: TitleCell;
  readonly facts: readonly TitleCell[];
  readonly notes: readonly string[];
}

/** Letter sizes of labels and notes, and of the name, mm on paper; facts are as large as figures. */
const LABEL = 2.4,
  NAME = 4.2;
/** Height of a row of the title block and of a line of notes; air in a cell; edge of the paper round the frame, mm. */
const ROW = 9,
  LINE = 4,
  PAD = 2,
  EDGE = 10;

const needs = ({ label, text }: TitleCell, size: number) =>
  Math.max(textWidth(label, LABEL), textWidth(text, size)) + PAD + PAD;

/** Items in consecutive rows, none wider than the room; each row has at least one item. */
function inRows<T>(all: readonly T[], wide: (each: T) => number, room: number): T[][] {
  const rows: T[][] = [];
  let taken = Infinity;
  for (const each of all) {
    const own = wide(each);
    if (taken + own > room) {
      rows.push([]);
      taken = 0;
    }
    rows.at(-1)?.push(each);
    taken += own;
  }
  return rows;
}

interface PlacedCell {
  readonly cell: TitleCell;
  readonly size: number;
  readonly x: number;
  readonly y: number;
  readonly width: number;
}

/** A title block: its cells in rows of the whole width, the name before all, and its notes as lines; height in mm. */
export function titleBlock(
  { name, facts, notes }: SheetTitle,
  width: number,
): { readonly cells: readonly PlacedCell[]; readonly lines: readonly string[]; readonly height: number } {
  const sized = [{ cell: name, size: NAME }, ...facts.map((cell) => ({ cell, size: FIGURES }))];
  const rows = inRows(sized, ({ cell, size }) => Math.min(width, needs(cell, size)), width);
  const cells = rows.flatMap((row, i) => {
    const free = width - row.reduce((sum, { cell, size }) => sum + Math.min(width, needs(cell, size)), 0);
    let x = 0;
    // The name takes the remaining width; in a row without it all cells share it.
    return row.map(({ cell, size }): PlacedCell => {
      const extra = i > 0 ? free / row.length : cell === name ? free : 0,
        own = Math.min(width, needs(cell, size)) + extra;
      const placed = {
        cell,
        size: Math.min(size, (size * (width - PAD - PAD)) / textWidth(cell.text, size)),
        x,
        y: i * ROW,
        width: own,
      };
      x += own;
      return placed;
    });
  });
  const between = textWidth(" · ", LABEL);
  const lines = inRows(notes, (note) => textWidth(note, LABEL) + between, width - PAD).map((line) => line.join(" · "));
  return { cells, lines, height: rows.length * ROW + lines.length * LINE + 1 };
}

const STYLE = [
  "path{fill:none;stroke:#000;stroke-linejoin:round;stroke-linecap:round}",
  ".outline{stroke-width:.5}.edge{stroke-width:.35}.axis{stroke-width:.18;stroke-dasharray:6 1 1 1;stroke-linecap:butt}",
  ".thin,.break{stroke-width:.15}.origin{stroke-width:.15;fill:#fff}.mark{stroke-width:.22}.arrow{fill:#000;stroke:none}",
  ".section{fill:url(#hatch);fill-rule:evenodd;stroke:none}.hatch{stroke-width:.13}.frame{stroke-width:.6}.cell{stroke-width:.2}",
  "text{font-family:'JetBrains Mono','DejaVu Sans Mono',Consolas,monospace;fill:#000;dominant-baseline:central}",
  ".figure text{stroke:#fff;stroke-width:.8;paint-order:stroke;stroke-linejoin:round}",
].join("");

const textAt = (text: string, x: number, y: number, size: number) =>
  `<text x="${n(x)}" y="${n(y)}" font-size="${n(size)}">${escapedText(text)}</text>`;

function written(text: PrintText): string {
  const {
      at: { x, y },
      turned,
    } = text,
    start = x - widthOf(text) / 2,
    next = start + nominalWidth(text) + NEXT,
    small = FIGURES * SMALL;
  return (
    `<g class="figure"${turned ? ` transform="rotate(-90 ${n(x)} ${n(y)})"` : ""}>${textAt(text.text, start, y, FIGURES)}` +
    (text.upper === undefined ? "" : textAt(text.upper, next, y - STACKED, small)) +
    `${text.lower === undefined ? "" : textAt(text.lower, next, y + STACKED, small)}</g>`
  );
}

/**
 * A drawing on its sheet as a self-contained file: one unit is a millimetre, black on white; `frame` is the inside of
 * its frame, mm.
 */
export function drawingSvg(
  print: PartDrawing,
  title: SheetTitle,
  frame: { readonly width: number; readonly height: number },
): string {
  const { width, height } = frame,
    block = titleBlock(title, width),
    top = height - block.height;
  const cells = block.cells.flatMap(({ cell: { label, text }, size, x, y, width: wide }) => [
    `<path class="cell" d="M${n(x)} ${n(top + y)}h${n(wide)}v${ROW}h${n(-wide)}z"/>`,
    textAt(label, x + PAD, top + y + 2.6, LABEL),
    textAt(text, x + PAD, top + y + 6.2, size),
  ]);
  const foot = height - block.lines.length * LINE;
  const [wide, tall] = [n(width + EDGE + EDGE), n(height + EDGE + EDGE)];
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${wide}mm" height="${tall}mm" viewBox="${-EDGE} ${-EDGE} ${wide} ${tall}">`,
    ` <title>${escapedText(title.name.text)}</title>`,
    ` <style>${STYLE}</style>`,
    ` <pattern id="hatch" width="1.8" height="1.8" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">` +
      `<path class="hatch" d="M0 0V1.8"/></pattern>`,
    ` <rect x="${-EDGE}" y="${-EDGE}" width="${wide}" height="${tall}" fill="#fff"/>`,
    ` <path class="frame" d="M0 0H${n(width)}V${n(height)}H0z"/>`,
    ` <g transform="translate(${n((width - print.width) / 2)} ${n((top - print.height) / 2)})">`,
    ...print.shapes.filter(({ d }) => d !== "").map(({ role, d }) => `  <path class="${role}" d="${d}"/>`),
    ...print.texts.map((text) => `  ${written(text)}`),
    " </g>",
    ...cells.map((line) => ` ${line}`),
    ...block.lines.map((line, i) => ` ${textAt(line, PAD, foot + (i + 0.5) * LINE - 0.4, LABEL)}`),
    "</svg>",
    "",
  ].join("\n");
}
