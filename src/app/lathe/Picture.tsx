import { memo, useEffect, useId, useMemo, useRef } from "react";
import type { Ring } from "../../kernel/point.ts";
import type { StockFinding, Residual } from "../../sim/simulation.ts";
import { ringData } from "../../view/path.ts";
import { PATH_ROLES, type Scene, type Shape } from "../../view/scene.ts";
import { transform } from "../../view/svg.ts";
import { LatheAxes } from "./Axes.tsx";
import { MovingParts, type Moving, type Waiting } from "./MovingParts.tsx";
import type { Viewport } from "./viewport.ts";

/** Pixels between two hatch lines. */
const HATCH = 7;

const isPath = (shape: Shape) => (PATH_ROLES as readonly string[]).includes(shape.role);

const Still = memo(function Still({ shapes, mirror }: { readonly shapes: readonly Shape[]; readonly mirror: boolean }) {
  const drawn = shapes.map((shape, i) => <path key={i} className={`shape-${shape.role}`} d={shape.d} />);
  return <>{drawn}{mirror && <g transform="scale(1 -1)">{drawn}</g>}</>;
});

const Rings = memo(
  function Rings({ rings, role, fill }: { readonly rings: readonly Ring[]; readonly role: string; readonly fill?: string }) {
    return <path className={`shape-${role}`} d={ringData(rings)} {...(fill && { style: { fill } })} />;
  },
);

/** Follows the camera with one attribute: a group whose content is drawn in part space. */
function World({ viewport, children }: { readonly viewport: Viewport; readonly children: React.ReactNode }) {
  const group = useRef<SVGGElement>(null);
  useEffect(() => {
    const follow = () => group.current?.setAttribute("transform", transform(viewport.get()));
    follow();
    return viewport.subscribe(follow);
  }, [viewport]);
  return <g ref={group}>{children}</g>;
}

/** The hatches keep their pitch on the screen whatever the zoom. */
function Hatches({ viewport, id }: { readonly viewport: Viewport; readonly id: string }) {
  const defs = useRef<SVGDefsElement>(null);
  useEffect(() => {
    const follow = () => {
      const camera = viewport.get(), unit = 1 / camera.scale;
      for (const pattern of defs.current?.querySelectorAll("pattern") ?? []) {
        pattern.setAttribute("patternTransform", `scale(${unit} ${camera.xUp ? -unit : unit}) rotate(${pattern.dataset["angle"] ?? "0"})`);
      }
    };
    follow();
    return viewport.subscribe(follow);
  }, [viewport]);
  const hatch = (role: "stock" | "residual", angle: number) => (
    <pattern id={`${id}${role}`} data-angle={angle} width={HATCH} height={HATCH} patternUnits="userSpaceOnUse">
      <rect className={`hatch-ground-${role}`} width={HATCH} height={HATCH} />
      <line className={`hatch-line-${role}`} x1="0" y1="0" x2="0" y2={HATCH} />
    </pattern>
  );
  return <defs ref={defs}>{hatch("stock", 45)}{hatch("residual", -45)}</defs>;
}

/** Blank under the path; the contour over it as a thinner line, so that both are seen where the tip runs on the contour. */
const UPPER: readonly Shape["role"][] = ["blank", "sketch", "contour"];

/**
 * Section of the work with path and tool, in three sheets: material, drawing, tool. The drawing is painted once, however
 * long the path; zooming changes one matrix a sheet, playing two elements.
 */
export function Picture({ viewport, scene, moving, waiting, findings, residual, full, path, ghosts, chosen, hovered, name, children }: {
  readonly viewport: Viewport;
  readonly scene: Scene;
  readonly moving: Moving | null;
  /** The blank and the tool at its start, as long as nothing moves. */
  readonly waiting: Waiting | null;
  readonly findings: readonly StockFinding[];
  /** Shown only when the run is at its end. */
  readonly residual: readonly Residual[];
  readonly full: boolean;
  /** The lines of the path that are shown. */
  readonly path: readonly Shape[];
  /** Paths of other settings, in part space: under the path. */
  readonly ghosts: React.ReactNode;
  /** What is chosen, in part space: over the path. */
  readonly chosen: React.ReactNode;
  /** What is pointed at, in part space: under the tool. */
  readonly hovered: React.ReactNode;
  readonly name: string;
  /** What stands in screen space above the picture. */
  readonly children: React.ReactNode;
}) {
  const id = useId();
  const sheets = useMemo(() => ({
    below: scene.shapes.filter((shape) => !isPath(shape) && !UPPER.includes(shape.role)),
    blank: scene.shapes.filter((shape) => shape.role === "blank"),
    contour: scene.shapes.filter((shape) => shape.role === "contour" || shape.role === "sketch"),
  }), [scene]);
  return (
    <div className="lathe-picture" role="img" aria-label={name}>
      <svg className="sheet">
        <Hatches viewport={viewport} id={id} />
        <LatheAxes viewport={viewport} part="grid" />
        <World viewport={viewport}>
          <Still shapes={sheets.below} mirror={full} />
          {moving && <MovingParts.Stock moving={moving} full={full} fill={`url(#${id}stock)`} />}
          {waiting && <Rings rings={waiting.blank} role="stock" fill={`url(#${id}stock)`} />}
          {residual.length > 0 && <Rings rings={residual.map((each) => each.ring)} role="residual" fill={`url(#${id}residual)`} />}
        </World>
      </svg>
      <svg className="sheet ghosts">
        <World viewport={viewport}>{ghosts}</World>
      </svg>
      <svg className="sheet still">
        <World viewport={viewport}>
          <Still shapes={sheets.blank} mirror={full} />
          <g className="lathe-paths">
            <Still shapes={path} mirror={false} />
          </g>
          <Still shapes={sheets.contour} mirror={full} />
          {findings.length > 0 && <Rings rings={findings.flatMap((each) => [...each.rings])} role="gouge" />}
          {chosen}
        </World>
      </svg>
      <svg className="sheet">
        <World viewport={viewport}>
          {hovered}
          {moving && <MovingParts.Tool moving={moving} />}
          {waiting?.tool && waiting.start && <MovingParts.Still tool={waiting.tool} at={waiting.start} />}
        </World>
        {children}
        <LatheAxes viewport={viewport} part="scales" />
      </svg>
    </div>
  );
}
