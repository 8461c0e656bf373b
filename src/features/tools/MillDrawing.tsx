import { pointLength } from "../../kernel/cutter/drill.ts";
import { radius, toDiameter } from "../../kernel/units.ts";
import { formatNumber } from "../../i18n/number.ts";
import { drillOf } from "../../program/tools/drill-of.ts";
import type { MillTool } from "../../program/tools/tool-entry.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { scaleLengthFor } from "./LiveInsert.tsx";
import { pageLength } from "../../app/base/unit.ts";

/** Edges of the drawing, px. */
const WIDTH = 176;
const HEIGHT = 148;
/** Space below the point of a tool, px. */
const BELOW = 12;
/** Drawn length of a tool, in diameters: more would make its point too small. */
const DRAWN = 4;
/** Turns of a thread closer than this are not drawn one by one, px. */
const CLOSEST_TURNS = 4;

/** Drawn sizes of a tool, mm: cutting width, point, cutting edge length if known, thread pitch; point angle in degrees. */
interface Side {
  readonly across: number;
  readonly point: number;
  readonly edges: number | null;
  readonly pitch: number | null;
  readonly angle: number;
}

function sideOf(mill: MillTool): Side {
  const across = toDiameter(radius(mill.R + (mill.DR ?? 0)));
  const drill = drillOf(mill);
  return {
    across,
    point: drill ? pointLength(drill) : 0,
    edges: drill?.CUTLENGTH ?? null,
    pitch: drill?.PITCH ?? null,
    angle: drill?.["T-ANGLE"] ?? 0,
  };
}

/** The height of the drawing in mm. */
function spanOf({ across, point, edges }: Side): number {
  const long = edges === null ? 0 : Math.min(edges * 1.2, across * DRAWN);
  return scaleLengthFor(Math.max(across * 1.4, point * 1.4, long, 1));
}

/** A tool from the side, its point down: the part with edges, the shank above it, and the turns of a tap. */
function Outline({ side, scale }: { readonly side: Side; readonly scale: number }) {
  const [middle, foot] = [WIDTH / 2, HEIGHT - BELOW];
  const half = (side.across * scale) / 2;
  const shoulder = foot - side.point * scale;
  const top = side.edges === null ? 0 : Math.max(0, foot - Math.max(side.edges, side.point) * scale);
  const step = side.pitch === null ? 0 : side.pitch * scale;
  const turns =
    step < CLOSEST_TURNS
      ? []
      : Array.from({ length: Math.floor((shoulder - top) / step) }, (_, i) => shoulder - (i + 1) * step);
  const tip = side.point > 0 ? `L${middle} ${foot}` : "";
  return (
    <>
      {top > 0 && <path className="shape-holder" d={`M${middle - half} 0H${middle + half}V${top}H${middle - half}Z`} />}
      <path
        className="shape-insert"
        d={`M${middle - half} ${top}H${middle + half}V${shoulder}${tip}L${middle - half} ${shoulder}Z`}
      />
      {turns.map((y) => (
        <path key={y} className="tool-turn" d={`M${middle - half} ${y + step / 2}L${middle + half} ${y}`} />
      ))}
      <path className="insert-tip" strokeDasharray="8 3 2 3" d={`M${middle} 0V${HEIGHT}`} />
    </>
  );
}

/** A mill or a drill to scale from the side, with its axis and a reference length. */
export function MillDrawing({ mill }: { readonly mill: MillTool | null }) {
  const t = useTexts("tables").tools;
  const language = useSettings((s) => s.language);
  if (!mill)
    return (
      <div className="live-insert">
        <p className="soft small">{t.noDrawing}</p>
      </div>
    );
  const side = sideOf(mill);
  const span = spanOf(side);
  const scale = HEIGHT / span;
  const bar = scaleLengthFor(span / 6);
  const number = (n: number) => formatNumber(language, n);
  const angle = side.point > 0 ? `${number(side.angle)}°` : t.flat;
  const pointed = mill.TYPE === "DRILL" || mill.TYPE === "CENTER";
  return (
    <figure className="live-insert" aria-label={t.millDrawing}>
      <svg
        className="insert-drawing"
        width={pageLength(WIDTH)}
        height={pageLength(HEIGHT)}
        viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
        aria-hidden="true"
      >
        <Outline side={side} scale={scale} />
      </svg>
      <figcaption className="small">
        <span className="scale-bar number">
          <i style={{ width: pageLength(bar * scale) }} /> {t.scale(number(bar))}
        </span>
        <span className="soft number">
          ⌀ {t.scale(number(side.across))}
          {pointed && ` · ${angle}`}
        </span>
        {side.edges !== null && <span className="soft number">{t.edges(number(side.edges))}</span>}
        {side.pitch !== null && <span className="soft number">{t.pitch(number(side.pitch))}</span>}
      </figcaption>
    </figure>
  );
}
