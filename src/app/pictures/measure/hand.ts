import type { MeasureTexts } from "../../../i18n/en/measure.ts";
import type { MeasuredKind, MeasuredMoment, MeasuredPlace, Measurement } from "../../../kernel/plan/measured.ts";
import { part } from "../../../kernel/geometry/point.ts";
import { toPlace, type Place } from "../../../view/camera.ts";
import { nudged } from "../../../view/measure/distance.ts";
import { chainOfRing } from "../../../view/measure/edges.ts";
import { measuredFigure } from "../../../view/measure/figure.ts";
import {
  snapTargetOf,
  nextStop,
  snapAt,
  snappingOf,
  stopsOf,
  type SnapTarget,
  type Snapping,
} from "../../../view/measure/snap.ts";
import { pickedWith } from "../../../view/measure/tool.ts";
import { measuredIn, setMeasured } from "../../document/edits.ts";
import type { Viewport } from "../lathe/viewport.ts";
import { useEditor } from "../../document/store.ts";
import { holds } from "../../base/use-media.ts";
import { TOOL_KEYS, type MeasureHand, type Measuring, type MeasureState } from "./measuring.ts";
import type { MeasureSource } from "./source.ts";

/** Distance at which a pointer snaps to a corner or an edge, and a finger, units of the page. */
const REACH = 12,
  FINGER = 22;
/** Distance of the cross above the finger that moves it, units of the page. */
const OVER = 64;
/** Step of an arrow key, pixels. */
const NUDGE = 2;
/** After a key has moved the cross, a smaller mouse movement is ignored, pixels. */
const TREMBLES = 4;
const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

const KINDS = Object.keys(TOOL_KEYS) as MeasuredKind[];
/** The tools for a picture; a milled plane needs no thickness. */
export const toolsOf = (source: MeasureSource): readonly MeasuredKind[] =>
  KINDS.filter((kind) => source.plane === "ZX" || kind !== "wall");

interface Snapped {
  readonly snapping: Snapping;
  readonly moment: MeasuredMoment | null;
}

/** The edges of the picture, cached per drawing and moment. */
function snappingIn(sourceNow: () => MeasureSource): () => Snapped {
  let kept: { readonly source: MeasureSource; readonly key: string; readonly made: Snapped } | null = null;
  return () => {
    const source = sourceNow(),
      { plane, contours, blank, fingerprintOf } = source,
      now = source.moment(),
      print = now && fingerprintOf(now);
    const key = `${now?.step ?? "none"} ${now?.fraction ?? ""}`,
      known = kept?.source === source ? kept : null;
    if (known?.key === key) return known.made;
    const drawing = {
      isTurned: plane === "ZX",
      contours,
      blank: known?.made.snapping.drawing.blank ?? blank.map(chainOfRing),
      stock: now ? source.stock().map(chainOfRing) : [],
      path: known?.made.snapping.drawing.path ?? source.path(),
    };
    const made = { snapping: snappingOf(drawing), moment: now && print !== null ? { ...now, print } : null };
    kept = { source, key, made };
    return made;
  };
}

const nextId = (list: readonly Measurement[]): string =>
  String(1 + list.reduce((most, { id }) => Math.max(most, Number(id) || 0), 0));

/** A repeated measurement is shown once. */
const isSame = (a: Omit<Measurement, "id">, b: Omit<Measurement, "id">): boolean =>
  a.kind === b.kind &&
  a.plane === b.plane &&
  JSON.stringify([a.places, a.moment]) === JSON.stringify([b.places, b.moment]);

/** The measurable content of the picture, as it is shown now. */
export interface MeasurePlace {
  readonly viewport: Viewport;
  readonly source: () => MeasureSource;
  readonly texts: () => MeasureTexts;
}

/**
 * Pointers and keys of a measuring picture: cross, places, and the finished measurement, which is added to the work.
 */
export function measureHand(
  { state, choose }: Pick<Measuring, "state" | "choose">,
  { viewport, source, texts }: MeasurePlace,
): MeasureHand {
  const snapped = snappingIn(source),
    get = state.getState;
  const put = (next: Partial<MeasureState>) => state.setState(next);
  const gripNow = (): SnapTarget => snapTargetOf(get().kind, { isTurned: source().plane === "ZX" });
  const held = (at: Place, reach: number): MeasuredPlace => {
    const camera = viewport.get();
    return snapAt(snapped().snapping, toPlace(camera, at), reach / camera.scale, gripNow());
  };
  const pick = (place: MeasuredPlace, first: MeasuredPlace | null) => {
    const { snapping, moment } = snapped(),
      { kind } = get();
    const picked = pickedWith(kind, snapping, place, first),
      none = { cross: place, first, done: null, said: texts().none[gripNow()] };
    if (picked === "nothing") return put(none);
    if (picked === "level" || picked === "parallel") return put({ ...none, said: texts().none[picked] });
    if ("waits" in picked) return put({ cross: place, first: picked.waits, done: null, said: "" });
    const places = picked.measured;
    if (!measuredFigure(kind, places, snapping.drawing.isTurned)) return put(none);
    const ofStock = moment !== null && places.some(({ edge }) => edge?.of === "stock");
    const made = { kind, plane: source().plane, places, ...(ofStock && { moment }) };
    const again = measuredIn(useEditor.getState()).find((each) => isSame(each, made));
    if (!again) setMeasured((list) => [...list, { id: nextId(list), ...made }]);
    put({ cross: place, first: null, done: { kind, places: again?.places ?? places }, said: "" });
  };
  const takesTwo = () => ["length", "depth", "distance", "angle"].includes(get().kind);

  /** Last position of the mouse, and its position when keys took over the cross; moving it takes the cross back. */
  let mouse: Place | null = null,
    stood: Place | null = null,
    hasKeys = false;
  const keysTake = () => {
    hasKeys = true;
    stood = mouse;
  };
  const byKeys = (next: Partial<MeasureState>) => {
    keysTake();
    put(next);
  };
  const isMoved = (to: Place): boolean => {
    mouse = to;
    if (hasKeys) {
      stood ??= to;
      hasKeys = Math.hypot(to.x - stood.x, to.y - stood.y) < TREMBLES;
    }
    return !hasKeys;
  };

  const walk = (way: 1 | -1) => {
    const stops = stopsOf(snapped().snapping, gripNow()),
      { cross } = get();
    const stop = cross ? nextStop(stops, cross.at, way) : stops.at(way > 0 ? 0 : -1);
    byKeys(stop ? { cross: stop, said: "" } : { said: texts().none[gripNow()] });
  };
  /** Start of the cross after Enter: the centre, or for a tool that snaps to edges the nearest edge. */
  const middle = (): MeasuredPlace => {
    const { width, height } = viewport.size(),
      place = held({ x: width / 2, y: height / 2 }, REACH),
      grip = gripNow();
    if (grip === "point" || place.edge) return place;
    const far = (stop: MeasuredPlace) => part.apart(stop.at, place.at);
    return stopsOf(snapped().snapping, grip).toSorted((a, b) => far(a) - far(b))[0] ?? place;
  };
  const nudge = ([z, r]: readonly [number, number]) => {
    const { scale, xUp } = viewport.get(),
      from = get().cross ?? middle();
    const to = nudged(from.at, (z * NUDGE) / scale, ((xUp ? 1 : -1) * r * NUDGE) / scale);
    byKeys({ cross: snapAt(snapped().snapping, to, NUDGE / scale / 2, gripNow()) });
  };
  const pickHeld = () => {
    const { cross, first } = get(),
      grip = gripNow(),
      isPlace = grip === "point" || grip === "surface";
    // Nothing invisible is measured, so the cross is shown first.
    if (!cross) return byKeys({ cross: middle() });
    keysTake();
    pick(
      isPlace || cross.edge ? cross : snapAt(snapped().snapping, cross.at, REACH / viewport.get().scale, grip),
      first,
    );
  };

  return {
    tap(at) {
      hasKeys = false;
      pick(held(at, holds("coarse") ? FINGER : REACH), get().first);
    },
    hover: (at) => {
      if (at && isMoved(at)) put({ cross: held(at, REACH) });
    },
    drag(from, to, done, byFinger) {
      hasKeys = false;
      if (byFinger) {
        const place = held({ x: to.x, y: to.y - OVER }, REACH);
        return done ? pick(place, get().first) : put({ cross: place });
      }
      const [a, b] = [held(from, REACH), held(to, REACH)],
        first = takesTwo() ? a : null;
      if (done) pick(b, first);
      else put({ cross: b, first, done: null, said: "" });
    },
    key(name) {
      const letter = name.toLowerCase(),
        arrow = ARROWS[name],
        tool = toolsOf(source()).find((each) => TOOL_KEYS[each] === letter);
      if (name === "Escape" && get().first) put({ first: null });
      else if (name === "Enter") pickHeld();
      else if (letter === "n" || letter === "p") walk(letter === "n" ? 1 : -1);
      else if (arrow) nudge(arrow);
      else if (tool) choose(tool);
      else return false;
      return true;
    },
  };
}
