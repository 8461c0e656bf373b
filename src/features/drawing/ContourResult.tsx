import { useMemo, useRef, type KeyboardEvent } from "react";
import type { RowsReading } from "../../program/job/contour-rows.ts";
import type { ContourRow } from "../../program/job/job.ts";
import { formatNumber } from "../../i18n/number.ts";
import type { Language } from "../../i18n/languages.ts";
import { CameraAxes } from "../../app/pictures/lathe/Axes.tsx";
import { useSize } from "../../app/pictures/help/use-size.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { contourDrawing } from "../../view/help/contour-drawing.ts";
import { px } from "../../view/help/marks.ts";

interface Props {
  readonly rows: readonly ContourRow[];
  readonly reading: RowsReading;
  readonly active: number | null;
  readonly onActive: (row: number | null) => void;
}

/** Most elements that are drawn and listed here; the large picture shows all. */
const MOST = 400;
/** Scales at the left and lower edge of the small picture. */
const MARGIN = { left: 54, right: 22, top: 18, bottom: 32 };
const NO_FAULTS: ReadonlySet<number> = new Set();

/** Dimensions of an element as the table has them. */
export function rowText(row: ContourRow, end: { readonly x: number; readonly z: number } | null, language: Language) {
  const write = (n: number) => formatNumber(language, n, 3);
  const place = end ? `⌀ ${write(end.x)}  Z ${write(end.z)}` : "";
  const size = row.r === "" ? "" : `  ${row.kind === "CHF" ? "CHF" : "R"} ${write(Math.abs(Number(row.r)))}`;
  return `${place}${size}`.trim();
}

/** The contour as the table will show it: elements with ⌀ and Z, and as a picture with its scales. */
export function ContourResult({ rows, reading, active, onActive }: Props) {
  const t = useTexts("drawing-import"),
    {
      contour: { head, kinds, clockwise, counterClockwise },
    } = useTexts(),
    language = useSettings((s) => s.language);
  const box = useRef<HTMLDivElement>(null),
    size = useSize(box, { width: 320, height: 180 });
  const xUp = !useSettings((s) => s.xDown);
  const picture = useMemo(
    () =>
      contourDrawing({
        contour: rows.length > MOST ? [] : reading.contour.segments,
        rowOfSegment: reading.rowOfSegment,
        ends: rows.length > MOST ? [] : reading.rows.map((r) => r.end),
        faulty: NO_FAULTS,
        active,
        size,
        margin: MARGIN,
        xUp,
      }),
    [rows, reading, active, size, xUp],
  );
  const move = (e: KeyboardEvent<HTMLElement>) => {
    const by = { ArrowDown: 1, ArrowUp: -1, Home: -Infinity, End: Infinity }[e.key];
    if (by === undefined) return;
    e.preventDefault();
    const next = Math.min(rows.length - 1, MOST - 1, Math.max(0, (active ?? (by > 0 ? -1 : rows.length)) + by));
    onActive(next);
    e.currentTarget.querySelector(`[data-row="${next}"]`)?.scrollIntoView({ block: "nearest" });
  };
  return (
    <section className="drawing-result" aria-label={t.result}>
      <h3>{t.result}</h3>
      <div className="drawing-preview" ref={box} aria-hidden="true" hidden={rows.length > MOST}>
        <svg viewBox={`0 0 ${size.width} ${size.height}`}>
          <path className="axis" d={picture.axis} />
          {picture.elements.map((e) => (
            <path key={e.row} className={e.row === active ? "active" : "contour"} d={e.d} />
          ))}
          {picture.points.map((p) => (
            <g key={p.row} className={p.row === active ? "point active" : "point"}>
              <circle cx={px(p.place.x)} cy={px(p.place.y)} r={p.row === 0 ? 4 : 2.5} />
              {p.label && (
                <text x={px(p.label.x)} y={px(p.label.y)}>
                  {p.row + 1}
                </text>
              )}
            </g>
          ))}
          <CameraAxes camera={picture.camera} size={size} part="scales" />
        </svg>
      </div>
      <div className="drawing-head small soft" aria-hidden="true">
        <span>{head.number}</span>
        <span>{head.element}</span>
        <span>{head.x}</span>
        <span>{head.z}</span>
        <span>R</span>
      </div>
      <ol
        className="drawing-rows"
        role="listbox"
        tabIndex={0}
        aria-label={`${t.result}. ${t.resultHow}`}
        {...(active !== null && { "aria-activedescendant": `drawing-row-${active}` })}
        onKeyDown={move}
        onFocus={() => active === null && onActive(0)}
        onPointerLeave={() => onActive(null)}
      >
        {rows.slice(0, MOST).map((row, i) => {
          const end = reading.rows[i]?.end ?? null;
          const turn = row.kind === "CR" ? ` ${row.turn === "cw" ? clockwise : counterClockwise}` : "";
          return (
            <li
              key={row.id}
              id={`drawing-row-${i}`}
              data-row={i}
              role="option"
              aria-selected={i === active}
              aria-label={`${i + 1} ${kinds[row.kind]} ${rowText(row, end, language)}${turn}`}
              onPointerEnter={() => onActive(i)}
              onClick={() => onActive(i)}
            >
              <span className="number soft">{i + 1}</span>
              <b className="number">{row.kind}</b>
              <span className="number">{end ? formatNumber(language, end.x, 3) : ""}</span>
              <span className="number">{end ? formatNumber(language, end.z, 3) : ""}</span>
              <span className="number">
                {row.r === "" ? "" : formatNumber(language, Number(row.r), 3)}
                {row.kind === "CR" && (row.turn === "cw" ? " DR−" : " DR+")}
              </span>
            </li>
          );
        })}
      </ol>
      {rows.length > MOST && <p className="small soft">{t.moreRows(rows.length - MOST)}</p>}
    </section>
  );
}
