import { useId, useRef } from "react";
import { boxAround } from "../../kernel/area/box.ts";
import { part as space, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import { axial, radius } from "../../kernel/units.ts";
import { CHORD } from "../../kernel/tolerance.ts";
import type { Clamped } from "../../kernel/area/clamping.ts";
import { matrix, toScreen, type Camera, type Size } from "../../view/camera.ts";
import { WORKPIECE_ZERO } from "../../view/datum.ts";
import { CameraAxes } from "../../app/pictures/lathe/Axes.tsx";
import { ZeroMark } from "../../app/pictures/lathe/Marks.tsx";
import { useSize } from "../../app/pictures/help/use-size.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import type { PlanTexts } from "../../i18n/en/plan.ts";

interface Props {
  readonly t: PlanTexts;
  /** Accessible name: what is shown. */
  readonly name: string;
  /** Elements of the finished part, both sides. */
  readonly part: readonly Segment[];
  readonly blank: readonly Ring[];
  readonly clamping: Clamped | null;
  /** The stock after the shown step, and before it. */
  readonly stock: readonly Ring[];
  readonly before: readonly Ring[] | null;
  readonly residue: readonly Ring[];
  /** Elements to point out. */
  readonly chosen: readonly Segment[];
  /** An outdated plan, or one that is still being searched. */
  readonly isDimmed: boolean;
}

/** Pixels around the drawing: scales at the left and the lower edge. */
const MARGIN = { left: 58, right: 20, top: 16, bottom: 34 };

const pathOf = (rings: readonly Ring[]): string =>
  rings.map((ring) => `M${ring.map(({ z, r }) => `${z} ${r}`).join("L")}Z`).join("");
const lineOf = (segments: readonly Segment[]): string =>
  segments
    .map(
      (s) =>
        `M${space
          .flattened(s, CHORD)
          .map(({ z, r }) => `${z} ${r}`)
          .join("L")}`,
    )
    .join("");

/** A camera that shows blank and part, both halves. */
function cameraFor(rings: readonly Ring[], size: Size, xUp: boolean): Camera {
  const { left, right, high } = boxAround(rings);
  const [width, height] = [size.width - MARGIN.left - MARGIN.right, size.height - MARGIN.top - MARGIN.bottom];
  const scale = Math.max(0.05, Math.min(width / Math.max(right - left, 1), height / Math.max(2 * high, 1)));
  return {
    scale,
    xUp,
    zero: {
      x: MARGIN.left + (width - (left + right) * scale) / 2,
      y: MARGIN.top + height / 2,
    },
  };
}

/** Stock and finished part of a plan as a section on both sides of the axis. */
export function PlanPicture({ t, name, part, blank, clamping, stock, before, residue, chosen, isDimmed }: Props) {
  const box = useRef<HTMLDivElement>(null),
    id = useId();
  const size = useSize(box, { width: 640, height: 400 });
  const xUp = !useSettings((s) => s.xDown);
  const all = [...blank, ...part.map((s) => space.flattened(s, CHORD))];
  if (all.length === 0) return <div className="plan-picture" ref={box} />;
  const camera = cameraFor(all, size, xUp);
  const [a, b, c, d, e, f] = matrix(camera);
  const solids = (
    <>
      {clamping?.bodies.map((body, i) => (
        <path key={i} className="plan-body" d={pathOf(body.rings)} />
      ))}
      {blank.length > 0 && <path className="plan-blank" d={pathOf(blank)} />}
      {before && <path className="plan-cut" d={pathOf(before)} style={{ fill: `url(#${id}cut)` }} />}
      <path className="plan-ground" d={pathOf(stock)} />
      <path className="plan-stock" d={pathOf(stock)} style={{ fill: `url(#${id}steel)` }} />
      {residue.length > 0 && (
        <path className="plan-left-over" d={pathOf(residue)} style={{ fill: `url(#${id}left)` }} />
      )}
      <path className="plan-part" d={lineOf(part)} />
      {chosen.length > 0 && <path className="plan-chosen" d={lineOf(chosen)} />}
    </>
  );
  // A pattern is drawn in the units of the part: a stroke of one pixel is a seventh of its pitch.
  const pitch = 7 / camera.scale;
  const hatch = (of: string, turn: number, className: string) => (
    <pattern
      id={`${id}${of}`}
      width={pitch}
      height={pitch}
      patternUnits="userSpaceOnUse"
      patternTransform={`rotate(${turn})`}
    >
      <rect className={`${className}-ground`} width={pitch} height={pitch} />
      <path className={className} strokeWidth={pitch / 7} d={`M0 0V${pitch}`} />
    </pattern>
  );
  const { legend } = t.picture;
  return (
    <figure className={`plan-picture${isDimmed ? " dimmed" : ""}`}>
      <div className="plan-sheet" ref={box}>
        <svg role="img" aria-label={name} viewBox={`0 0 ${size.width} ${size.height}`}>
          <defs>
            {hatch("steel", -45, "plan-hatch-steel")}
            {hatch("cut", 45, "plan-hatch-cut")}
            {hatch("left", 45, "plan-hatch-left")}
          </defs>
          <g className="plan-solids">
            <g transform={`matrix(${[a, b, c, d, e, f].join(" ")})`}>{solids}</g>
            <g transform={`matrix(${[a, b, c, -d, e, f].join(" ")})`} aria-hidden="true">
              {solids}
            </g>
          </g>
          <path
            className="plan-axis"
            d={`M${MARGIN.left - 12} ${toScreen(camera, { z: axial(0), r: radius(0) }).y}H${size.width - 8}`}
          />
          <ZeroMark at={toScreen(camera, WORKPIECE_ZERO)} />
          <CameraAxes camera={camera} size={size} part="scales" />
        </svg>
      </div>
      <figcaption className="plan-legend small" aria-hidden="true">
        <span className="plan-key-part">{legend.part}</span>
        <span className="plan-key-stock">{legend.stock}</span>
        {before && <span className="plan-key-cut">{legend.cut}</span>}
        {residue.length > 0 && <span className="plan-key-left">{legend.left}</span>}
      </figcaption>
    </figure>
  );
}
