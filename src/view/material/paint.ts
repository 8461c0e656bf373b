import type { Ring } from "../../kernel/point.ts";
import type { Camera } from "../camera.ts";
import type { Pen, Patch } from "./pen.ts";

/** The work at one moment. */
export interface Material {
  /** Its section, outer rings counter-clockwise, mm. */
  readonly rings: readonly Ring[];
  /** Both sides of the axis are cut. */
  readonly full: boolean;
}

/** What the material is painted with, as CSS colours. */
export interface MaterialColours {
  readonly ground: string;
  readonly hatch: string;
  readonly edge: string;
}

/** Pixels between two hatch lines, along the edge of the picture. */
const HATCH = 10;

function outline(pen: Pen, { rings, full }: Material, { scale, zero, xUp }: Camera): void {
  pen.beginPath();
  for (const side of full ? [1, -1] : [1]) {
    const up = (xUp ? -scale : scale) * side;
    for (const ring of rings) {
      if (ring.length < 3) continue;
      ring.forEach((
        p,
        i,
      ) => (i === 0 ? pen.moveTo(zero.x + p.z * scale, zero.y + p.r * up) : pen.lineTo(zero.x + p.z * scale, zero.y + p.r * up)));
      pen.closePath();
    }
  }
}

/** Paints a patch of the picture anew: what was there is taken away, nothing outside it is touched. */
export function paintMaterial(pen: Pen, material: Material, camera: Camera, colours: MaterialColours, patch: Patch): void {
  const { x, y, width, height } = patch;
  pen.save();
  pen.beginPath();
  pen.rect(x, y, width, height);
  pen.clip();
  pen.clearRect(x, y, width, height);
  outline(pen, material, camera);
  pen.fillStyle = colours.ground;
  pen.fill("evenodd");
  pen.save();
  pen.clip("evenodd");
  // The lines stand on the picture and not in the patch, so that patchs meet without a seam.
  pen.beginPath();
  for (let c = Math.floor((x - y - height) / HATCH) * HATCH; c < x + width - y; c += HATCH) {
    pen.moveTo(c + y, y);
    pen.lineTo(c + y + height, y + height);
  }
  pen.strokeStyle = colours.hatch;
  pen.lineWidth = 1;
  pen.stroke();
  pen.restore();
  outline(pen, material, camera);
  pen.strokeStyle = colours.edge;
  pen.stroke();
  pen.restore();
}
