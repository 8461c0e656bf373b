import { part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { radians } from "../../kernel/units.ts";
import { toScreen, type Camera, type Place, type Size } from "../camera.ts";
import { arrange, type Item, type Spot } from "../dimensions/arrange.ts";
import { textWidth, type LabelBox } from "../dimensions/labels.ts";
import { arcPath, arrowHead, polyline } from "../help/marks.ts";

/** What a dimension measures, and where on the part. Angles are degrees, counter-clockwise from +Z. */
export type Measured =
  | { readonly kind: "diameter" | "axial"; readonly at: Pt }
  | { readonly kind: "length"; readonly from: Pt; readonly to: Pt }
  | { readonly kind: "angle"; readonly at: Pt; readonly angle: number }
  | { readonly kind: "size"; readonly on: Segment };

export interface DimensionRequest {
  readonly key: string;
  readonly text: string;
  readonly measured: Measured;
  /** Always placed, as for the chosen element; others only where there is room. */
  readonly needed: boolean;
}

/** A dimension on the sheet: the box of its text, its thin lines and its filled arrowheads; CSS pixels. */
export interface PlacedDimension {
  readonly key: string;
  readonly box: LabelBox;
  readonly lines: string;
  readonly arrows: string;
}

/** The drawing that dimensions are put on. */
export interface DimensionSheet {
  readonly camera: Camera;
  readonly size: Size;
  /** Space that the scales take at the left and the lower edge. */
  readonly scales: { readonly left: number; readonly below: number };
  /** Least size of a text that can be clicked. */
  readonly target: Size;
  /** Boxes that no text may cover. */
  readonly kept: readonly LabelBox[];
  /** Left and upper edge of the areas that the contour leaves free: diameters stand on the right, positions below. */
  readonly free: Place;
  /** Points along the contour that a text should avoid. */
  readonly avoid: readonly Place[];
}

/** Text size of a dimension, pixels. */
export const DIMENSION_TEXT = 13;
const PAD = 14;
/** Gap between the point and its extension line, and room between the line and the text, pixels. */
const GAP = 6,
  AIR = 4;
/** Distances at which a dimension line may run beside its element, pixels. */
const OFFSETS = [30, 52, 76, 104] as const;
const ARC = 38;

/** A candidate place for a text. Its lines are only drawn once it is taken: most are not. */
interface Candidate extends Pick<PlacedDimension, "box"> {
  readonly draw: () => Pick<PlacedDimension, "lines" | "arrows">;
}

const boxAt = ({ target }: DimensionSheet, text: string, middle: Place): LabelBox => {
  const width = Math.max(target.width, Math.ceil(textWidth(text, DIMENSION_TEXT)) + PAD),
    { height } = target;
  return { x: middle.x - width / 2, y: middle.y - height / 2, width, height };
};

/** The box moved to where it is whole, clear of the scales. */
function inside(box: LabelBox, { size, scales }: DimensionSheet): LabelBox {
  const [right, floor] = [size.width - box.width - 2, size.height - scales.below - box.height - 2];
  return { ...box, x: Math.max(scales.left + 2, Math.min(box.x, right)), y: Math.max(2, Math.min(box.y, floor)) };
}

/** Shifts along an edge, the nearest first: by none, then up to twice the label to either side. */
const shifts = (by: number): readonly number[] => [0, 0.5, -0.5, 1, -1, 1.5, -1.5, 2, -2].map((k) => k * by);

/** ⌀: a text at the right edge, a thin line from the point to it. */
function diameters(sheet: DimensionSheet, text: string, at: Place): Candidate[] {
  const free = boxAt(sheet, text, at),
    x = Math.max(at.x + 2 * GAP, Math.min(sheet.size.width - free.width - AIR, sheet.free.x));
  return shifts(free.height + 1).map((by) => {
    const box = inside({ ...free, x, y: free.y + by }, sheet),
      y = box.y + box.height / 2;
    const knee = Math.max(at.x + GAP, x - 16);
    return {
      box,
      draw: () => ({
        lines: polyline([
          { x: at.x + GAP, y: at.y },
          { x: knee, y: at.y },
          { x, y },
        ]),
        arrows: "",
      }),
    };
  });
}

/** Z: a text at the lower edge, in one of two rows, a thin line from the point down to it. */
function positions(sheet: DimensionSheet, text: string, at: Place): Candidate[] {
  const free = boxAt(sheet, text, at),
    floor = sheet.size.height - sheet.scales.below - AIR;
  const top = Math.min(sheet.free.y, floor - free.height),
    two = top + 2 * free.height + 1 <= floor;
  return (two ? [0, 1] : [0]).flatMap((row) => {
    const y = top + row * (free.height + 1);
    return shifts(free.width + 2).map((by) => {
      const box = inside({ ...free, x: free.x + by, y }, sheet),
        x = box.x + box.width / 2;
      const knee = Math.max(at.y + GAP, y - 14);
      return {
        box,
        draw: () => ({
          lines: polyline([
            { x: at.x, y: at.y + GAP },
            { x: at.x, y: knee },
            { x, y },
          ]),
          arrows: "",
        }),
      };
    });
  });
}

/** A length: a dimension line with arrowheads beside the element, on either side of it. */
function lengths(sheet: DimensionSheet, text: string, a: Place, b: Place): Candidate[] {
  const long = Math.hypot(b.x - a.x, b.y - a.y);
  if (long < 1) return [];
  const along = { x: (b.x - a.x) / long, y: (b.y - a.y) / long };
  // The side that looks up, away from the axis, first.
  const up = along.x > 0 ? { x: along.y, y: -along.x } : { x: -along.y, y: along.x };
  return OFFSETS.flatMap((far) =>
    [1, -1].map((side) => {
      const off = (p: Place, by: number): Place => ({ x: p.x + up.x * by * side, y: p.y + up.y * by * side });
      const [from, to] = [off(a, far), off(b, far)];
      const box = inside(boxAt(sheet, text, { x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 }), sheet);
      const edges = () => polyline([off(a, GAP), off(a, far + AIR)]) + polyline([off(b, GAP), off(b, far + AIR)]);
      return {
        box,
        draw: () => ({
          lines: edges() + polyline([from, to]),
          arrows: arrowHead(from, -along.x, -along.y) + arrowHead(to, along.x, along.y),
        }),
      };
    }),
  );
}

/** An angle: a thin line along +Z, an arc from it to the element, the text beside its middle. */
function angles(sheet: DimensionSheet, text: string, at: Place, angle: number): Candidate[] {
  const up = sheet.camera.xUp ? 1 : -1,
    turn = up * radians(angle);
  const onArc = (way: number, far: number): Place => ({ x: at.x + far * Math.cos(way), y: at.y - far * Math.sin(way) });
  const lines =
    polyline([
      { x: at.x + GAP, y: at.y },
      { x: at.x + ARC + 10, y: at.y },
    ]) + arcPath(at, ARC, 0, turn);
  const head = arrowHead(onArc(turn, ARC), -Math.sin(turn) * Math.sign(turn), -Math.cos(turn) * Math.sign(turn));
  return [ARC + 26, ARC + 44, ARC + 66].flatMap((far) =>
    [0.5, 0.3, 0.7, 0.1].map((share) => ({
      box: inside(boxAt(sheet, text, onArc(turn * share, far)), sheet),
      draw: () => ({ lines, arrows: head }),
    })),
  );
}

/** A radius or a chamfer: a leader with its arrowhead on the middle of the element. */
function sizes(sheet: DimensionSheet, text: string, on: Segment): Candidate[] {
  const { pointOn } = part,
    tip = toScreen(sheet.camera, pointOn(on, 0.5));
  const [a, b] = [toScreen(sheet.camera, on.from), toScreen(sheet.camera, on.to)],
    long = Math.hypot(b.x - a.x, b.y - a.y) || 1;
  const across = { x: (b.y - a.y) / long, y: -(b.x - a.x) / long };
  return OFFSETS.flatMap((far) =>
    [1, -1].flatMap((side) =>
      [0, 0.6, -0.6].map((lean) => {
        const way = {
          x: side * (across.x * Math.cos(lean) - across.y * Math.sin(lean)),
          y: side * (across.x * Math.sin(lean) + across.y * Math.cos(lean)),
        };
        const box = inside(boxAt(sheet, text, { x: tip.x + way.x * far, y: tip.y + way.y * far }), sheet);
        const middle = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
        return {
          box,
          draw: () => ({ lines: polyline([tip, middle]), arrows: arrowHead(tip, tip.x - middle.x, tip.y - middle.y) }),
        };
      }),
    ),
  );
}

function candidates(sheet: DimensionSheet, { text, measured }: DimensionRequest): Candidate[] {
  const place = (p: Pt) => toScreen(sheet.camera, p);
  switch (measured.kind) {
    case "diameter":
      return diameters(sheet, text, place(measured.at));
    case "axial":
      return positions(sheet, text, place(measured.at));
    case "length":
      return lengths(sheet, text, place(measured.from), place(measured.to));
    case "angle":
      return angles(sheet, text, place(measured.at), measured.angle);
    case "size":
      return sizes(sheet, text, measured.on);
  }
}

/** Whether the measured place is visible: dimensions of points outside the picture would crowd its edges. */
function inSight({ camera, size }: DimensionSheet, { measured }: DimensionRequest): boolean {
  const points =
    measured.kind === "length"
      ? [measured.from, measured.to]
      : measured.kind === "size"
        ? [part.pointOn(measured.on, 0.5)]
        : [measured.at];
  return points.some((p) => {
    const { x, y } = toScreen(camera, p);
    return x >= 0 && y >= 0 && x <= size.width && y <= size.height;
  });
}

/** Cost of a step to the next candidate: covering a point of the contour costs two steps. */
const STEP = 3;

/** A candidate as a place of the sheet. Its lines may lie under texts, whose ground is that of the sheet. */
type DimensionSpot = Spot & Candidate;

/**
 * Places dimensions on the drawing, those of the chosen element first, each where its text covers no other. Without a
 * free place, a dimension of the chosen element takes the place that covers least; others are left out.
 */
export function placedDimensions(sheet: DimensionSheet, asked: readonly DimensionRequest[]): PlacedDimension[] {
  const items = asked
    .filter((one) => one.needed || inSight(sheet, one))
    .toSorted((a, b) => Number(b.needed) - Number(a.needed))
    .map((one): Item<DimensionSpot> => ({
      q: one.key,
      needed: one.needed,
      candidates: candidates(sheet, one).map((each, i) => ({ ...each, label: each.box, lines: [], cost: STEP * i })),
    }));
  return arrange(items, { ...sheet.size, avoid: sheet.avoid, kept: sheet.kept }).map(({ q, box, draw }) => ({
    key: q,
    box,
    ...draw(),
  }));
}
