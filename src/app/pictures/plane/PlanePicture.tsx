import { memo } from "react";
import type { Run } from "../../../program/state/run-types.ts";
import type { RapidThrough } from "../../../sim/plane/milled.ts";
import { planeMotionData } from "../../../view/approach/motion-data.ts";
import type { PlaneRole } from "../../../view/approach/plane-scene.ts";
import { ringData } from "../../../view/path.ts";
import { FlatPicture } from "../lathe/FlatPicture.tsx";
import { useNewerRun } from "../lathe/NewestLines.tsx";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { RunningMove } from "../lathe/RunningMove.tsx";
import type { Viewport } from "../lathe/viewport.ts";
import type { NoStock } from "../../calculation/cut-milled.ts";
import type { GrowingStock } from "./milled.ts";
import { MilledSheet } from "./MilledSheet.tsx";
import { MillSheet } from "./MillSheet.tsx";
import { planeOfRun } from "../../calculation/plane-run.ts";

/** Lines over milled stock have a light edge, to be visible on its darkest tone. */
const EDGED: readonly PlaneRole[] = ["rapid", "feed", "lead"];

/** Contours and path, from a newer run if there is one, drawn with the key that changes them. */
const NewestLines = memo(function NewestLines({ of }: { readonly of: Run }) {
  const {
    scene: { shapes },
  } = planeOfRun(useNewerRun(of) ?? of);
  return (
    <>
      <path className="plane-under" d={shapes.flatMap(({ role, d }) => (EDGED.includes(role) ? [d] : [])).join("")} />
      {shapes.map(({ role, d }) => (
        <path key={role} className={`plane-${role}`} d={d} />
      ))}
    </>
  );
});

/** Blank, contours, path and mill in the working plane. */
export function PlanePicture({
  viewport,
  run,
  playback,
  milled,
  rapids,
  chosen,
  hovered,
  name,
  children,
}: {
  readonly viewport: Viewport;
  readonly run: Run;
  readonly playback: PlaybackStore;
  readonly milled: GrowingStock | NoStock;
  /** Rapids through material. */
  readonly rapids: readonly RapidThrough[];
  /** The choice, over the path, and the hovered motion, over everything. */
  readonly chosen: React.ReactNode;
  readonly hovered: React.ReactNode;
  readonly name: string;
  /** Content in screen space over the picture. */
  readonly children: React.ReactNode;
}) {
  const { plane: steps } = run;
  return (
    <FlatPicture
      viewport={viewport}
      plane="XY"
      name={name}
      className="plane-picture"
      material={
        typeof milled !== "string" && (
          <MilledSheet viewport={viewport} steps={steps} playback={playback} milled={milled} />
        )
      }
      drawing={
        <>
          {rapids.length > 0 && (
            <path className="shape-gouge plane-rapid-through" d={ringData(rapids.flatMap(({ rings }) => [...rings]))} />
          )}
          <NewestLines of={run} />
          {chosen}
        </>
      }
      tool={<MillSheet viewport={viewport} steps={steps} playback={playback} />}
      over={
        <>
          {hovered}
          <RunningMove moves={steps} playback={playback} dataOf={planeMotionData} each="reading" />
        </>
      }
    >
      {children}
    </FlatPicture>
  );
}
