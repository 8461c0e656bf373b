import type { Approach } from "../../kernel/plane/approach.ts";
import type { PlanePoint } from "../../kernel/plane/plane.ts";
import type { Camera, Place } from "../camera.ts";
import { textBox } from "../dimensions/labels.ts";
import { arcPath, arrowHead } from "../help/marks.ts";
import { parallel } from "../help/dimensions.ts";
import { filled, stroke, value, type Candidate, type HelpItem, type Tag } from "../help/stroke.ts";
import { onScreen } from "./frame.ts";
import type { ApproachWords } from "./words.ts";
import { ROUND } from "../../kernel/tolerance.ts";
import { rounded } from "../../kernel/units.ts";

const moved = (p: Place, x: number, y: number, k: number): Place => ({ x: p.x + x * k, y: p.y + y * k });

interface Arc {
  readonly centre: Place;
  readonly radius: number;
  /** Angles as the screen sees them with Y upwards, radians, in the direction of travel. */
  readonly from: number;
  readonly sweep: number;
}

function radiusItem(tag: Tag, text: string, arc: Arc): HelpItem {
  const candidates = [0.5, 0.25, 0.75, 0.12, 0.88].flatMap((part): Candidate[] => {
    const angle = arc.from + arc.sweep * part;
    const [ux, uy] = [Math.cos(angle), -Math.sin(angle)];
    const tip = moved(arc.centre, ux, uy, arc.radius);
    return [0.55, 1].map((at): Candidate => {
      const end = at === 1 ? moved(tip, ux, uy, 16) : tip;
      const middle = at === 1 ? moved(tip, ux, uy, 32) : moved(moved(arc.centre, ux, uy, arc.radius * at), -uy, ux, 12);
      return {
        marks: () => [
          stroke(tag, "thin", `M${arc.centre.x} ${arc.centre.y}L${end.x} ${end.y}`),
          filled(tag, "arrow", arrowHead(tip, ux, uy)),
          value(tag, middle, text),
        ],
        label: textBox(middle, text, 0),
        lines: [],
        cost: Math.abs(part - 0.5) * 2 + (at === 1 ? 1.5 : 0),
      };
    });
  });
  return { q: "R", candidates };
}

function angleItem(tag: Tag, text: string, arc: Arc): HelpItem {
  const size = Math.max(14, Math.min(arc.radius * 0.42, 60));
  const to = arc.from + arc.sweep;
  const ray = (angle: number, k: number) => moved(arc.centre, Math.cos(angle), -Math.sin(angle), k);
  const whole = Math.abs(arc.sweep) >= 2 * Math.PI - ROUND;
  const drawn = whole
    ? arcPath(arc.centre, size, arc.from, arc.from + arc.sweep * 0.5) +
      arcPath(arc.centre, size, arc.from + arc.sweep * 0.5, to)
    : arcPath(arc.centre, size, arc.from, to);
  const spokes = [arc.from, to].map((angle) => {
    const end = ray(angle, arc.radius);
    return stroke(tag, "thin", `M${arc.centre.x} ${arc.centre.y}L${end.x} ${end.y}`);
  });
  const end = ray(to, size);
  const turn = Math.sign(arc.sweep);
  const head = filled(tag, "arrow", arrowHead(end, -Math.sin(to) * turn, -Math.cos(to) * turn, 7));
  const candidates = [0.35, 0.65, 0.5, 0.2, 0.8].flatMap((part) =>
    [size + 16, size * 0.5, size + 26].map((k, i): Candidate => {
      const middle = ray(arc.from + arc.sweep * part, k);
      return {
        marks: () => [...spokes, stroke(tag, "thin", drawn), head, value(tag, middle, text)],
        label: textBox(middle, text, 0),
        lines: [],
        cost: i + Math.abs(part - 0.35),
      };
    }),
  );
  return { q: "CCA", candidates };
}

/** LEN, or R and the centre angle, at the element they measure. `active` is the word of the current prompt. */
export function dimensionItems(
  result: Approach,
  camera: Camera,
  speech: ApproachWords,
  active: string | null,
): readonly HelpItem[] {
  const tag = (q: string): Tag => ({ q, active: q === active });
  const place = (p: PlanePoint) => onScreen(camera, p);
  const { arc, points } = result;
  if (arc) {
    const contact = result.departing ? points.PE : points.PA;
    if (!contact) return [];
    const [centre, at] = [place(arc.centre), place(contact)];
    const turn = arc.turn === "ccw" ? 1 : -1;
    const there = Math.atan2(-(at.y - centre.y), at.x - centre.x);
    const sweep = (turn * arc.angle * Math.PI) / 180;
    const shown: Arc = {
      centre,
      radius: Math.hypot(at.x - centre.x, at.y - centre.y),
      from: result.departing ? there : there - sweep,
      sweep,
    };
    return [
      angleItem(tag("CCA"), `${speech.number(rounded(arc.angle))}°`, shown),
      radiusItem(tag("R"), `R${speech.number(arc.radius)}`, shown),
    ];
  }
  const [inner, outer] = result.departing ? [points.PE, points.PN] : [points.PA, points.PH];
  if (!inner || !outer || result.shape === "CT" || result.shape === "LCT") return [];
  const size = Math.hypot(outer.x - inner.x, outer.y - inner.y);
  const lettering = { q: "LEN", text: `LEN ${speech.number(size)}`, active: active === "LEN" };
  return [{ q: "LEN", candidates: parallel(lettering, place(outer), place(inner)) }];
}
