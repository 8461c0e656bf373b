import type { ReactNode } from "react";
import { useTexts } from "../../base/settings/use-texts.ts";
import { pageLength } from "../../base/unit.ts";

/** One line of the legend: a drawn sign and its meaning. */
export function LegendSign({
  text,
  height = 8,
  children,
}: {
  readonly text: string;
  readonly height?: number;
  readonly children: ReactNode;
}) {
  return (
    <li>
      <svg width={pageLength(26)} height={pageLength(height)} viewBox={`0 0 26 ${height}`} aria-hidden="true">
        {children}
      </svg>
      {text}
    </li>
  );
}

/** Meaning of lines, by the class that draws them, and of further signs. `notes`: below them. */
export function Legend({
  lines,
  children,
  notes,
}: {
  readonly lines: readonly (readonly [className: string, text: string])[];
  readonly children?: ReactNode;
  readonly notes?: ReactNode;
}) {
  return (
    <div className="lathe-told">
      <ul className="lathe-legend small" aria-label={useTexts().lathe.legend}>
        {lines.map(([className, text]) => (
          <LegendSign key={className} text={text}>
            <path className={className} d="M1 4H25" />
          </LegendSign>
        ))}
        {children}
      </ul>
      {notes}
    </div>
  );
}
