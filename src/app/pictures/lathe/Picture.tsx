import { memo, useEffect, useId, useMemo, useRef, type CSSProperties } from "react";
import type { Camera } from "../../../view/camera.ts";
import type { Ring } from "../../../kernel/geometry/point.ts";
import type { Run } from "../../../program/state/run-types.ts";
import { outerOutlineData } from "../../../view/material/outer-outline.ts";
import { ringData } from "../../../view/path.ts";
import type { PathStretch } from "../../../view/passes.ts";
import type { Scene, Shape } from "../../../view/scene.ts";
import type { SectionView } from "../../base/settings/settings.ts";
import { NewestContour, NewestPath } from "./NewestLines.tsx";
import { FlatPicture } from "./FlatPicture.tsx";
import { TurnedSheet } from "./TurnedSheet.tsx";
import type { PlayedScene, InitialScene } from "../../calculation/moving.ts";
import { turnedMoveData, type Hover } from "./Chosen.tsx";
import { RunningTool, WaitingTool } from "./ToolSheet.tsx";
import type { Viewport } from "./viewport.ts";

/** Pixels between two hatch lines. */
const HATCH = 7;

/** Path data longer than this takes a slow device more than one frame to draw, characters. */
const LONG_PATH = 40_000;

const Still = memo(function Still({ shapes, mirror }: { readonly shapes: readonly Shape[]; readonly mirror: boolean }) {
  const drawn = shapes.map((shape, i) => <path key={i} className={`shape-${shape.role}`} d={shape.d} />);
  return (
    <>
      {drawn}
      {mirror && <g transform="scale(1 -1)">{drawn}</g>}
    </>
  );
});

const Rings = memo(function Rings({
  rings,
  role,
  fill,
}: {
  readonly rings: readonly Ring[];
  readonly role: string;
  readonly fill?: string;
}) {
  return <path className={`shape-${role}`} d={ringData(rings)} {...(fill && { style: { fill } })} />;
});

/** The hatch keeps its pitch on the screen at every zoom. */
function ResidualHatch({ viewport, id }: { readonly viewport: Viewport; readonly id: string }) {
  const defs = useRef<SVGDefsElement>(null);
  useEffect(() => {
    let laid: Camera | null = null;
    const follow = () => {
      const camera = viewport.drawn(),
        unit = 1 / camera.scale;
      if (camera === laid) return;
      laid = camera;
      for (const pattern of defs.current?.querySelectorAll("pattern") ?? []) {
        pattern.setAttribute(
          "patternTransform",
          `scale(${unit} ${camera.xUp ? -unit : unit}) rotate(${pattern.dataset["angle"] ?? "0"})`,
        );
      }
    };
    follow();
    return viewport.subscribe(follow);
  }, [viewport]);
  return (
    <defs ref={defs}>
      <pattern id={`${id}residual`} data-angle="-45" width={HATCH} height={HATCH} patternUnits="userSpaceOnUse">
        <rect className="hatch-ground-residual" width={HATCH} height={HATCH} />
        <line className="hatch-line-residual" x1="0" y1="0" x2="0" y2={HATCH} />
      </pattern>
    </defs>
  );
}

/** Largest extent of a drawing, mm. */
const FAR = 100_000;
const EVERYWHERE = { x: -FAR, y: -FAR, width: 2 * FAR, height: 2 * FAR } as const;

/** Hides what is behind the outer surface of the finished part; lines along that surface stay. */
function BeforeSurface({ id, moving }: { readonly id: string; readonly moving: PlayedScene }) {
  const { steps, stockAt } = moving;
  const d = useMemo(() => outerOutlineData(stockAt({ step: steps.length, fraction: 0 })), [steps, stockAt]);
  return (
    <mask id={id} className="before-surface" maskUnits="userSpaceOnUse" {...EVERYWHERE}>
      <rect {...EVERYWHERE} />
      <path d={d} />
      <path d={d} transform="scale(1 -1)" />
    </mask>
  );
}

/** Shows lines only at the surface of the finished part, and within the oversize that is left on it. */
function AtSurface({ id, moving }: { readonly id: string; readonly moving: PlayedScene }) {
  const { steps, stockAt } = moving;
  const d = useMemo(() => ringData(stockAt({ step: steps.length, fraction: 0 })), [steps, stockAt]);
  return (
    <mask id={id} className="at-surface" maskUnits="userSpaceOnUse" {...EVERYWHERE}>
      <path d={d} />
      <path d={d} transform="scale(1 -1)" />
    </mask>
  );
}

const NOTHING: readonly Ring[] = [];

/** Section of the workpiece with path and tool. */
export function Picture({
  of = null,
  viewport,
  scene,
  moving,
  waiting,
  gouges,
  residual,
  section,
  path,
  ghosts,
  chosen,
  hover,
  name,
  children,
}: {
  /** The shown run of the open work. Path and contour of a newer one are drawn at once. */
  readonly of?: Run | null;
  readonly viewport: Viewport;
  readonly scene: Scene;
  readonly moving: PlayedScene | null;
  /** The blank and the tool at its start, while nothing moves. */
  readonly waiting: InitialScene | null;
  /** Contour damage and residual material, in part space. */
  readonly gouges: readonly Ring[];
  readonly residual: readonly Ring[];
  readonly section: SectionView;
  /** The visible lines of the path. */
  readonly path: readonly PathStretch[];
  /** Paths of other settings, in part space, under the path. */
  readonly ghosts?: React.ReactNode;
  /** The choice, in part space, over the path. */
  readonly chosen?: React.ReactNode;
  /** The move under the pointer. */
  readonly hover?: Hover;
  readonly name: string;
  /** Content in screen space over the picture. */
  readonly children?: React.ReactNode;
}) {
  const id = useId(),
    full = section === "full",
    surface = section === "outside" && moving ? `url(#${id}surface)` : null;
  const isLong = useMemo(
    () => path.reduce((sum, { shapes }) => shapes.reduce((s, { d }) => s + d.length, sum), 0) > LONG_PATH,
    [path],
  );
  const sheets = useMemo(
    () => ({
      blank: scene.shapes.filter((shape) => shape.role === "blank"),
      contour: scene.shapes.filter((shape) => shape.role === "contour" || shape.role === "sketch"),
    }),
    [scene],
  );
  return (
    <FlatPicture
      viewport={viewport}
      plane="ZX"
      name={name}
      material={
        <TurnedSheet
          viewport={viewport}
          moving={moving}
          blank={waiting?.blank ?? NOTHING}
          section={section}
          chuck={scene.chuck}
        />
      }
      under={ghosts}
      defs={<ResidualHatch viewport={viewport} id={id} />}
      style={surface ? ({ "--surface-mask": surface } as CSSProperties) : undefined}
      drawing={
        <>
          {surface && moving && <BeforeSurface id={`${id}surface`} moving={moving} />}
          <g className="seen-outside">
            {residual.length > 0 && <Rings rings={residual} role="residual" fill={`url(#${id}residual)`} />}
            <Still shapes={sheets.blank} mirror={full} />
            {moving && <NewestPath of={of} stretches={path} playback={moving.playback} isLong={isLong} />}
            {moving && <AtSurface id={`${id}at`} moving={moving} />}
            <NewestContour of={of} shapes={sheets.contour}>
              {(shapes, isOfStock) =>
                moving && isOfStock ? (
                  <>
                    <g className="through-air">
                      <Still shapes={shapes} mirror={full} />
                    </g>
                    <g mask={`url(#${id}at)`}>
                      <Still shapes={shapes} mirror={full} />
                    </g>
                  </>
                ) : (
                  <Still shapes={shapes} mirror={full} />
                )
              }
            </NewestContour>
          </g>
          {gouges.length > 0 && <Rings rings={gouges} role="gouge" />}
          {chosen}
        </>
      }
      tool={
        <>
          {moving && <RunningTool viewport={viewport} moving={moving} section={section} />}
          {waiting?.tool && waiting.start && (
            <WaitingTool
              viewport={viewport}
              tool={waiting.tool}
              at={waiting.start}
              blank={waiting.blank}
              section={section}
            />
          )}
        </>
      }
      played={moving && { moves: moving.steps, playback: moving.playback, hover, dataOf: turnedMoveData }}
    >
      {children}
    </FlatPicture>
  );
}
