import type { Draw } from "../../src/cycles/random-setup.ts";
import type { ContourElement } from "../../src/kernel/contour/contour.ts";
import { at, type Pt } from "../../src/kernel/geometry/point.ts";
import { UNDERCUT_FORMS, type RecessWords, type UndercutForm } from "../../src/kernel/contour/undercut.ts";
import type { Open } from "../judge/least.ts";

/*
 * Contours with every kind of element: on a shaft, in a bore and in a face; open at their start as at a shaft end, or
 * closed by walls at both ends as in a recess.
 */

export interface Shape {
  readonly name: string;
  readonly elements: readonly ContourElement[];
}

/** Position of a contour, and whether walls of the height `CLOSED` close it. */
export interface Site extends Open {
  readonly closed: boolean;
}

/** The walls of a recess: their slope, and the width of their edges, mm. */
const CLOSED = { lean: 1.2, edge: 1.5 };
/**
 * Height of these walls above the first floor, and of steps. Undercuts are in cylinders: in a face those are the steps.
 */
const heights = ({ along, closed }: Site) =>
  along === "r"
    ? { wall: 36, least: 5.5, most: 7, step: 5.6 }
    : { wall: 14, least: 2.5, most: 4, step: closed ? 2.1 : 3.4 };

/** A point of the contour: mm along it and out of the part, from its first point. */
const placeOn =
  ({ along, out }: Open) =>
  (on: number, up: number): Pt =>
    along === "z" ? at(-on, (out > 0 ? 12 : 64) + out * up) : at(up, 130 - on);

/** Collects elements by their distance and height. */
function drawing(site: Site) {
  const place = placeOn(site);
  const elements: ContourElement[] = [];
  let top = 0;
  return {
    place,
    elements,
    /** Height of the highest line. */
    top: () => top,
    line: (on: number, up: number) => {
      top = Math.max(top, up);
      elements.push({ kind: "line", to: place(on, up) });
    },
    arc: (on: number, up: number, radius: number, isHill: boolean) =>
      void elements.push({
        kind: "radius",
        to: place(on, up),
        radius,
        turn: isHill === (site.along === "z" && site.out > 0) ? "ccw" : "cw",
      }),
    undercut: (form: UndercutForm) => void elements.push({ kind: "undercut", form, words: FORMS[form] }),
  };
}

/** Each form with uneven measures. */
const FORMS: Readonly<Record<UndercutForm, RecessWords>> = {
  E: { R: 0.6, DEPTH: 0.35, BREADTH: 2.6, ANGLE: 15 },
  F: { R: 0.6, DEPTH: 0.3, BREADTH: 2.5, ANGLE: 15, FACEDEPTH: 0.2, FACEANGLE: 8 },
  H: { R: 0.7, BREADTH: 2.7, ANGLE: 15 },
  K: { R: 0.4, DEPTH: 0.9, ROT: 45, ANGLE: 40 },
  U: { R: 0.5, DEPTH: 0.8, BREADTH: 3.3 },
  THREAD: { PITCH: 1.5, R: 0.8, DEPTH: 1.15, BREADTH: 4.1, ANGLE: 30 },
};

type Drawing = ReturnType<typeof drawing>;

/** The first edge or wall of a shape; returns its end as distance and height. */
function begun({ line }: Drawing, site: Site, chamfer: number): [on: number, up: number] {
  if (!site.closed) {
    line(0, 0);
    line(chamfer, chamfer);
    return [chamfer, chamfer];
  }
  const { lean, edge } = CLOSED;
  line(0, heights(site).wall);
  line(edge, heights(site).wall);
  line(edge + lean, 0);
  return [edge + lean, 0];
}

/** The last wall of a shape, and its highest: material beyond a lower end would belong to no contour. */
function ended({ line, top }: Drawing, site: Site, on: number, up: number): void {
  line(on, up);
  const { lean, edge } = CLOSED;
  if (!site.closed) return line(on, Math.max(top() + 2, up + 5));
  line(on + lean, heights(site).wall);
  line(on + lean + edge, heights(site).wall);
}

/** Three to five features in a row: shoulders either way with an undercut or a corner, tapers, arcs, recesses. */
export function drawnShape(draw: Draw, site: Site): Shape {
  const mm = (least: number, most: number) => draw.whole(least * 20, most * 20) / 20;
  const d = drawing(site);
  const names: string[] = [];
  let [on, up] = begun(d, site, mm(0.5, 1.5));
  const { wall, ...size } = heights(site);
  const room = site.closed ? wall - 1 - size.most : Infinity;
  for (let count = draw.whole(3, 5); count > 0; count -= 1) {
    const drawn = draw.one("shoulder", "shoulder", "drop", "rise", "fall", "hill", "valley", "recess");
    const feature = (drawn === "shoulder" || drawn === "rise") && up > room ? "fall" : drawn;
    on += feature === "recess" ? 13 : mm(8.4, 9.5);
    d.line(on, up);
    const corner = draw.one("round", "chamfer", "none");
    const round = () => corner !== "none" && d.elements.push({ kind: corner, size: mm(0.3, 1) });
    if (feature === "shoulder" || feature === "drop") {
      const form = draw.one(...UNDERCUT_FORMS);
      const cut = () => (draw.one(true, false) ? (d.undercut(form), ` UDC ${form}`) : (round(), ""));
      const foot = feature === "shoulder" ? cut() : "";
      up += (feature === "shoulder" ? 1 : -1) * mm(size.least, size.most);
      d.line(on, up);
      names.push(feature + foot + (feature === "drop" ? cut() : ""));
    } else if (feature === "rise" || feature === "fall") {
      round();
      names.push(feature);
      on += mm(1.5, 6);
      up += (feature === "rise" ? 1 : -1) * mm(1, 3);
      d.line(on, up);
      round();
    } else if (feature === "recess") {
      const depth = mm(0.6, 1.6);
      const middle = d.place(on - 4.2, 0);
      const radial = site.along === "z";
      const words = {
        CENTER: radial ? middle.z : middle.r,
        DEPTH: -site.out * depth,
        BREADTH: mm(5, 7),
        ANG_WIDTH: draw.one(90, 100, 110),
        R: 0.4,
      };
      names.push(`GRV ${words.BREADTH} x ${depth}`);
      d.elements.push({ kind: "groove", direction: radial ? "radial" : "axial", words });
    } else {
      const chord = mm(2.5, 5);
      names.push(`${feature} ${chord}`);
      on += chord;
      d.arc(on, up, chord * draw.one(0.55, 0.8, 1.2), feature === "hill");
    }
  }
  ended(d, site, on + 6, up);
  return { name: names.join(", "), elements: d.elements };
}

/** All forms one after the other. */
export function everyForm(site: Site): Shape {
  const d = drawing(site);
  begun(d, site, 1);
  const { step } = heights(site);
  const first = site.closed ? 0 : 1;
  UNDERCUT_FORMS.forEach((form, i) => {
    const [on, up] = [3 + 9 * (i + 1), first + step * i];
    d.line(on, up);
    d.undercut(form);
    d.line(on, up + step);
  });
  ended(d, site, 9 + 9 * UNDERCUT_FORMS.length, first + step * UNDERCUT_FORMS.length);
  return { name: "every form", elements: d.elements };
}

/** A valley in a valley, a ball, and a hollow that ends as steep as a wall. */
export function valleys(site: Site): Shape {
  const d = drawing(site);
  const [on, up] = begun(d, site, 0.8);
  d.line(on + 6, up);
  d.line(on + 8, up - 2);
  d.line(on + 12, up - 2);
  d.line(on + 14, up - 3.5);
  d.elements.push({ kind: "round", size: 0.7 });
  d.line(on + 19, up - 3.5);
  d.line(on + 25, up + 2.2);
  d.line(on + 29, up + 2.2);
  d.arc(on + 34, up + 2.2, 2.6, true);
  d.line(on + 38, up + 2.2);
  d.arc(on + 42, up + 6.2, 4, false);
  ended(d, site, on + 42, up + 8.2);
  return { name: "valleys", elements: d.elements };
}
