import type { ComponentProps } from "react";
import { LatheView } from "../lathe/LatheView.tsx";
import { useTexts } from "../settings/use-texts.ts";
import { PlaneView } from "./PlaneView.tsx";
import { showsPlane, useAskedView } from "./shown-view.ts";
import "./approach.css";

/** What a program does: the lathe, or the working plane where it mills. A program with both has a switch. */
export function MachineView(props: ComponentProps<typeof LatheView>) {
  const t = useTexts();
  const asked = useAskedView((v) => v.asked);
  const { result, dimmed, playback, clock } = props;
  const run = result?.run;
  const plane = run !== undefined && showsPlane(run, asked);
  const both = run !== undefined && run.plane.length > 0 && run.steps.length > 0;
  return (
    <div className="machine-view">
      {both && (
        <div className="machine-switch" role="group" aria-label={t.lathe.viewTools}>
          <button type="button" className="button" aria-pressed={!plane} onClick={() => useAskedView.setState({ asked: "lathe" })}>
            {t.lathe.title}
          </button>
          <button type="button" className="button" aria-pressed={plane} onClick={() => useAskedView.setState({ asked: "plane" })}>
            {t.approach.view}
          </button>
        </div>
      )}
      {plane ? <PlaneView run={run} dimmed={dimmed} playback={playback} clock={clock} /> : <LatheView {...props} />}
    </div>
  );
}
