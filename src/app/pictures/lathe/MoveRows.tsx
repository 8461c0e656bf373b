import { memo, useCallback, useEffect, useRef, useState } from "react";
import type { Run } from "../../../program/state/run-types.ts";
import { useLengths } from "../../calculation/lengths.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { kindText, runningFeed, phaseText, placeText } from "./running.ts";
import { useReadPlayback } from "./use-playback.ts";

/** Rows per page: thousands would be slow to build and hard to read. */
const PAGE = 50;

/** One move; a click goes to its start. Rendered again only when it starts or stops running. */
const MoveRow = memo(function MoveRow({
  index,
  step: { move, block },
  isRunning,
  go,
}: {
  readonly index: number;
  readonly step: Run["steps"][number];
  readonly isRunning: boolean;
  readonly go: (step: number) => void;
}) {
  const t = useTexts().lathe,
    lengths = useLengths(),
    { x, z } = placeText(lengths, move.to);
  return (
    <tr aria-current={isRunning}>
      <th scope="row">
        <button
          type="button"
          className="lathe-goto number"
          aria-label={t.goTo(String(index + 1))}
          onClick={() => go(index)}
        >
          {index + 1}
        </button>
      </th>
      <td>{kindText(t, move)}</td>
      <td className="number">{x}</td>
      <td className="number">{z}</td>
      <td className="number">{runningFeed(t, lengths, move)}</td>
      <td>
        {phaseText(t, move)}
        {move.pass !== undefined && ` ${move.pass}`}
      </td>
      <td className="number">{block}</td>
    </tr>
  );
});

/** A page of the moves, the running one marked. */
export function MoveRows({ run, playback }: { readonly run: Run; readonly playback: PlaybackStore }) {
  const t = useTexts().lathe;
  const running = useReadPlayback(playback, (s) => s.get().position.step);
  const playing = useReadPlayback(playback, (s) => s.get().playing);
  const body = useRef<HTMLTableSectionElement>(null);
  const own = Math.floor(Math.min(running, run.steps.length - 1) / PAGE);
  /** The page that was turned to: it stays until another move is gone to. */
  const [turned, setTurned] = useState<{ readonly page: number; readonly at: number } | null>(null);
  const turn = (page: number) => setTurned({ page, at: running });
  const go = useCallback(
    (step: number) => {
      setTurned(null);
      playback.dispatch({ do: "seek", position: { step, fraction: 0 } });
    },
    [playback],
  );
  const last = Math.floor((run.steps.length - 1) / PAGE),
    isTurned = turned !== null && (playing || turned.at === running),
    page = Math.min(isTurned ? turned.page : own, last),
    from = page * PAGE;
  useEffect(() => {
    if (isTurned) return undefined;
    // With the next frame: measuring earlier would force a layout.
    const picture = requestAnimationFrame(() => {
      body.current?.querySelector("[aria-current=true]")?.scrollIntoView({ block: "nearest" });
    });
    return () => cancelAnimationFrame(picture);
  }, [running, isTurned]);
  return (
    <>
      {last > 0 && (
        <div className="lathe-pages">
          <button type="button" className="button" disabled={page === 0} onClick={() => turn(page - 1)}>
            {t.earlier}
          </button>
          <span className="number">
            {t.range(String(from + 1), String(Math.min(from + PAGE, run.steps.length)), String(run.steps.length))}
          </span>
          <button type="button" className="button" disabled={page === last} onClick={() => turn(page + 1)}>
            {t.later}
          </button>
        </div>
      )}
      <table>
        <thead>
          <tr>
            {[t.move, t.moveKind, t.axisX, t.axisZ, t.moveFeed, t.movePhase, t.moveBlock].map((head) => (
              <th key={head} scope="col">
                {head}
              </th>
            ))}
          </tr>
        </thead>
        <tbody ref={body}>
          {run.steps.slice(from, from + PAGE).map((step, i) => (
            <MoveRow key={from + i} index={from + i} step={step} isRunning={from + i === running} go={go} />
          ))}
        </tbody>
      </table>
    </>
  );
}
