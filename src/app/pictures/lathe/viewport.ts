import { wholePixels } from "../../../view/material/changed-box.ts";
import type { Patch } from "../../../view/material/pen.ts";
import { holds as holdsOnScreen } from "../../base/use-media.ts";
import { pageUnit } from "../../base/unit.ts";
import {
  fitted,
  panned,
  seenFrom,
  turnedOver,
  zoomed,
  type Bounds,
  type Camera,
  type Margin,
  type Place,
  type Size,
} from "../../../view/camera.ts";

/**
 * The camera of the picture, shared by its layers. Its pixels are units of the page, so that symbols, letters and
 * hatches grow with the page.
 */
export interface Viewport {
  readonly get: () => Camera;
  /**
   * The camera that the drawing was made for. During panning it stays behind and the drawing is only shifted; it
   * catches up at rest, or where nothing is drawn.
   */
  readonly drawn: () => Camera;
  /**
   * Canvas pixels per unit of the page for that camera. While panning at most one per CSS pixel, since copying a fine
   * canvas takes too long; at rest it is repainted at full resolution.
   */
  readonly ratio: () => number;
  /** Drawn while panning, to be redrawn finely at rest. */
  readonly isCoarse: () => boolean;
  readonly size: () => Size;
  readonly subscribe: (listener: () => void) => () => void;
  /** Moves the view by hand; from then on it is not fitted automatically. */
  readonly look: (camera: Camera) => void;
  /** Shifts the picture by pixels, by hand. */
  readonly pan: (dx: number, dy: number) => void;
  readonly zoom: (factor: number, at?: Place) => void;
  readonly fit: () => void;
  /** Zooms to a box with a margin, by hand. */
  readonly show: (bounds: Bounds) => void;
  readonly setSize: (size: Size) => void;
  /** Sets the box for fitting. A fitted picture follows, but not for every small change. */
  readonly setBounds: (bounds: Bounds) => void;
  readonly setXUp: (xUp: boolean) => void;
}

/** After this rest of the camera a shifted drawing is redrawn, ms. */
const RESTS = 140;
/** Share of width and height drawn beyond each side of a picture. */
const AROUND = 0.2;
/** Largest zoom of a shifted drawing; while zooming out the next one is drawn for this much further out. */
const GROWS = 2.2,
  AHEAD = 1.5;

/** While panning: most canvas pixels per CSS pixel, and most pixels in total. */
const COARSE = 1,
  MOST_COARSE = 2_500_000;

/** While panning, a canvas has so many pixels, or a multiple, per so many units of the page. */
const WHOLE = 4;

/** Device pixels per unit of the page. */
const fineRatio = () => devicePixelRatio * pageUnit();

/** The drawn part of a picture including its margin, on whole device pixels. */
export function drawnRoom({ width, height }: Size): Patch {
  const whole = WHOLE * wholePixels(fineRatio());
  const beside = whole * Math.round((AROUND * width) / whole),
    over = whole * Math.round((AROUND * height) / whole);
  return { x: -beside, y: -over, width: beside + width + beside, height: over + height + over };
}

/** True if a drawing for one camera can still be used for another. */
function isStillUsable(drawn: Camera, now: Camera, size: Size): boolean {
  const room = drawnRoom(size),
    { from, to, grown } = seenFrom(drawn, now, size);
  const isInside = from.x >= room.x && from.y >= room.y && to.x <= room.x + room.width && to.y <= room.y + room.height;
  return drawn.xUp === now.xUp && grown <= GROWS && isInside;
}

/** Canvas pixels per unit of the page while panning; quarters of a pixel stay whole. */
function coarseRatio(size: Size): number {
  const { width, height } = drawnRoom(size),
    most = Math.sqrt(MOST_COARSE / (width * height));
  return Math.min(COARSE * pageUnit(), fineRatio(), Math.max(1, Math.floor(WHOLE * most)) / WHOLE);
}

const START: Bounds = { left: -80, right: 20, low: 0, high: 40 };

/** Margins for the scales along two edges and the buttons at the top. */
function marginOf(size: Size): Margin {
  return size.width < 480 || size.height < 300
    ? { left: 50, right: 8, top: 14, bottom: 26 }
    : { left: 60, right: holdsOnScreen("narrow") ? 64 : 20, top: 24, bottom: 40 };
}

/** A fitted picture keeps its camera while the new box fills at least this share of it. */
const FILLS = 0.6;

/** Margin around a shown place, as a share of its size on each side. */
const ROOM = 0.75;

function withRoom({ left, right, low, high }: Bounds): Bounds {
  const by = ROOM * Math.max(right - left, high - low);
  return { left: left - by, right: right + by, low: low - by, high: high + by };
}

const holds = (outer: Bounds, inner: Bounds) =>
  inner.left >= outer.left && inner.right <= outer.right && inner.low >= outer.low && inner.high <= outer.high;
const measure = (b: Bounds) => Math.max(b.right - b.left, b.high - b.low);

/** A new viewport that shows 100 mm of axis by default. */
export function createViewport(xUp: boolean): Viewport {
  let size: Size = { width: 640, height: 400 };
  let bounds = START;
  let shown = START;
  let byHand = false;
  let camera = fitted(bounds, size, marginOf(size), xUp);
  const listeners = new Set<() => void>();
  let drawn = camera,
    isCoarse = false,
    rest: ReturnType<typeof setTimeout> | undefined;
  const set = (next: Camera, stays: Camera | null = null) => {
    clearTimeout(rest);
    camera = next;
    drawn = stays ?? next;
    if (!stays) isCoarse = false;
    for (const listener of [...listeners]) listener();
  };
  const setByHand = (next: Camera) => {
    byHand = true;
    const stays = isStillUsable(drawn, next, size),
      middle = { x: size.width / 2, y: size.height / 2 };
    if (!stays) isCoarse = true;
    set(next, stays ? drawn : next.scale < camera.scale ? zoomed(next, 1 / AHEAD, middle) : next);
    // Drawings are identified by their camera object.
    if (isCoarse || drawn !== camera) rest = setTimeout(() => set(isCoarse ? { ...camera } : camera), RESTS);
  };
  const refit = () => {
    shown = bounds;
    set(fitted(bounds, size, marginOf(size), camera.xUp));
  };

  return {
    get: () => camera,
    drawn: () => drawn,
    isCoarse: () => isCoarse,
    ratio: () => (isCoarse ? coarseRatio(size) : fineRatio()),
    size: () => size,
    subscribe(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
    look: setByHand,
    pan: (dx, dy) => setByHand(panned(camera, dx, dy)),
    zoom: (factor, at) => setByHand(zoomed(camera, factor, at ?? { x: size.width / 2, y: size.height / 2 })),
    fit() {
      byHand = false;
      refit();
    },
    show(near) {
      byHand = true;
      set(fitted(withRoom(near), size, marginOf(size), camera.xUp));
    },
    setSize(next) {
      if (next.width === size.width && next.height === size.height) return;
      size = next;
      if (byHand) set({ ...camera });
      else refit();
    },
    setBounds(next) {
      bounds = next;
      if (!byHand && (!holds(shown, next) || measure(next) < FILLS * measure(shown))) refit();
    },
    setXUp(next) {
      if (next === camera.xUp) return;
      if (byHand) set(turnedOver(camera, size));
      else {
        camera = { ...camera, xUp: next };
        refit();
      }
    },
  };
}
