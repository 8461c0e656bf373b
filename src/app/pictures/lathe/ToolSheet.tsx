import { useCallback, useEffect, useMemo, useRef } from "react";
import { insertOutline } from "../../../kernel/cutter/insert.ts";
import type { Pt, Ring } from "../../../kernel/geometry/point.ts";
import { CHORD, SAME_STEP } from "../../../kernel/tolerance.ts";
import type { Tool } from "../../../kernel/plan/tool.ts";
import { boundsOf, common, grownBounds } from "../../../view/bounds.ts";
import type { Bounds, Size } from "../../../view/camera.ts";
import { liesInward, windowsOf } from "../../../view/cutting-tool/covered.ts";
import { toolBox } from "../../../view/cutting-tool/drawing.ts";
import { liesBehind, silhouetteOf, type Silhouette } from "../../../view/cutting-tool/silhouette.ts";
import type { SectionView } from "../../base/settings/settings.ts";
import { pageLength } from "../../base/unit.ts";
import { BreakLine } from "./BreakLine.tsx";
import { CarriedSheet, LINE } from "./CarriedSheet.tsx";
import { restingTip, runningTip, type MovingAnchor } from "./moving-anchor.ts";
import { TipCarrier } from "./TipCarrier.tsx";
import { ChipSheet } from "./ChipSheet.tsx";
import { DrawnTool } from "./DrawnTool.tsx";
import { stepIndex, type PlayedScene } from "../../calculation/moving.ts";
import { usePlayback } from "./use-playback.ts";
import type { Viewport } from "./viewport.ts";

/** A step is almost done: its material is removed, and going on from there costs nothing. */
const NEARLY = 1 - SAME_STEP;
const NO_EDGE: Silhouette = [];
/** A holder is drawn up to this many picture sizes. */
const PICTURES = 1.5;

/** Bounds of the insert, and of the whole tool. */
function boxesOf(tool: Tool): { readonly insert: Bounds; readonly all: Bounds } {
  const insert = boundsOf(insertOutline(tool, CHORD)) ?? { left: -1, right: 1, low: -1, high: 1 };
  return { insert, all: toolBox(tool) ?? insert };
}

/** Position of a tool, and its data. */
interface Standing {
  readonly viewport: Viewport;
  readonly tool: Tool;
  readonly carrying: MovingAnchor;
}

/** A tool on a sheet of its own. */
function Sheet({ viewport, tool }: Pick<Standing, "viewport" | "tool">) {
  const boxOf = useMemo(() => {
    const { insert, all } = boxesOf(tool);
    return (scale: number, { width, height }: Size) => {
      const far = (PICTURES * Math.max(width, height)) / scale,
        { left, right, low, high } = common(all, grownBounds(insert, far));
      return grownBounds({ left: left * scale, right: right * scale, low: low * scale, high: high * scale }, LINE);
    };
  }, [tool]);
  return (
    <CarriedSheet viewport={viewport} boxOf={boxOf}>
      <DrawnTool tool={tool} />
    </CarriedSheet>
  );
}

/** A tool that the workpiece may cover: visible at the open section and outside the workpiece, edges only behind it. */
function CoveredTool({
  section,
  edge,
  ...standing
}: Standing & { readonly section: SectionView; readonly edge: () => Silhouette }) {
  const silhouette = useMemo(() => edge(), [edge]);
  const { viewport } = standing,
    seen = useRef<HTMLDivElement>(null),
    other = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const look = () => {
      const windows = windowsOf(section, viewport.get(), viewport.size(), silhouette, pageLength);
      if (seen.current) seen.current.style.clipPath = windows?.seen ?? "";
      if (!other.current) return;
      other.current.style.clipPath = windows?.other ?? "";
      other.current.style.display = windows ? "" : "none";
    };
    look();
    return viewport.subscribe(look);
  }, [viewport, section, silhouette]);
  const drawn = (
    <>
      <TipCarrier {...standing}>
        <Sheet {...standing} />
      </TipCarrier>
      <BreakLine {...standing} />
    </>
  );
  return (
    <>
      <div ref={seen} className="tool-window">
        {drawn}
      </div>
      <div ref={other} className={`tool-window${section === "outside" ? " behind" : ""}`}>
        {drawn}
      </div>
    </>
  );
}

/** A tool, and what is drawn over it at its tip, which the workpiece never covers. */
function StandingTool({
  section,
  edge,
  children,
  ...standing
}: Standing & {
  readonly section: SectionView;
  /** The visible edge of the workpiece; called only if the workpiece may cover the tool. */
  readonly edge: () => Silhouette;
  readonly children?: React.ReactNode;
}) {
  const { tool } = standing,
    inward = useMemo(() => liesInward(tool), [tool]);
  const covered = section === "outside" || (inward && section === "half");
  return (
    <>
      {covered && <CoveredTool {...standing} section={section} edge={edge} />}
      {(!covered || children) && (
        <TipCarrier {...standing}>
          {!covered && <Sheet {...standing} />} {children}
        </TipCarrier>
      )}
      {!covered && <BreakLine {...standing} />}
    </>
  );
}

/** Insert and holder of the running move, with its chip. */
export function RunningTool({
  viewport,
  moving,
  section,
}: {
  readonly viewport: Viewport;
  readonly moving: PlayedScene;
  readonly section: SectionView;
}) {
  const { steps, playback, stockAt } = moving;
  const index = usePlayback(playback, (store) => stepIndex(steps, store.shown()));
  const carrying = useMemo(() => runningTip(steps, playback), [steps, playback]);
  const edge = useCallback(() => {
    const step = steps[index],
      silhouette = silhouetteOf(stockAt({ step: index, fraction: NEARLY }));
    return step && liesBehind(step.tool, [step.from, step.move.to], silhouette) ? silhouette : NO_EDGE;
  }, [steps, stockAt, index]);
  const tool = steps[index]?.tool;
  return (
    tool && (
      <StandingTool viewport={viewport} tool={tool} carrying={carrying} section={section} edge={edge}>
        <ChipSheet viewport={viewport} moving={moving} />
      </StandingTool>
    )
  );
}

/** The tool at the start point of the cycle. */
export function WaitingTool({
  viewport,
  tool,
  at,
  blank,
  section,
}: {
  readonly viewport: Viewport;
  readonly tool: Tool;
  readonly at: Pt;
  readonly blank: readonly Ring[];
  readonly section: SectionView;
}) {
  const carrying = useMemo(() => restingTip(at), [at]),
    edge = useCallback(() => silhouetteOf(blank), [blank]);
  return <StandingTool viewport={viewport} tool={tool} carrying={carrying} section={section} edge={edge} />;
}
