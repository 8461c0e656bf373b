import { useCallback, useEffect, useRef, useSyncExternalStore } from "react";
import type { LoadTexts } from "../../../i18n/en/load.ts";
import type { Lengths } from "../../../i18n/lengths.ts";
import type { Pt } from "../../../kernel/geometry/point.ts";
import type { Run } from "../../../program/state/run-types.ts";
import type { PlayPosition } from "../../../sim/simulation.ts";
import { stretchNear, stretchOfStep } from "../../../view/load/near.ts";
import { rowAt } from "../../../view/load/values.ts";
import { moveAt, positionNear } from "../../../view/pick.ts";
import { useOutcome } from "../../calculation/outcome.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { useEachReading } from "../lathe/use-playback.ts";
import type { Viewport } from "../lathe/viewport.ts";
import { useLengths } from "../../calculation/lengths.ts";
import { goToLoad } from "./go-to-load.ts";
import { LoadScale } from "./LoadScale.tsx";
import { measureLoad, type MeasuredLoad } from "./load-store.ts";
import type { PointedPlace } from "./pointed-place.ts";
import { useLoadDrawing } from "./use-drawing.ts";
import {
  loadPlaceText,
  rowText,
  stretchText,
  useGreatest,
  useLoadOf,
  useMeasuredRun,
  loadValue,
  type LoadQuantity,
} from "./use-load.ts";
import "./load.css";
import { useTexts } from "../../base/settings/use-texts.ts";

export interface LoadStripProps {
  readonly of: LoadQuantity;
  readonly run: Run;
  readonly viewport: Viewport;
  readonly playback: PlaybackStore;
  readonly pointed: PointedPlace;
  /** The visible moves. */
  readonly shown: (step: number) => boolean;
}

/** Values must be unchanged this long before they are measured, ms; while typing, the path comes first. */
const REST = 200;
/** Distance at which a pointer picks a line, pixels. */
const NEAR = 10;

interface Asked {
  readonly t: LoadTexts;
  readonly lengths: Lengths;
  readonly of: LoadQuantity;
  readonly load: MeasuredLoad;
}

/** Text about a moment; empty if the tool cuts nothing. */
function momentText({ t, lengths, of, load: { path, surface } }: Asked, position: PlayPosition): string {
  if (of === "roughness") {
    const stretch = surface && stretchOfStep(surface, position);
    return stretch ? stretchText(t, lengths, stretch) : "";
  }
  const row = path && rowAt(path, position);
  return path && row !== null ? rowText(t, lengths, of, path, row) : "";
}

/** Text about the place under the pointer; empty if there is no line. */
function pointedText(asked: Asked, run: Run, place: Pt, reach: number, shown: (step: number) => boolean): string {
  const {
    t,
    lengths,
    of,
    load: { surface },
  } = asked;
  if (of === "roughness") {
    const stretch = surface && stretchNear(surface, place, reach);
    return stretch ? stretchText(t, lengths, stretch) : "";
  }
  const step = moveAt(run.steps, place, reach, shown);
  return step === null ? "" : momentText(asked, positionNear(run.steps, step, place));
}

/** Starts measuring the quantity a little after the simulation. */
function useMeasuring(run: Run, what: "surface" | "path"): void {
  const isProved = useOutcome((s) => s.shown?.run === run);
  useEffect(() => {
    if (!isProved || run.steps.length === 0) return undefined;
    const timer = setTimeout(() => void measureLoad(run, what), REST);
    return () => clearTimeout(timer);
  }, [run, what, isProved]);
}

/** Scale of the colour map, the value at the tool or pointer, and the highest value. */
export function LoadStrip({ of, run, viewport, playback, pointed, shown }: LoadStripProps) {
  const t = useTexts("load"),
    lengths = useLengths();
  useMeasuring(run, of === "roughness" ? "surface" : "path");
  const load = useLoadOf(run),
    told = useMeasuredRun(run),
    isOld = told !== run;
  const drawing = useLoadDrawing(told, of),
    worst = useGreatest(told, of)?.worst ?? null;
  const place = useSyncExternalStore(pointed.subscribe, pointed.get);
  const here =
    place && load ? pointedText({ t, lengths, of, load }, run, place, NEAR / viewport.get().scale, shown) : "";
  const now = useRef<HTMLSpanElement>(null);
  useEachReading(
    playback,
    useCallback(() => {
      const said = (load && momentText({ t, lengths, of, load }, playback.shown())) || "–";
      if (now.current && now.current.textContent !== said) now.current.title = now.current.textContent = said;
    }, [t, lengths, of, load, playback]),
  );
  const rests = worst ? "" : t.nothing;
  const waits = drawing && !isOld ? rests : load?.failed ? t.failed : t.working;
  return (
    <section className="load-strip" data-old={isOld} aria-label={t.names[of]}>
      <p className="load-title">
        <b>{t.names[of]}</b> <span className="soft small">{lengths.words(t.abouts[of])}</span>
      </p>
      {drawing && worst && <LoadScale of={of} drawing={drawing} />}
      {waits !== "" && (
        <p role="status" className="soft">
          {waits}
        </p>
      )}
      <p className="load-now">
        <span className="soft small">{here === "" ? t.now : t.here}</span>
        <span ref={now} className="number" hidden={here !== ""} />
        {here !== "" && <span className="number">{here}</span>}
      </p>
      {worst && (
        <p className="load-worst">
          <span className="soft small">{worst.limited && of === "speed" ? t.least : t.greatest}</span>
          <span className="number">
            <b>{loadValue(t, lengths, of, worst.value)}</b>{" "}
            <span className="load-place">{loadPlaceText(t, lengths, worst)}</span>
          </span>
          <button type="button" className="button" disabled={isOld} onClick={() => goToLoad(playback, worst)}>
            {t.go}
          </button>
        </p>
      )}
    </section>
  );
}
