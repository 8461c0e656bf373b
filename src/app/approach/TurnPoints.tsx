import { useId, useMemo } from "react";
import type { ApproachRun } from "../../program/plane-types.ts";
import { planeNames } from "../../view/approach/plane-names.ts";
import { withRoom } from "../../view/approach/room.ts";
import { px } from "../../view/help/marks.ts";
import { HelpMarks } from "../help/HelpMarks.tsx";
import { useCamera } from "../lathe/use-camera.ts";
import type { Viewport } from "../lathe/viewport.ts";
import { useLengths } from "../lengths.ts";
import { approachSpeech } from "./speech.ts";
import "../help/help.css";
import "./approach.css";

/** They are places of the theoretical tip already. */
const NO_TIP = { x: 0, y: 0 };

/** PS, PH, PA, PE and PN of the approaches of a turning tool, in the picture of the lathe; gone while they would lie on each other. */
export function TurnPoints({ viewport, approaches }: { readonly viewport: Viewport; readonly approaches: readonly ApproachRun[] }) {
  const id = useId(), lengths = useLengths();
  const camera = useCamera(viewport), size = viewport.size();
  const names = useMemo(() => planeNames(withRoom(approaches, camera), camera, size, approachSpeech(lengths, "ZX", NO_TIP)), [
    approaches,
    camera,
    size,
    lengths,
  ]);
  return (
    <g className="plane-points" aria-hidden="true">
      {names.points.map((p) => (
        <circle key={p.names.join() + px(p.place.x) + px(p.place.y)} className="approach-point" cx={px(p.place.x)} cy={px(p.place.y)}
          r={3.5} />
      ))}
      <HelpMarks marks={names.marks} id={id} />
    </g>
  );
}
