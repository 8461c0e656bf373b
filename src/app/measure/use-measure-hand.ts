import { useEffect, useRef, useState } from "react";
import type { MeasureTexts } from "../../i18n/en/measure.ts";
import type { MeasuredKind, MeasuredMoment, MeasuredPlace, Measurement } from "../../kernel/measured.ts";
import { toPlace, type Place } from "../../view/camera.ts";
import { nudged } from "../../view/measure/distance.ts";
import { chainOfRing } from "../../view/measure/edges.ts";
import { gauged } from "../../view/measure/figure.ts";
import { gripOf, nextStop, snapAt, snappingOf, stopsOf, type Snapping } from "../../view/measure/snap.ts";
import { pickedWith } from "../../view/measure/tool.ts";
import { setMeasured } from "../edits.ts";
import type { Viewport } from "../lathe/viewport.ts";
import { pageUnit } from "../unit.ts";
import { holds } from "../use-media.ts";
import type { Measuring } from "./measuring.ts";
import type { MeasureSource } from "./source.ts";

/** A pointer this near to a corner or an edge means it, and a finger, units of the page. */
const REACH = 12, FINGER = 22;
/** The cross stands this far over the finger that moves it, units of the page. */
const OVER = 64;
/** One arrow key, pixels. */
const NUDGE = 2;
const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** The key of each tool. */
export const TOOL_KEYS: Readonly<Record<MeasuredKind, string>> = {
  diameter: "d",
  length: "l",
  depth: "s",
  distance: "t",
  radius: "r",
  angle: "a",
  wall: "w",
};
const KINDS = Object.keys(TOOL_KEYS) as MeasuredKind[];
/** The tools that a plane of milling has a use for: its thickness in the plane nobody asks for. */
export const toolsOf = (source: MeasureSource): readonly MeasuredKind[] => KINDS.filter((kind) => source.plane === "ZX" || kind !== "wall");

/** Where measuring is. */
export interface MeasureState {
  /** What the cross has hold of. */
  readonly cross: MeasuredPlace | null;
  readonly first: MeasuredPlace | null;
  /** What was measured last with this tool. */
  readonly done: { readonly kind: MeasuredKind; readonly places: readonly MeasuredPlace[] } | null;
  /** Why nothing was measured; empty where nothing is to be said. */
  readonly said: string;
}
const START: MeasureState = { cross: null, first: null, done: null, said: "" };

/** The edges of the picture, made anew only for another drawing or another moment. */
function useSnapping(source: MeasureSource): () => { readonly snapping: Snapping; readonly moment: MeasuredMoment | null } {
  const kept = useRef<{ source: MeasureSource; key: string; made: { snapping: Snapping; moment: MeasuredMoment | null } } | null>(null);
  return () => {
    const { plane, contours, blank, printOf } = source, now = source.moment(), print = now && printOf(now);
    const key = `${now?.step ?? "none"} ${now?.fraction ?? ""}`, known = kept.current;
    if (known?.source === source && known.key === key) return known.made;
    const isTurned = plane === "ZX";
    const same = known?.source === source ? known.made.snapping.drawing : null;
    const drawing = {
      isTurned,
      contours,
      blank: same?.blank ?? blank.map(chainOfRing),
      stock: now ? source.stock().map(chainOfRing) : [],
      path: same?.path ?? source.path(),
    };
    const made = { snapping: snappingOf(drawing), moment: now && print !== null ? { ...now, print } : null };
    kept.current = { source, key, made };
    return made;
  };
}

const nextId = (list: readonly Measurement[]): string => String(1 + list.reduce((most, { id }) => Math.max(most, Number(id) || 0), 0));

/** What pointers and keys do while a picture measures: cross, places, and the finished measurement, which goes to the work. */
export function useMeasureHand({ measuring, viewport, source, t }: { readonly measuring: Measuring; readonly viewport: Viewport;
  readonly source: MeasureSource; readonly t: MeasureTexts }): MeasureState
{
  const [state, set] = useState(START), { on, kind, choose, serve } = measuring;
  const snappingNow = useSnapping(source);
  const current = useRef(state);
  const put = (next: MeasureState) => {
    current.current = next;
    set(next);
  };
  const [shown, show] = useState(kind);
  if (shown !== kind) {
    show(kind);
    set({ ...state, first: null, done: null, said: "" });
  }
  if (!on && state !== START) set(START);
  useEffect(() => {
    current.current = state;
  });
  const held = (at: Place, reach: number): MeasuredPlace => {
    const camera = viewport.get(), { snapping } = snappingNow();
    return snapAt(snapping, toPlace(camera, at), (reach * pageUnit()) / camera.scale, gripOf(kind, snapping.drawing));
  };
  const reach = () => (holds("coarse") ? FINGER : REACH);
  const middle = () => {
    const { width, height } = viewport.size();
    return held({ x: width / 2, y: height / 2 }, REACH);
  };
  const pick = (place: MeasuredPlace, first: MeasuredPlace | null) => {
    const { snapping, moment } = snappingNow(), { isTurned } = snapping.drawing, grip = gripOf(kind, snapping.drawing);
    const picked = pickedWith(kind, snapping, place, first), no = { cross: place, first, done: null, said: t.none[grip] };
    if (picked === "nothing") return put(no);
    if ("waits" in picked) return put({ cross: place, first: picked.waits, done: null, said: "" });
    const places = picked.measured;
    if (!gauged(kind, places, isTurned)) return put(no);
    const ofStock = moment !== null && places.some(({ edge }) => edge?.of === "stock");
    setMeasured((list) => [...list, { id: nextId(list), kind, plane: source.plane, places, ...(ofStock && { moment }) }]);
    put({ cross: place, first: null, done: { kind, places }, said: "" });
  };
  const needsTwo = kind === "length" || kind === "depth" || kind === "distance" || kind === "angle";
  const hand = {
    tap: (at: Place) => pick(held(at, reach()), current.current.first),
    hover: (at: Place | null) => {
      if (at) put({ ...current.current, cross: held(at, REACH) });
    },
    drag(from: Place, to: Place, done: boolean, byFinger?: boolean) {
      if (byFinger) {
        const place = held({ x: to.x, y: to.y - OVER * pageUnit() }, REACH);
        return done ? pick(place, current.current.first) : put({ ...current.current, cross: place });
      }
      const [a, b] = [held(from, REACH), held(to, REACH)];
      if (done) pick(b, needsTwo ? a : null);
      else put({ cross: b, first: needsTwo ? a : null, done: null, said: "" });
    },
    key(name: string) {
      const { scale, xUp } = viewport.get(), cross = current.current.cross ?? middle(), arrow = ARROWS[name], letter = name.toLowerCase();
      const tool = toolsOf(source).find((each) => TOOL_KEYS[each] === letter);
      if (name === "Escape" && current.current.first) put({ ...current.current, first: null });
      else if (name === "Enter") {
        const { snapping } = snappingNow(), grip = gripOf(kind, snapping.drawing), isPlace = grip === "point" || grip === "surface";
        pick(isPlace || cross.edge ? cross : snapAt(snapping, cross.at, REACH / scale, grip), current.current.first);
      } else if (letter === "n" || letter === "p") {
        const { snapping } = snappingNow();
        const stop = nextStop(stopsOf(snapping, gripOf(kind, snapping.drawing)), cross.at, letter === "n" ? 1 : -1);
        put({ ...current.current, cross: stop ?? cross, said: stop ? "" : t.none[gripOf(kind, snapping.drawing)] });
      } else if (arrow) {
        const { snapping } = snappingNow(), to = nudged(cross.at, (arrow[0] * NUDGE) / scale, ((xUp ? 1 : -1) * arrow[1] * NUDGE) / scale);
        put({ ...current.current, cross: snapAt(snapping, to, NUDGE / scale / 2, gripOf(kind, snapping.drawing)) });
      } else if (tool) choose(tool);
      else return false;
      return true;
    },
  };
  useEffect(() => {
    serve(on ? hand : null);
    return () => serve(null);
  });
  return state;
}
