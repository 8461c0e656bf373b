import { useEffect, useMemo, useRef, useState, type KeyboardEvent } from "react";
import type { Cycle } from "../../cycles/define.ts";
import type { CycleNumber } from "../../cycles/index.ts";
import { insertOutline } from "../../kernel/cutter/insert.ts";
import { part } from "../../kernel/geometry/point.ts";
import { CHORD } from "../../kernel/tolerance.ts";
import { pathOf } from "../../kernel/time/time.ts";
import { pieceTime } from "../../report/guide/piece-time.ts";
import { shownBox } from "../../report/guide/shown-effect.ts";
import { stepPieces, type StepPiece } from "../../report/guide/step-pieces.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import { playerOf } from "../../sim/stock.ts";
import { ringData } from "../../view/path.ts";
import { clock } from "../../app/base/clock.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { reducedMotion } from "../../app/base/settings/appearance.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { CutPicture } from "./CutPicture.tsx";
import type { CycleRun } from "./use-cycle-run.ts";

/** Milliseconds in a second of the clock. */
const SECOND = 1000;

/** The current piece, its elapsed time, s, and whether playback stops after it or continues. */
interface Shown {
  readonly index: number;
  readonly seconds: number;
  readonly plays: "no" | "one" | "all";
}

/** Index of the next or previous piece that this run has; null if there is none. */
function adjacentPiece(pieces: readonly StepPiece[], index: number, by: 1 | -1): number | null {
  for (let i = index + by; pieces[i]; i += by) if (pieces[i]?.piece) return i;
  return null;
}

/**
 * The numbered steps until the run is there, as large as they are with it, so that nothing below moves. Not for assistive
 * technology, which is told that the run is awaited.
 */
export function WaitingSteps({ cycle }: { readonly cycle: Cycle }) {
  const { steps: t, acts } = useTexts("guide");
  const { cycles } = useTexts();
  const words = cycles.of[cycle.number as CycleNumber];
  const runs = (["rough", "finish"] as const).filter((run) => words[run].length > 0);
  const [first] = runs;
  return (
    <div className="step-player" aria-hidden="true">
      <div className="step-stage">
        <div className="cut-picture" />
        <p className="step-said">
          {first && (
            <>
              <b>
                {acts[first]} <span className="number">1</span>
              </b>{" "}
              {words[first][0]}
            </>
          )}
        </p>
        <div className="step-buttons">
          <button type="button" className="button" disabled>
            <Icon name="unfold" />
          </button>
          <button type="button" className="button primary" disabled>
            <Icon name="play" /> {t.play}
          </button>
          <button type="button" className="button" disabled>
            <Icon name="fold" />
          </button>
          <button type="button" className="button" disabled>
            {t.playAll}
          </button>
          <span className="small soft step-keys">{t.keys}</span>
        </div>
        <p className="small soft">{t.example}</p>
      </div>
      <div className="step-lists">
        {runs.map((run) => (
          <div key={run}>
            <h3>{acts[run]}</h3>
            <ol>
              {words[run].map((text, i) => (
                <li key={text}>
                  <span className="step-choice">
                    <span className="number">{i + 1}</span> <span>{text}</span>
                  </span>
                </li>
              ))}
            </ol>
          </div>
        ))}
      </div>
    </div>
  );
}

/** The numbered steps of a cycle, each played with its piece of the run. */
export function StepPlayer({ cycle, run: { outcome, isOwn } }: { readonly cycle: Cycle; readonly run: CycleRun }) {
  const { steps: t, acts } = useTexts("guide");
  const { cycles } = useTexts();
  const still = useSettings(reducedMotion);
  const words = cycles.of[cycle.number as CycleNumber];
  const { steps } = outcome.run;
  const pieces = useMemo(() => stepPieces(cycle, steps, 0), [cycle, steps]);
  const times = useMemo(() => pieces.map(({ piece }) => piece && pieceTime(steps, piece)), [pieces, steps]);
  const player = useMemo(() => playerOf(outcome.simulation), [outcome]);
  const box = useMemo(() => shownBox([outcome]), [outcome]);
  const [shown, show] = useState<Shown>(() => ({
    index: Math.max(
      0,
      pieces.findIndex(({ piece }) => piece),
    ),
    seconds: 0,
    plays: "no",
  }));
  const { index, seconds, plays } = shown;
  const time = times[index];

  useEffect(() => {
    if (plays === "no" || !time) return undefined;
    let before = clock.now(),
      cancel = () => undefined as void;
    const next = (now: number) => {
      const by = Math.max(0, now - before) / SECOND;
      before = now;
      show((was) => {
        const later = was.seconds + by;
        if (later < time.lasts) return { ...was, seconds: later };
        const following = was.plays === "all" ? adjacentPiece(pieces, was.index, 1) : null;
        return following === null
          ? { ...was, seconds: time.lasts, plays: "no" }
          : { ...was, index: following, seconds: 0 };
      });
      cancel = clock.frame(next);
    };
    cancel = clock.frame(next);
    return () => cancel();
  }, [plays, time, pieces]);

  const choose = (to: number | null) => {
    if (to === null || !times[to]) return;
    show({ index: to, seconds: still ? times[to].lasts : 0, plays: still ? "no" : "one" });
  };
  const toggle = (how: "one" | "all") =>
    show((was) =>
      was.plays !== "no"
        ? { ...was, plays: "no" }
        : { ...was, seconds: was.seconds >= (times[was.index]?.lasts ?? 0) ? 0 : was.seconds, plays: how },
    );
  const byKey = useRef(false),
    lists = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (byKey.current) lists.current?.querySelector("[aria-current]")?.scrollIntoView?.({ block: "nearest" });
    byKey.current = false;
  }, [index]);
  const onKey = (event: KeyboardEvent) => {
    const isButton = (event.target as HTMLElement).closest("button");
    byKey.current = event.key === "ArrowRight" || event.key === "ArrowLeft";
    if (byKey.current) choose(adjacentPiece(pieces, index, event.key === "ArrowRight" ? 1 : -1));
    else if (event.key === " " && !isButton) toggle("one");
    else return;
    event.preventDefault();
  };

  const chosen = pieces[index];
  const position: PlayPosition = time?.at(seconds) ?? { step: 0, fraction: 0 };
  const running = steps[Math.min(position.step, steps.length - 1)];
  const tip =
    running &&
    (position.step >= steps.length
      ? running.move.to
      : part.pointOn(pathOf(running.from, running.move), position.fraction));
  const done = chosen?.piece ? steps.slice(chosen.piece.from, Math.min(chosen.piece.to, position.step + 1)) : [];
  const textOf = ({ run, number }: StepPiece) => words[run][number - 1] ?? "";
  const name = chosen ? `${acts[chosen.run]} ${chosen.number}: ${textOf(chosen)}` : "";
  return (
    <section className="step-player" aria-label={t.title} onKeyDown={onKey}>
      <div className="step-stage">
        <CutPicture outcome={outcome} box={box} stock={player.at(position)} steps={done} name={t.picture(name)}>
          {running && tip && (
            <path
              className="cut-insert"
              d={ringData([insertOutline(running.tool, CHORD)])}
              transform={`translate(${tip.z} ${tip.r})`}
            />
          )}
        </CutPicture>
        <p className="step-said" role="status">
          <b>
            {chosen && acts[chosen.run]} <span className="number">{chosen?.number}</span>
          </b>{" "}
          {chosen && textOf(chosen)}
        </p>
        <div className="step-buttons">
          <button
            type="button"
            className="button"
            aria-label={t.previous}
            disabled={adjacentPiece(pieces, index, -1) === null}
            onClick={() => choose(adjacentPiece(pieces, index, -1))}
          >
            <Icon name="unfold" />
          </button>
          <button type="button" className="button primary" onClick={() => toggle("one")}>
            <Icon name={plays === "no" ? "play" : "pause"} /> {plays === "no" ? t.play : t.stop}
          </button>
          <button
            type="button"
            className="button"
            aria-label={t.next}
            disabled={adjacentPiece(pieces, index, 1) === null}
            onClick={() => choose(adjacentPiece(pieces, index, 1))}
          >
            <Icon name="fold" />
          </button>
          <button
            type="button"
            className="button"
            onClick={() =>
              show({
                index: Math.max(
                  0,
                  pieces.findIndex(({ piece }) => piece),
                ),
                seconds: 0,
                plays: "all",
              })
            }
          >
            {t.playAll}
          </button>
          <span className="small soft step-keys">{t.keys}</span>
        </div>
        <p className="small soft">{isOwn ? t.own : t.example}</p>
      </div>
      <div className="step-lists" ref={lists}>
        {(["rough", "finish"] as const)
          .filter((run) => words[run].length > 0)
          .map((run) => (
            <div key={run}>
              <h3>{acts[run]}</h3>
              <ol>
                {pieces.map(
                  (each, i) =>
                    each.run === run && (
                      <li key={each.number}>
                        <button
                          type="button"
                          className="step-choice"
                          aria-current={i === index ? "step" : undefined}
                          disabled={!each.piece}
                          onClick={() => choose(i)}
                        >
                          <span className="number">{each.number}</span> <span>{textOf(each)}</span>
                          {!each.piece && <span className="small soft">{t.absent}</span>}
                        </button>
                      </li>
                    ),
                )}
              </ol>
            </div>
          ))}
      </div>
    </section>
  );
}
