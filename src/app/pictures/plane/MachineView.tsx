import { useEffect, type ComponentProps } from "react";
import type { MachineSide } from "../../../program/run/plane-index.ts";
import type { Run } from "../../../program/state/run-types.ts";
import { useChosenFinding } from "../../document/chosen-finding.ts";
import { useFindings } from "../../findings/use-findings.ts";
import { LatheView } from "../lathe/LatheView.tsx";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { lazyPart } from "../../base/parts.ts";
import { prefetchIdle } from "../../base/idle.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { followProgramSides, showSide, showsPlane, switchSide, useAskedView } from "./shown-view.ts";
import "./approach.css";

const fetchPlane = async () => ({ default: (await import("./PlaneView.tsx")).PlaneView });
/** Loaded for a program that mills. */
const PlaneView = lazyPart(fetchPlane);

const SIDES: readonly MachineSide[] = ["lathe", "plane"];

/** Switches the picture with the chosen finding and with playback. */
function useSides(run: Run | null, playback: PlaybackStore): void {
  const { id, count, shown } = useChosenFinding(),
    entries = useFindings();
  const plane = count > shown ? entries.find((entry) => entry.id === id)?.spot?.plane : undefined;
  useEffect(() => {
    if (run && plane !== undefined) showSide(run, playback, plane === "XY" ? "plane" : "lathe");
  }, [run, playback, plane, count]);
  useEffect(
    () => (run && run.plane.length > 0 && run.steps.length > 0 ? followProgramSides(run, playback) : undefined),
    [run, playback],
  );
}

/** The picture of a program: the lathe, or the working plane for milling. A program with both has a switch. */
export function MachineView(props: ComponentProps<typeof LatheView>) {
  const t = useTexts();
  const asked = useAskedView((v) => v.asked);
  const { result, dimmed, playback, clock, onMove } = props;
  const run = result?.run;
  useSides(run ?? null, playback);
  const plane = result !== null && showsPlane(result.run, asked);
  const both = run !== undefined && run.plane.length > 0 && run.steps.length > 0;
  // Playback switches to it unasked, so it is loaded early: otherwise the milling would be over before it is here.
  useEffect(() => (both ? prefetchIdle(fetchPlane) : undefined), [both]);
  return (
    <div className="machine-view">
      {both && (
        <div className="machine-switch" role="group" aria-label={t.lathe.viewTools}>
          {SIDES.map((side) => (
            <button
              key={side}
              type="button"
              className="button"
              aria-pressed={plane === (side === "plane")}
              onClick={() => switchSide(run, playback, side)}
            >
              {side === "plane" ? t.approach.view : t.lathe.title}
            </button>
          ))}
        </div>
      )}
      {plane ? (
        <PlaneView result={result} dimmed={dimmed} playback={playback} clock={clock} onMove={onMove} />
      ) : (
        <LatheView {...props} />
      )}
    </div>
  );
}
