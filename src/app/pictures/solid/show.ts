import type { Clamped } from "../../../kernel/area/clamping.ts";
import type { Ring, Segment } from "../../../kernel/geometry/point.ts";
import type { Step } from "../../../kernel/time/step.ts";
import type { Tool } from "../../../kernel/plan/tool.ts";
import type { SpindleFrom } from "../../../sim/load/spindles.ts";
import type { PlayPosition, Simulation } from "../../../sim/simulation.ts";
import { boundsOf, joined } from "../../../view/bounds.ts";
import type { Bounds, Size } from "../../../view/camera.ts";
import { statedSteps } from "../../../view/solid/bodies.ts";
import { chuckParts, toolParts } from "../../../view/solid/machine-parts.ts";
import { chordsFor } from "../../../view/solid/revolve.ts";
import {
  shownBodies,
  type BodiesRequest,
  type ShownBodies,
  type SolidNotes,
} from "../../../view/solid/shown-bodies.ts";
import { THREAD_FINENESS } from "../../../view/solid/threaded.ts";
import { runThreads, type RunThreads } from "../../../view/solid/thread-cuts.ts";
import type { TonedSide } from "../../../view/solid/tones.ts";
import { UNTOUCHED } from "../../../view/material/surfaces.ts";
import { tipAt } from "../../../view/tip.ts";
import { stopwatch, type Clock } from "../../base/clock.ts";
import { pageUnit } from "../../base/unit.ts";
import { stepIndex, type PlayedScene, type InitialScene } from "../../calculation/moving.ts";
import { knownOf } from "../lathe/played-layer.ts";
import { bodySource, isSameNotes } from "./body-source.ts";
import type { Eye } from "./eye.ts";
import type { StageLines } from "./path-stage.ts";
import { createSharpness } from "./sharpness.ts";
import type { SolidStage } from "./stage.ts";

/** Content of the view. */
export interface ShownWork {
  readonly moving: PlayedScene | null;
  readonly simulation: Simulation | null;
  /** The blank and the tool at its start, while nothing moves. */
  readonly waiting: InitialScene | null;
  readonly blank: readonly Ring[];
  /** Its clamping, how far that is drawn, and what of it should be visible; null if not stated. */
  readonly clamping: { readonly of: Clamped; readonly cut: Bounds; readonly seen: Bounds } | null;
  readonly steps: readonly Step[];
  readonly spindles: readonly SpindleFrom[];
  readonly contours: readonly (readonly Segment[])[];
}

export const NOTHING_TOLD: SolidNotes = { hasRings: false, leftHanded: false, textures: [], highlighted: [] };

/** Connects work and eye to a stage, and draws only after changes. */
export interface Show {
  readonly setWork: (work: ShownWork) => void;
  readonly setLines: (lines: readonly StageLines[]) => void;
  /** Sets the tones of surfaces in the colour map. */
  readonly setTones: (tones: readonly TonedSide[]) => void;
  readonly setLook: (look: { readonly quarterCut: boolean; readonly xDown: boolean }) => void;
  /** Sets the size of the canvas, and how much of it is below the picture, under the buttons. */
  readonly setSize: (size: Size, below: number) => void;
  /** Redraws after another change: colours, the context. */
  readonly refresh: () => void;
  readonly end: () => void;
}

/** Chords of a full turn while the body changes with every frame; shading then gives the roundness. */
const QUICK = 64;
/**
 * During playback a body is rebuilt after this many times its build time, so that most of the time is left for frames.
 */
const PAUSE = 3;
/** Most pixels drawn, and the highest ratio to CSS pixels. */
const PIXELS = { most: 2_600_000, ratio: 2 } as const;
/** Without a frame for this time, or this many times the last frame time, everything is drawn sharp. */
const REST = { ms: 160, times: 3 } as const;

const nothingMoves = (): readonly Ring[] => [];

/** `tell` is called with the notes on the picture whenever they change. */
export function createShow(stage: SolidStage, eye: Eye, clock: Clock, tell: (told: SolidNotes) => void): Show {
  let work: ShownWork | null = null;
  let threads: RunThreads | null = null;
  let [quarterCut, xDown] = [true, false];
  /** Tones of surfaces, and a counter of their changes. */
  let [tones, toneTurn]: [readonly TonedSide[], number] = [[], 0];
  let [box, seen]: [Bounds | null, Bounds | null] = [null, null];
  let [drawnRings, drawnKey, drawnTool]: [readonly Ring[], string, Tool | null] = [[], "", null];
  /** The moment of the shown stock, and its look. */
  let seenAt: { readonly moving: PlayedScene; readonly position: PlayPosition; readonly look: string } | null = null;
  const source = bodySource();
  let [builtAt, cost] = [-Infinity, 0];
  let canvas: { readonly size: Size; readonly below: number } = { size: eye.size(), below: 0 };
  let [asked, changed]: [(() => void) | null, boolean] = [null, true];
  let [coarse, learned] = [1, 1];
  const sharpness = createSharpness();
  let [lastPicture, took]: [number, number] = [-Infinity, 0];
  let resting: ReturnType<typeof setTimeout> | undefined;
  let told = NOTHING_TOLD;
  let heard: (() => void)[] = [];

  const playing = () => work?.moving?.playback.get().playing ?? false;
  /** Canvas pixels per unit of the page. */
  const sharpRatio = ({ width, height }: Size) =>
    Math.min(
      Math.min(devicePixelRatio, PIXELS.ratio) * pageUnit(),
      Math.sqrt(PIXELS.most / Math.max(1, width * height)),
    );

  const atOf = (moving: PlayedScene | null): PlayPosition => moving?.playback.shown() ?? { step: 0, fraction: 0 };

  function draw({ bodies, notes: now }: ShownBodies): void {
    stage.setBodies(bodies);
    if (!isSameNotes(now, told)) tell((told = now));
  }

  /** The view of a moment; `look` names all of it except the stock. With X downwards the picture is mirrored. */
  function wanted({ moving, simulation, steps }: ShownWork) {
    const position = atOf(moving),
      high = box?.high ?? 1,
      chords = playing() ? Math.min(QUICK, chordsFor(high)) : chordsFor(high);
    const faults =
      simulation?.findings.filter((f) => f.step < position.step || (f.step === position.step && position.fraction > 0))
        .length ?? 0;
    const look = [chords, quarterCut, xDown, toneTurn].join(),
      moment = [faults, position.step >= steps.length, playing() || position.step].join();
    const asked: BodiesRequest = {
      position,
      size: box ? Math.max(box.right - box.left, box.high) : 1,
      turning: {
        chords,
        quarterCut,
        hand: xDown ? -1 : 1,
        ...THREAD_FINENESS[playing() ? "playing" : "resting"],
      },
      tones,
    };
    return { look, key: `${look} ${moment}`, asked };
  }

  /** Builds the bodies of the moment on the page, unless they are already there. */
  function buildHere(of: ShownWork): void {
    const { moving, simulation, waiting } = of,
      { look, key, asked } = wanted(of),
      { position } = asked;
    const rings = moving ? moving.stockAt(position) : (waiting?.blank ?? nothingMoves());
    // A planned run shows the previous stock, with its threads and colours.
    const stands = moving && !simulation && seenAt?.look === look && seenAt.moving.stockAt(seenAt.position) === rings;
    if (stands || (rings === drawnRings && key === drawnKey)) return;
    source.forget();
    draw(
      shownBodies(rings, { simulation: moving && simulation, threads, surfaces: moving?.surfaces ?? UNTOUCHED }, asked),
    );
    [drawnRings, drawnKey] = [rings, key];
    seenAt = moving && { moving, position, look };
  }

  /** Gets the bodies of the moment, from the worker if it knows the work. */
  function build(): void {
    changed = false;
    const now = work,
      moving = now?.moving ?? null;
    const known = now?.simulation && moving && clock.flows ? knownOf(moving.steps, "lathe") : null;
    if (!now) return;
    if (!known || !moving) return buildHere(now);
    const { look, key, asked } = wanted(now),
      { position } = asked;
    source.ask(known, { ...asked, look: key }, (made) => {
      if (!made) buildHere(now);
      else {
        if (made !== "same") draw(made);
        [drawnRings, drawnKey] = [[], ""];
        seenAt = { moving, position, look };
      }
      ask();
    });
  }

  function placeTool(): void {
    if (!work) return;
    const { moving, waiting } = work,
      position = moving?.playback.shown();
    const tip = moving && position ? tipAt(moving.steps, position) : (waiting?.start ?? null);
    const tool =
      moving && position ? (moving.steps[stepIndex(moving.steps, position)]?.tool ?? null) : (waiting?.tool ?? null);
    if (tool !== drawnTool) stage.setTool(tool ? toolParts(tool) : []);
    drawnTool = tool;
    stage.placeTool(tool && tip);
    stage.setChip(moving && position && work.simulation ? moving.chipAt(position) : null);
    stage.setStep(position?.step ?? 0);
  }

  function setCoarse(share: number): void {
    if (share === coarse) return;
    coarse = share;
    stage.setShare(share);
  }

  /**
   * Lowers the resolution of a moving picture if its frames are late. A frame takes until the next one may begin: a
   * movement of the pointer comes just before its frame, however late that is.
   */
  function adaptSharpness(begun: number): void {
    if (playing() || begun - lastPicture < Math.max(REST.ms, REST.times * took)) {
      setCoarse(learned);
      clock.frame(() => {
        took = stopwatch() - begun;
        learned = sharpness.noteFrame(took);
      });
    }
    lastPicture = begun;
  }

  function picture(): void {
    asked = null;
    const begun = stopwatch();
    adaptSharpness(begun);
    if (changed && !source.isAsked() && (!playing() || begun - builtAt > PAUSE * cost)) {
      build();
      builtAt = stopwatch();
      cost = builtAt - begun;
    }
    placeTool();
    const { centre } = eye.get(),
      wide = box ? Math.hypot(box.right - box.left, box.high) : 1;
    const tip = work?.moving && tipAt(work.moving.steps, work.moving.playback.shown());
    stage.draw(
      eye.get(),
      eye.size(),
      2 * wide + Math.hypot(centre[2], centre[1], centre[0]) + (tip ? Math.hypot(tip.z, tip.r) : 0),
    );
    if (changed && !source.isAsked()) ask();
    clearTimeout(resting);
    if (coarse < 1) resting = setTimeout(sharpen, Math.max(REST.ms, REST.times * took));
  }

  function sharpen(): void {
    if (asked || playing()) return;
    setCoarse(1);
    ask();
  }

  function ask(): void {
    if (asked) return;
    asked = clock.frame(picture);
  }
  /** Fits the view: to a whole body, or to lines on the side of the tool. */
  function fit(): void {
    if (!seen) return;
    const isFlat = work?.blank.length === 0;
    eye.setBounds(isFlat && xDown ? { ...seen, low: -seen.high, high: -seen.low } : seen, isFlat);
  }
  const changeWork = () => {
    changed = true;
    ask();
  };

  const deaf = eye.subscribe(ask);
  return {
    setWork(next) {
      for (const stop of heard) stop();
      work = next;
      const { moving, simulation } = next;
      threads =
        moving && simulation
          ? runThreads(next.steps, moving.stockAt, { stated: statedSteps(simulation), spindles: next.spindles })
          : null;
      [drawnRings, drawnKey] = [[], ""];
      source.forget();
      const { clamping } = next;
      stage.setChuck(clamping ? chuckParts(clamping.of, clamping.cut) : []);
      box = joined(boundsOf(next.blank.flat()), boundsOf(next.contours.flat().flatMap((s) => [s.from, s.to])));
      const isFlat = next.blank.length === 0;
      if (isFlat)
        box = joined(
          box,
          boundsOf(next.steps.flatMap(({ from, move }) => (move.kind === "rapid" ? [] : [from, move.to]))),
        );
      seen = joined(box, clamping?.seen ?? null);
      fit();
      heard = next.moving ? [next.moving.playback.subscribe(changeWork)] : [];
      changeWork();
    },
    setLines(lines) {
      stage.setLines(lines);
      ask();
    },
    setTones(next) {
      if (next.length === 0 && tones.length === 0) return;
      [tones, toneTurn] = [next, toneTurn + 1];
      changeWork();
    },
    setLook(look) {
      [quarterCut, xDown] = [look.quarterCut, look.xDown];
      stage.turnOver(look.xDown);
      fit();
      changeWork();
    },
    setSize(size, below) {
      canvas = { size, below };
      eye.setSize({ width: size.width, height: Math.max(1, size.height - below) });
      stage.setSize(canvas.size, canvas.below, sharpRatio(canvas.size));
      // Resizing clears a canvas, so it is redrawn before anybody sees that.
      asked?.();
      picture();
    },
    refresh: changeWork,
    end() {
      deaf();
      source.forget();
      for (const stop of heard) stop();
      clearTimeout(resting);
      asked?.();
      asked = null;
    },
  };
}
