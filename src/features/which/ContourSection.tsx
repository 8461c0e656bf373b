import { useState } from "react";
import type { WhichTexts } from "../../i18n/which-text.ts";
import { boxOf } from "../../kernel/area/box.ts";
import { part, type Segment } from "../../kernel/geometry/point.ts";
import { CHORD } from "../../kernel/tolerance.ts";

interface Props {
  readonly words: WhichTexts;
  readonly contour: readonly Segment[];
  readonly first: number;
  readonly last: number;
  readonly onPick: (first: number, last: number) => void;
}

/** Margin around the drawing, as a share of its larger side. */
const MARGIN = 0.06;

/** The finished contour of a work, to select two elements in; the same by two lists. */
export function ContourSection({ words: { stretch: t }, contour, first, last, onPick }: Props) {
  const [from, begin] = useState<number | null>(null);
  const lines = contour.map((s) => part.flattened(s, CHORD));
  const { left, right, low, high } = boxOf(lines.flat());
  const margin = MARGIN * Math.max(right - left, high - low, 1);
  const path = (i: number) => (lines[i] ?? []).map((p, j) => `${j === 0 ? "M" : "L"}${p.z} ${-p.r}`).join("");
  const view = `${left - margin} ${-high - margin} ${right - left + margin + margin} ${high - low + margin + margin}`;
  const point = (i: number) => {
    onPick(from === null ? i : Math.min(from, i), from === null ? i : Math.max(from, i));
    begin(from === null ? i : null);
  };
  const list = (label: string, value: number, choose: (i: number) => void) => (
    <label>
      <span>{label}</span>
      <select className="select" value={value} onChange={(e) => choose(Number(e.target.value))}>
        {contour.map((_, i) => (
          <option key={i} value={i}>
            {i + 1}
          </option>
        ))}
      </select>
    </label>
  );
  return (
    <fieldset className="which-stretch">
      <legend>{t.title}</legend>
      <p className="small soft">{t.about}</p>
      <svg
        viewBox={view}
        role="img"
        aria-label={t.picture(first + 1, last + 1, contour.length)}
        preserveAspectRatio="xMidYMid meet"
      >
        {contour.map((_, i) => (
          <g key={i} className={i >= first && i <= last ? "which-meant" : undefined} onClick={() => point(i)}>
            <path className="which-target" d={path(i)} />
            <path className="which-line" d={path(i)} />
          </g>
        ))}
      </svg>
      <div className="which-ends">
        {list(t.first, first, (i) => onPick(i, Math.max(i, last)))}
        {list(t.last, last, (i) => onPick(Math.min(first, i), i))}
      </div>
    </fieldset>
  );
}
