import type { HelpDrawing } from "./picture.ts";
import { escapedText } from "../markup.ts";
import { px, type Mark } from "./marks.ts";

/** Classes of a mark: its role, and whether it is active. */
export const classOf = (m: Mark): string => {
  return m.active ? `${roleOf(m)} active` : roleOf(m);
};

function roleOf(m: Mark): string {
  switch (m.kind) {
    case "area":
      return `fill-${m.fill}`;
    case "line":
      return `line-${m.line}`;
    case "text":
      return `text-${m.role}`;
    case "detail":
      return "lens";
  }
}

function element(m: Mark, indent: string): string {
  const own = `class="${classOf(m)}"${m.q ? ` data-q="${m.q}"` : ""}`;
  switch (m.kind) {
    case "area":
    case "line":
      return `${indent}<path ${own} d="${m.d}"/>`;
    case "text": {
      const turn = m.turn === 0 ? "" : ` transform="rotate(${m.turn} ${px(m.place.x)} ${px(m.place.y)})"`;
      const line = m.underlined ? ` text-decoration="underline"` : "";
      return (
        `${indent}<text ${own} x="${px(m.place.x)}" y="${px(m.place.y)}" font-size="${m.size}"${turn}${line}>` +
        `${escapedText(m.text)}</text>`
      );
    }
    case "detail":
      return [
        `${indent}<g ${own} data-lens="${px(m.centre.x)} ${px(m.centre.y)} ${px(m.radius)}">`,
        ...m.marks.map((n) => element(n, `${indent}  `)),
        `${indent}</g>`,
      ].join("\n");
  }
}

/** A help picture as a text of its own, one element a line, for goldens. Colours belong to the page's style sheet. */
export const helpSvg = ({ size, marks }: HelpDrawing): string =>
  [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${px(size.width)} ${px(size.height)}">`,
    ...marks.map((m) => element(m, "  ")),
    "</svg>",
    "",
  ].join("\n");
