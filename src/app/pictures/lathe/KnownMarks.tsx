import type { KnownOutline, KnownPosition } from "../../../cycles/known-outline.ts";
import type { PartialWork } from "../../../program/job/partial-work.ts";
import type { Lengths } from "../../../i18n/lengths.ts";
import { axial, diameter, radius, toRadius } from "../../../kernel/units.ts";
import { toScreen } from "../../../view/camera.ts";
import type { Texts } from "../../../i18n/index.ts";
import { usePlace } from "../../place/place.ts";
import { useLengths } from "../../calculation/lengths.ts";
import { SCALE_BELOW, SCALE_LEFT } from "./Axes.tsx";
import { useCamera } from "./use-camera.ts";
import type { Viewport } from "./viewport.ts";

/** Height of a text, pixels. */
const ROW = 15;
/** Layout of texts: width of one, and distance of the first row from the upper edge with its notes, pixels. */
const LARGE = { wide: 104, top: 44 },
  SMALL = { wide: 58, top: 18 };
/** A picture smaller than this shows only the numbers, pixels. */
const ROOM = { width: 480, height: 240 };

const valueText = (lengths: Lengths, { axis, value }: KnownPosition): string =>
  `${axis === "x" ? "⌀" : "Z"}${lengths.number(value)}`;
/** A typed position as a drawing writes it, with its Q: Q491 ⌀61.37. */
const positionText = (lengths: Lengths, p: KnownPosition): string => `${p.q} ${valueText(lengths, p)}`;

/** The known data of a contour, in words. */
export function knownText(
  t: Texts["lathe"],
  lengths: Lengths,
  { positions, contour, sketch, whole }: KnownOutline,
): string {
  const said = positions.map((p) => positionText(lengths, p));
  if (contour.length > 0) said.push(whole ? t.known.whole : t.known.elements(contour.length));
  else if (sketch.length > 0) said.push(t.known.sketch);
  return said.length > 0 ? t.known.soFar(said.join(", ")) : t.known.nothing;
}

/** Places each text in the first free row or column. */
function spread(places: readonly number[], apart: number): readonly number[] {
  const rows: number[][] = [];
  return places.map((place) => {
    let row = 0;
    while (rows[row]?.some((other) => Math.abs(other - place) < apart)) row += 1;
    (rows[row] ??= []).push(place);
    return row;
  });
}

/**
 * Line at the position of the open prompt, in a picture that has its path; at all positions while the values make no
 * contour.
 */
export function AskedMarks({ viewport, known }: { readonly viewport: Viewport; readonly known: PartialWork }) {
  const asked = usePlace((p) => p.prompt),
    { outline, points } = known;
  const positions = outline.whole ? outline.positions.filter(({ q }) => q === asked) : outline.positions;
  if (positions.length === 0) return null;
  return (
    <KnownMarks
      viewport={viewport}
      known={{ ...known, outline: { ...outline, positions }, points: outline.whole ? [] : points }}
    />
  );
}

/** Lines at the positions typed so far, and the corners that they make. */
export function KnownMarks({
  viewport,
  known: {
    outline: { positions },
    points,
  },
}: {
  readonly viewport: Viewport;
  readonly known: PartialWork;
}) {
  const camera = useCamera(viewport),
    { width, height } = viewport.size();
  const lengths = useLengths();
  const floor = height - SCALE_BELOW;
  const level = positions
    .filter((p) => p.axis === "x")
    .map((p) => ({
      p,
      y: toScreen(camera, { z: axial(0), r: toRadius(diameter(p.value)) }).y,
    }));
  const upright = positions
    .filter((p) => p.axis === "z")
    .map((p) => ({ p, x: toScreen(camera, { z: axial(p.value), r: radius(0) }).x }));
  const isSmall = width < ROOM.width || height < ROOM.height;
  const { wide, top } = isSmall ? SMALL : LARGE,
    text = isSmall ? valueText : positionText;
  const columns = spread(
      level.map(({ y }) => y),
      ROW,
    ),
    rows = spread(
      upright.map(({ x }) => x),
      wide,
    );
  return (
    <g className="lathe-known" aria-hidden="true">
      <path
        className="line"
        d={[
          ...level.map(({ y }) => `M${SCALE_LEFT} ${y}H${width}`),
          ...upright.map(({ x }) => `M${x} 0V${floor}`),
        ].join("")}
      />
      {level.map(({ p, y }, i) => (
        <text key={p.q} className="number" x={width - 8 - (columns[i] ?? 0) * wide} y={y - 5} textAnchor="end">
          {text(lengths, p)}
        </text>
      ))}
      {upright.map(({ p, x }, i) => (
        <text
          key={p.q}
          className="number"
          {...(x > width - wide ? { x: x - 5, textAnchor: "end" } : { x: x + 5 })}
          y={top + (rows[i] ?? 0) * ROW}
        >
          {text(lengths, p)}
        </text>
      ))}
      {points.map((point, i) => {
        const at = toScreen(camera, point);
        return <circle key={i} cx={at.x} cy={at.y} r="4.5" />;
      })}
    </g>
  );
}
