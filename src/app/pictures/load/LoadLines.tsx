import { memo } from "react";
import type { Run } from "../../../program/state/run-types.ts";
import { useLoadDrawing } from "./use-drawing.ts";
import type { LoadQuantity } from "./use-load.ts";
import "./load.css";

export interface LoadLinesProps {
  readonly of: LoadQuantity;
  readonly run: Run;
  /** The visible moves. */
  readonly shown: (step: number) => boolean;
}

/** CSS class of a line: its tone, or without a value. */
export const toneClass = (tone: number | null) => (tone === null ? "load-untold" : `load-tone-${tone}`);

/** The colour map in part space: one path per class over a contrasting rim, however long the program. */
export const LoadLines = memo(function LoadLines({ of, run, shown }: LoadLinesProps) {
  const drawing = useLoadDrawing(run, of, shown);
  return (
    drawing && (
      <g className="load-lines">
        {drawing.lines.map(({ tone, limited, d }) => (
          <g key={`${tone} ${limited}`} className={toneClass(tone)}>
            <path className="load-rim" d={d} />
            <path className={limited ? "load-line load-limited" : "load-line"} d={d} />
          </g>
        ))}
      </g>
    )
  );
});
