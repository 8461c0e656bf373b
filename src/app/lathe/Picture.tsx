import { memo, useEffect, useId, useRef } from "react";
import type { Ring } from "../../kernel/point.ts";
import type { Finding, Residual } from "../../sim/simulation.ts";
import { ringData } from "../../view/path.ts";
import type { Scene, Shape } from "../../view/scene.ts";
import { transform } from "../../view/svg.ts";
import { Axes } from "./Axes.tsx";
import { MovingParts, type Moving } from "./MovingParts.tsx";
import { PATH_ROLES } from "../../view/scene.ts";
import type { Viewport } from "./viewport.ts";

/** Pixels between two hatch lines. */
const HATCH = 7;

const isPath = (shape: Shape) => (PATH_ROLES as readonly string[]).includes(shape.role);

const Still = memo(function Still({ shapes, mirror }: { readonly shapes: readonly Shape[]; readonly mirror: boolean }) {
  const drawn = shapes.map((shape, i) => <path key={i} className={`shape-${shape.role}`} d={shape.d} />);
  return <>{drawn}{mirror && <g transform="scale(1 -1)">{drawn}</g>}</>;
});

const Toolpath = memo(function Toolpath({ shapes }: { readonly shapes: readonly Shape[] }) {
  return <g className="lathe-toolpath">{shapes.map(shape => <path key={shape.role} className={`shape-${shape.role}`} d={shape.d} />)}</g>;
});

const Rings = memo(function Rings({ rings, role, fill }: { readonly rings: readonly Ring[]; readonly role: string; readonly fill?: string }) {
  return <path className={`shape-${role}`} d={ringData(rings)} {...(fill && { fill })} />;
});

/** Section of the work with path and tool. The still layers are drawn once; zooming changes one matrix, moving two elements. */
export function Picture({ viewport, scene, moving, findings, residual, full, name, children }: {
  readonly viewport: Viewport;
  readonly scene: Scene;
  readonly moving: Moving | null;
  readonly findings: readonly Finding[];
  /** Shown only when the run is at its end. */
  readonly residual: readonly Residual[];
  readonly full: boolean;
  readonly name: string;
  /** What stands in screen space above the picture. */
  readonly children: React.ReactNode;
}) {
  const id = useId();
  const world = useRef<SVGGElement>(null);
  const hatches = useRef<SVGDefsElement>(null);
  useEffect(() => {
    const follow = () => {
      const camera = viewport.get(), unit = 1 / camera.scale;
      world.current?.setAttribute("transform", transform(camera));
      for (const pattern of hatches.current?.querySelectorAll("pattern") ?? []) {
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
  const still = scene.shapes.filter(shape => !isPath(shape));
  const behind = still.filter(shape => shape.role !== "contour" && shape.role !== "blank"), before = still.filter(shape => shape.role === "contour" || shape.role === "blank");
  return (
    <svg className="lathe-picture" role="img" aria-label={name}>
      <defs ref={hatches}>
        {hatch("stock", 45)}
        {hatch("residual", -45)}
      </defs>
      <Axes viewport={viewport} part="grid" />
      <g ref={world}>
        <Still shapes={behind} mirror={full} />
        {moving && <MovingParts.Stock moving={moving} full={full} fill={`url(#${id}stock)`} />}
        {residual.length > 0 && <Rings rings={residual.map(each => each.ring)} role="residual" fill={`url(#${id}residual)`} />}
        <Still shapes={before} mirror={full} />
        <Toolpath shapes={scene.shapes.filter(isPath)} />
        {findings.length > 0 && <Rings rings={findings.flatMap(each => [...each.rings])} role="gouge" />}
        {moving && <MovingParts.Tool moving={moving} />}
      </g>
      {children}
      <Axes viewport={viewport} part="scales" />
    </svg>
  );
}
