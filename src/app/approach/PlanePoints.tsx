import { useMemo } from "react";
import type { ApproachRun } from "../../program/plane-types.ts";
import { planeNames } from "../../view/approach/plane-names.ts";
import { px } from "../../view/help/marks.ts";
import { HelpMarks } from "../help/HelpMarks.tsx";
import { useCamera } from "../lathe/use-camera.ts";
import type { Viewport } from "../lathe/viewport.ts";
import type { ApproachSpeech } from "../../view/approach/speech.ts";

/** PS, PH, PA, PE and PN of every approach and departure, with their coordinates where there is room. */
export function PlanePoints({ viewport, approaches, speech, id }: { readonly viewport: Viewport;
  readonly approaches: readonly ApproachRun[]; readonly speech: ApproachSpeech; readonly id: string })
{
  const camera = useCamera(viewport), size = viewport.size();
  const names = useMemo(() => planeNames(approaches, camera, size, speech), [approaches, camera, size, speech]);
  return (
    <g className="plane-points" aria-hidden="true">
      {names.points.map((p, i) => <circle key={i} className="approach-point" cx={px(p.place.x)} cy={px(p.place.y)} r={3.5} />)}
      <HelpMarks marks={names.marks} id={id} />
    </g>
  );
}
