import { part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import type { ContourChoice } from "../../program/drawing/drawing.ts";
import { ZeroMark } from "../../app/pictures/lathe/Marks.tsx";
import { toScreen, type Camera, type Place, type Size } from "../../view/camera.ts";
import { polyline, px, segmentPath } from "../../view/help/marks.ts";
import { fromAxis } from "../../program/drawing/on-drawing.ts";

/** A note with its number in the list and its place on the drawing. */
export interface NoteMark {
  readonly number: number;
  readonly at: Pt;
  readonly severity: "error" | "warning" | "info";
}

/** What lies over the drawing. */
export interface SheetMarks {
  readonly choice: ContourChoice;
  /** Segments of the contour on the drawing, with the index of their row. */
  readonly segments: readonly Segment[];
  readonly rowOfSegment: readonly number[];
  readonly activeRow: number | null;
  /** Dimensions of the active element. */
  readonly activeText: string | null;
  readonly notes: readonly NoteMark[];
  readonly activeNote: number | null;
  /** Letters of the axis and its proposal. */
  readonly words: { readonly axis: string; readonly picture: string };
}

/** Ends of elements are drawn for contours up to this length. */
const MOST_ENDS = 400;

/** Direction of travel on the screen, degrees clockwise from the right. */
const headingOf = (s: Segment, camera: Camera): number => {
  const d = part.direction(s, s.from),
    up = camera.xUp ? -1 : 1;
  return (Math.atan2(up * d.r, d.z) * 180) / Math.PI;
};

/** A line across the whole picture through a place, along or across the axis. */
const across = (camera: Camera, size: Size, isLevel: boolean, p: Pt): string => {
  const { x, y } = toScreen(camera, p);
  return isLevel
    ? polyline([
        { x: 0, y },
        { x: size.width, y },
      ])
    : polyline([
        { x, y: 0 },
        { x, y: size.height },
      ]);
};

/** Keeps a label inside the picture. */
const inside = ({ x, y }: Place, size: Size): Place => ({
  x: Math.min(Math.max(x, 8), size.width - 8),
  y: Math.min(Math.max(y, 16), size.height - 10),
});

/** Axis, zero point and contour of the choice, and the numbered notes, over the drawing. */
export function SheetOverlay({
  choice,
  segments,
  rowOfSegment,
  activeRow,
  activeText,
  notes,
  activeNote,
  words,
  camera,
  size,
  hovered,
}: SheetMarks & { readonly camera: Camera; readonly size: Size; readonly hovered: Segment | null }) {
  const origin = fromAxis(choice, choice.zero, choice.axisAt),
    zero = toScreen(camera, origin),
    isLevel = choice.axis === "x";
  const [first] = segments;
  const start = first && toScreen(camera, first.from);
  const active = activeRow === null ? [] : segments.filter((_, i) => rowOfSegment[i] === activeRow);
  const end = active.at(-1)?.to,
    label = end && inside(toScreen(camera, end), size);
  const sign = choice.mirrored ? -1 : 1,
    side = choice.half === "upper" ? 1 : -1;
  const zWay = isLevel ? { x: sign, y: 0 } : { x: 0, y: -sign },
    xWay = isLevel ? { x: 0, y: -side } : { x: side, y: 0 };
  const axisLabel = inside(isLevel ? { x: 10, y: zero.y - 6 } : { x: zero.x + 6, y: size.height - 12 }, size);
  return (
    <svg role="img" aria-label={words.picture} viewBox={`0 0 ${size.width} ${size.height}`}>
      {hovered && <path className="hovered" d={segmentPath([hovered], camera)} />}
      <path className="axis" d={across(camera, size, isLevel, origin)} />
      <path className="zero-line" d={across(camera, size, !isLevel, origin)} />
      <text className="axis-name" x={px(axisLabel.x)} y={px(axisLabel.y)}>
        {words.axis}
      </text>
      <path className="contour" d={segmentPath(segments, camera)} />
      {segments.length <= MOST_ENDS &&
        segments.map(({ to }, i) => {
          const p = toScreen(camera, to);
          return <circle key={i} className="end" cx={px(p.x)} cy={px(p.y)} r={2.5} />;
        })}
      {active.length > 0 && <path className="active" d={segmentPath(active, camera)} />}
      <g className="ways" transform={`translate(${px(zero.x)} ${px(zero.y)})`}>
        {(["Z", "X"] as const).map((name) => {
          const { x, y } = name === "Z" ? zWay : xWay;
          return (
            <g key={name}>
              <path d={`M${x * 12} ${y * 12}L${x * 38} ${y * 38}`} />
              <path
                className="arrow"
                d="M0 0L-8 -3.5V3.5Z"
                transform={`translate(${x * 42} ${y * 42}) rotate(${(Math.atan2(y, x) * 180) / Math.PI})`}
              />
              <text x={x * 52} y={y * 52 + 4}>
                {name}
              </text>
            </g>
          );
        })}
      </g>
      <ZeroMark at={zero} />
      {start && first && (
        <g className="start" transform={`translate(${px(start.x)} ${px(start.y)})`}>
          <circle r={5} />
          <path className="arrow" d="M26 0L14 -5V5Z" transform={`rotate(${px(headingOf(first, camera))})`} />
        </g>
      )}
      {notes.map((note) => {
        const p = toScreen(camera, note.at);
        return (
          <g
            key={note.number}
            className={`note ${note.severity}${note.number === activeNote ? " active" : ""}`}
            transform={`translate(${px(p.x)} ${px(p.y)})`}
          >
            <circle className="ring" r={8} />
            <circle className="tag" cx={14} cy={-14} r={8} />
            <text x={14} y={-10}>
              {note.number}
            </text>
          </g>
        );
      })}
      {label && activeText !== null && (
        <text className="active-text number" x={px(label.x)} y={px(label.y - 10)}>
          {activeText}
        </text>
      )}
    </svg>
  );
}
