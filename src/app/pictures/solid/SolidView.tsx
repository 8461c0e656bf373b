import { useEffect, useId, useMemo, useRef, useState, type ReactNode } from "react";
import type { Run } from "../../../program/state/run-types.ts";
import type { SolidTexts } from "../../../i18n/en/solid.ts";
import { pathInSpace, segmentsInSpace } from "../../../view/solid/path-lines.ts";
import type { SolidNotes } from "../../../view/solid/shown-bodies.ts";
import { NAMED_VIEWS } from "../../../view/solid/orbit.ts";
import { tonedSides, type TonedSide } from "../../../view/solid/tones.ts";
import type { Clock } from "../../base/clock.ts";
import type { PicturePlace } from "../lathe/places.ts";
import { PlaceLines } from "../lathe/PlaceButtons.tsx";
import { pageColours, useTheme } from "../../base/use-theme-colours.ts";
import { LoadPart } from "../load/LoadParts.tsx";
import { useLoadDrawing } from "../load/use-drawing.ts";
import { useLoadOf } from "../load/use-load.ts";
import { reducedMotion } from "../../base/settings/appearance.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { changeSettings, useSettings } from "../../base/settings/settings.ts";
import { pageUnit, sizeOf } from "../../base/unit.ts";
import { useViewBox } from "../lathe/use-view-box.ts";
import type { PlaceProjection, Sight } from "../lathe/place-projection.ts";
import { createEye, spaceProjection, type Eye } from "./eye.ts";
import { listenToHands } from "./hands.ts";
import { createShow, NOTHING_TOLD, type Show, type ShownWork } from "./show.ts";
import type { StageLines } from "./path-stage.ts";
import { createStage, STAGE_COLOURS, type SolidStage } from "./stage.ts";
import "./solid.css";

interface Props {
  readonly work: ShownWork;
  readonly run: Run;
  /** The visible moves. */
  readonly lines: (step: number) => boolean;
  /** Text about the moment. */
  readonly state: string;
  readonly clock: Clock;
  /** Findings and residual material, as marks over the body. */
  readonly places: readonly PicturePlace[];
  /** Called with the sight of the view once it is drawn, and with null if the section has to replace it. */
  readonly onDrawn: (drawn: Sight | null) => void;
  /** Over the body. */
  readonly children: ReactNode;
}

/** The turned body in space. If it cannot be drawn the view says so, and the section below stays visible. */
export function SolidView(props: Props) {
  const t = useTexts("solid"),
    [tries, tryAgain] = useState(0);
  return <SolidPicture key={tries} {...props} t={t} again={() => tryAgain(tries + 1)} />;
}

type Trouble = "missing" | "lost" | null;

interface Running {
  readonly stage: SolidStage;
  readonly eye: Eye;
  readonly show: Show;
}

/** Creates stage, eye and show on a canvas, for as long as it exists. */
function useRunning(clock: Clock, setTrouble: (trouble: Trouble) => void) {
  const field = useRef<HTMLDivElement>(null),
    canvas = useRef<HTMLCanvasElement>(null);
  const [running, run] = useState<Running | null>(null);
  const [told, tell] = useState(NOTHING_TOLD);
  useEffect(() => {
    const [element, drawn] = [field.current, canvas.current];
    const stage = drawn && createStage(drawn);
    if (!element || !drawn || !stage) {
      setTrouble("missing");
      return undefined;
    }
    const eye = createEye(clock, () => reducedMotion(useSettings.getState())),
      show = createShow(stage, eye, clock, tell);
    const measure = () => {
      const size = sizeOf(element),
        unit = pageUnit();
      const buttons = element.querySelector<HTMLElement>(".solid-foot");
      if (size.width > 0 && size.height > 0) show.setSize(size, buttons ? size.height - buttons.offsetTop / unit : 0);
    };
    const sizes = new ResizeObserver(measure),
      deaf = listenToHands(element, eye);
    sizes.observe(element);
    const lost = (event: Event) => {
      event.preventDefault();
      setTrouble("lost");
    };
    const back = () => {
      setTrouble(null);
      show.refresh();
    };
    drawn.addEventListener("webglcontextlost", lost);
    drawn.addEventListener("webglcontextrestored", back);
    run({ stage, eye, show });
    return () => {
      drawn.removeEventListener("webglcontextlost", lost);
      drawn.removeEventListener("webglcontextrestored", back);
      sizes.disconnect();
      deaf();
      eye.end();
      show.end();
      stage.dispose();
    };
  }, [clock, setTrouble]);
  return { field, canvas, running, told };
}

const NO_TONES: readonly TonedSide[] = [];

/**
 * Path and colour map as lines in space; with a colour map the path is faint. Values of surfaces colour the surfaces
 * too.
 */
function useColouredLines(
  run: Run,
  shown: (step: number) => boolean,
): { readonly lines: readonly StageLines[]; readonly tones: readonly TonedSide[] } {
  const colours = useSettings((s) => s.colours),
    told = useLoadDrawing(run, colours === "none" ? null : colours, shown);
  const surface = useLoadOf(run)?.surface;
  const path = useMemo(
    () => pathInSpace(run.steps, shown).map(({ role, ...lines }): StageLines => ({ ...lines, look: { role } })),
    [run, shown],
  );
  const lines = useMemo(
    () => [
      ...path,
      ...(told?.lines.map(({ tone, segments }): StageLines => ({ ...segmentsInSpace(segments), look: { tone } })) ??
        []),
    ],
    [path, told],
  );
  const tones = useMemo(
    () => (told && surface && colours === "roughness" ? tonedSides(surface, told.scale) : NO_TONES),
    [told, surface, colours],
  );
  return { lines, tones };
}

/** Notes on the picture: the meaning of its surfaces, and deviations from the shop. */
function Notes({
  told: { textures, highlighted, hasRings, leftHanded },
  milled,
  noBlank,
  t,
}: {
  readonly told: SolidNotes;
  readonly milled: boolean;
  readonly noBlank: boolean;
  readonly t: SolidTexts;
}) {
  const said = [noBlank && t.noBlank, milled && t.milled, hasRings && t.threads, leftHanded && t.left].filter(
    (each) => each !== false,
  );
  return (
    <div className="solid-notes small soft">
      {textures.length + highlighted.length > 1 && (
        <ul className="solid-surfaces" aria-label={t.surfaces}>
          {textures.map((texture) => (
            <li key={texture} className={`solid-${texture}`}>
              {t.textures[texture]}
            </li>
          ))}
          {highlighted.map((mark) => (
            <li key={mark} className={`solid-${mark}`}>
              {t.marked[mark]}
            </li>
          ))}
        </ul>
      )}
      {said.map((each) => (
        <p key={each}>{each}</p>
      ))}
    </div>
  );
}

/** Lines and numbers over the body. */
function Marks({ run, seeing, places }: Pick<Props, "run" | "places"> & { readonly seeing: PlaceProjection }) {
  return (
    <svg className="solid-marks" viewBox={useViewBox(seeing)} aria-hidden="true">
      <LoadPart.Mark run={run} seeing={seeing} />
      <PlaceLines seeing={seeing} places={places} />
    </svg>
  );
}

function SolidPicture({
  work,
  run,
  lines: shown,
  state,
  clock,
  places,
  onDrawn,
  children,
  t,
  again,
}: Props & { readonly t: SolidTexts; readonly again: () => void }) {
  const keys = useId(),
    theme = useTheme();
  const { quarterCut, xDown } = useSettings();
  const [trouble, setTrouble] = useState<Trouble>(null);
  const { field, canvas, running, told } = useRunning(clock, setTrouble);
  useEffect(() => running?.stage.setColours(pageColours(STAGE_COLOURS)), [running, theme]);
  useEffect(() => running?.show.setLook({ quarterCut, xDown }), [running, quarterCut, xDown, theme]);
  useEffect(() => running?.show.setWork(work), [running, work]);
  const { lines, tones } = useColouredLines(run, shown);
  useEffect(() => running?.show.setLines(lines), [running, lines]);
  useEffect(() => running?.show.setTones(tones), [running, tones]);
  const seeing = useMemo(() => running && spaceProjection(running.eye, xDown), [running, xDown]);
  useEffect(() => {
    if (!seeing || trouble) return undefined;
    onDrawn(seeing);
    return () => onDrawn(null);
  }, [seeing, trouble, onDrawn]);
  return (
    <>
      <div
        ref={field}
        className="solid-field"
        role="group"
        tabIndex={trouble ? -1 : 0}
        aria-label={t.title}
        aria-describedby={keys}
        data-keys="solid"
        hidden={trouble !== null}
      >
        <canvas ref={canvas} role="img" aria-label={t.picture(quarterCut, state)} />
        <p id={keys} className="unseen">
          {t.keys}
        </p>
        {seeing && <Marks run={run} seeing={seeing} places={places} />}
        {children}
        <div className="solid-foot">
          <Notes told={told} milled={run.plane.length > 0} noBlank={work.blank.length === 0} t={t} />
          <div className="solid-views" role="group" aria-label={t.views}>
            <button
              type="button"
              className="button"
              aria-label={t.quarter}
              title={t.quarter}
              aria-pressed={quarterCut}
              onClick={() => changeSettings({ quarterCut: !quarterCut })}
            >
              {t.quarterShort}
            </button>
            {NAMED_VIEWS.map((view) => (
              <button key={view} type="button" className="button" onClick={() => running?.eye.go(view)}>
                {t[view]}
              </button>
            ))}
          </div>
        </div>
      </div>
      {trouble && (
        <div role="status" className="solid-trouble small">
          <p>{t[trouble]}</p>
          <button type="button" className="button" onClick={again}>
            {t.again}
          </button>
        </div>
      )}
    </>
  );
}
