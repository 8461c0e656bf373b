import type { CSSProperties } from "react";
import { PaperDrawing } from "../../../app/pictures/paper/PaperDrawing.tsx";
import type { PartDrawing } from "../../../view/drawing/part-drawing.ts";

/** The picture of a workshop drawing; `list`: id of the element with the sizes as a list. */
export function DrawnPrint({
  print,
  name,
  list,
  style,
}: {
  readonly print: PartDrawing;
  readonly name: string;
  readonly list: string;
  readonly style?: CSSProperties;
}) {
  return (
    <svg
      role="img"
      aria-label={name}
      aria-describedby={list}
      viewBox={`0 0 ${print.width} ${print.height}`}
      style={style}
    >
      <PaperDrawing {...print} />
    </svg>
  );
}
