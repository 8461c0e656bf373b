import type { Run } from "../../../program/state/run-types.ts";
import { Icon } from "../../base/Icon.tsx";
import { changeSettings, useSettings } from "../../base/settings/settings.ts";
import { useMedia } from "../../base/use-media.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { mostSteps, nearestCycle, runningSteps } from "./running.ts";
import { useReadPlayback } from "./use-playback.ts";

/**
 * The manual's numbered steps of the running operation, with the current one marked; a click goes to its first move.
 */
export function StepList({ run, playback }: { readonly run: Run; readonly playback: PlaybackStore }) {
  const texts = useTexts(),
    t = texts.lathe.stepList,
    // On small screens the list is among the tools, which are opened for it.
    among = useMedia("narrow"),
    open = useSettings((s) => s.stepsOpen) || among;
  const index = useReadPlayback(playback, (store) => {
    const { operation, move } = run.steps[store.get().position.step] ?? {};
    return operation === null || move === undefined ? null : `${operation} ${move.run} ${move.step}`;
  });
  // The picture above the list keeps its size: between cycles the steps of the next one are shown unmarked, and a
  // shorter list gets the height of the longest one.
  const near = useReadPlayback(playback, (store) => nearestCycle(run, store.get().position.step));
  const steps =
    near === null ? [] : runningSteps(texts, run, near, index === null ? null : playback.get().position.step);
  if (steps.length === 0) return null;
  const room = Math.max(0, mostSteps(texts, run) - steps.length);
  return (
    <div className="lathe-steps">
      {!among && (
        <button
          type="button"
          className="button icon plain"
          aria-expanded={open}
          aria-label={open ? t.fold : t.unfold}
          title={open ? t.fold : t.unfold}
          onClick={() => changeSettings({ stepsOpen: !open })}
        >
          <Icon name={open ? "down" : "up"} />
        </button>
      )}
      {open && (
        <ol aria-label={t.title}>
          {steps.map(({ number, words, first, runs }) => (
            <li key={number} aria-current={runs ? "step" : undefined}>
              <button
                type="button"
                disabled={first === null}
                title={words}
                onClick={() => {
                  playback.dispatch({ do: "pause" });
                  if (first !== null) playback.dispatch({ do: "seek", position: { step: first, fraction: 0 } });
                }}
              >
                <span className="number">{number}</span>
                <span>{words}</span>
              </button>
            </li>
          ))}
          {Array.from({ length: room }, (_, i) => (
            <li key={`room ${i}`} className="lathe-step-room" aria-hidden="true" />
          ))}
        </ol>
      )}
    </div>
  );
}
