import type { ShapeRequest } from "../../cycles/shape-request.ts";
import type { WhichTexts } from "../../i18n/which-text.ts";
import { boxOf } from "../../kernel/area/box.ts";
import { at, part, type Pt } from "../../kernel/geometry/point.ts";
import { CHORD } from "../../kernel/tolerance.ts";
import { ringOf } from "../../program/job/requested-job.ts";
import { blankFor, requestedArea, requestedContour } from "../../program/job/requested-shape.ts";
import { toRadius } from "../../kernel/units.ts";

/** Margin around the drawing, as a share of its larger side. */
const MARGIN = 0.06;

const path = (points: readonly Pt[]) => points.map(({ z, r }, i) => `${i === 0 ? "M" : "L"}${z} ${-r}`).join("");

/** The requested contour in its blank, and the material that has to go. */
export function ShapeSketch({ words, wanted }: { readonly words: WhichTexts; readonly wanted: ShapeRequest }) {
  const blank = ringOf(blankFor(wanted, null));
  const r = toRadius(wanted.from.diameter);
  const contour =
    wanted.shape === "thread"
      ? [at(wanted.from.z, r), at(wanted.to.z, r)]
      : part.flattenedChain(requestedContour(wanted), CHORD);
  const area = requestedArea(wanted);
  const { left, right, high } = boxOf([...blank, ...contour]);
  const margin = MARGIN * Math.max(right - left, high, 1);
  return (
    <svg
      className="which-sketch"
      viewBox={`${left - margin} ${-high - margin} ${right - left + 2 * margin} ${high + 2 * margin}`}
      role="img"
      aria-label={words.sketch}
      preserveAspectRatio="xMidYMid meet"
    >
      <path className="which-blank" d={`${path(blank)}Z`} />
      {area && <path className="which-removed" d={`${path(area)}Z`} />}
      <path className="which-axis" d={`M${left - margin} 0H${right + margin}`} />
      <path className="which-wanted" d={path(contour)} />
    </svg>
  );
}
