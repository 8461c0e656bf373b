import { boxOf } from "../../kernel/area/box.ts";
import type { Box } from "../../kernel/geometry/segments.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import type { MilledMoment } from "../../sim/plane/milled.ts";
import type { Camera } from "../camera.ts";
import type { Patch, Pen } from "../material/pen.ts";

/** Colours of milled stock, as CSS colours. */
export interface MilledColours {
  /** The top surface. A hatch there would look like a section. */
  readonly ground: string;
  /** Outline of the body and of milled areas, and the hatch of lower shoulders, whose tones are darker. */
  readonly edge: string;
  readonly step: string;
}

/** Number of tones for milled areas, the first the least deep. */
export const TONES = 5;

/** The tone of a depth: the shallowest and the deepest are as far apart as possible. */
export const toneOfDepth = (depth: number, depths: number): number =>
  depths < 2 ? Math.floor(TONES / 2) : Math.round((depth * (TONES - 1)) / (depths - 1));

/** Pixels between two hatch lines, along the edge of the picture. */
const HATCH = 10;

const boxes = new WeakMap<Ring, Box>();
function known(ring: Ring): Box {
  const box = boxes.get(ring) ?? boxOf(ring);
  boxes.set(ring, box);
  return box;
}

interface Sheet {
  readonly pen: Pen;
  readonly camera: Camera;
  /** The painted area, in the plane. */
  readonly seen: Box;
}

/** Traces rings as the path of the pen; rings away from the patch are left out. */
function trace({ pen, camera: { scale, zero }, seen }: Sheet, rings: readonly Ring[]): void {
  pen.beginPath();
  for (const ring of rings) {
    const { left, right, low, high } = known(ring);
    if (left > seen.right || right < seen.left || low > seen.high || high < seen.low) continue;
    for (let i = 0; i < ring.length; i += 1) {
      const p = ring[i] as Ring[number],
        x = zero.x + p.z * scale,
        y = zero.y - p.r * scale;
      if (i === 0) pen.moveTo(x, y);
      else pen.lineTo(x, y);
    }
    pen.closePath();
  }
}

/** Hatch lines fixed to the picture instead of the patch, so that patches meet without a seam. */
function hatch(pen: Pen, { x, y, width, height }: Patch, colour: string): void {
  pen.beginPath();
  for (let c = Math.floor((x - y - height) / HATCH) * HATCH; c < x + width - y; c += HATCH) {
    pen.moveTo(c + y, y);
    pen.lineTo(c + y + height, y + height);
  }
  pen.strokeStyle = colour;
  pen.lineWidth = 1;
  pen.stroke();
}

/** Milled stock to paint: the moment, and the tone of each depth as a CSS colour. */
export interface Milled {
  readonly moment: MilledMoment;
  readonly tones: readonly string[];
}

/**
 * Repaints a patch of milled stock, seen from above with X to the right and Y upwards: the deepest areas first, higher
 * ones over them; lower areas that are not milled are hatched. Nothing outside the patch is touched; through
 * holes stay empty.
 */
export function paintMilled(
  pen: Pen,
  { moment, tones }: Milled,
  camera: Camera,
  colours: MilledColours,
  patch: Patch,
): void {
  const { standing, swept, initialBands } = moment,
    { x, y, width, height } = patch,
    { scale, zero } = camera,
    last = standing.length - 1;
  const seen = {
    left: (x - zero.x) / scale,
    right: (x + width - zero.x) / scale,
    low: (zero.y - y - height) / scale,
    high: (zero.y - y) / scale,
  };
  const sheet: Sheet = { pen, camera, seen };
  pen.save();
  pen.beginPath();
  pen.rect(x, y, width, height);
  pen.clip();
  pen.clearRect(x, y, width, height);
  for (let i = last; i >= 0; i -= 1) {
    const rings = standing[i] ?? [];
    trace(sheet, rings);
    pen.fillStyle = i === 0 ? colours.ground : (tones[i - 1] ?? colours.ground);
    pen.fill("nonzero");
    const whole = initialBands[i] ?? [];
    if (whole.length > 0 && i > 0) {
      pen.save();
      pen.clip("nonzero");
      trace(sheet, whole);
      pen.clip("nonzero");
      hatch(pen, patch, colours.step);
      pen.restore();
      trace(sheet, rings);
    }
    pen.strokeStyle = i === last ? colours.edge : colours.step;
    pen.lineWidth = i === last ? 2 : 1;
    pen.stroke();
  }
  // The running motion, over the stock as it was when the motion began.
  swept.forEach((rings, i) => {
    if (rings.length === 0) return;
    pen.save();
    trace(sheet, standing[i] ?? []);
    pen.clip("nonzero");
    trace(sheet, rings);
    if (i === last) {
      pen.clip("nonzero");
      pen.clearRect(x, y, width, height);
    } else {
      pen.fillStyle = tones[i] ?? colours.ground;
      pen.fill("nonzero");
    }
    pen.restore();
  });
  pen.restore();
}
