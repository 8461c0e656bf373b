import { SAME_STEP } from "../../../kernel/tolerance.ts";
import { at, part } from "../../../kernel/geometry/point.ts";
import { radius, toDiameter } from "../../../kernel/units.ts";
import { referenceIn } from "../../files/part21-values.ts";
import { PART21_LIMITS, readPart21, type Part21Fault } from "../../files/part21.ts";
import { decoded } from "../decode.ts";
import type { Drawing, DrawingGiven, DrawingNote, DrawingUnit, DrawnBody, DrawnCurve } from "../drawing.ts";
import { FIT } from "../fit.ts";
import { axisOfBody } from "./axis-of-body.ts";
import { halfSection, type HalfSection, type SectionCurve } from "./half-section.ts";
import { leftOutOf } from "./left-out.ts";
import { mended } from "./mend.ts";
import { sectionPoint, type Axis3 } from "./meridian.ts";
import { pointsOfFace, STEP_LIMITS, stepBodies, type StepBody } from "./step-body.ts";
import { stepSurface, type StepSurface, type SurfacedFace } from "./step-surface.ts";

/** The centre line stands out of the part by this share of its length, and at least so far, mm. */
const OUT = { share: 0.04, least: 1 };

const refused = (...notes: readonly DrawingNote[]): Drawing => ({
  curves: [],
  unit: { unit: "mm", source: "assumed" },
  texts: [],
  tolerance: 0,
  notes,
});

interface Turned {
  readonly body: StepBody;
  readonly faces: readonly SurfacedFace[];
  readonly axis: Axis3;
  readonly area: number;
}

/** The bodies with faces of revolution, that with the largest turned area first. */
function turnedBodies(bodies: readonly StepBody[]): readonly Turned[] {
  const turned = bodies.flatMap((body): Turned[] => {
    if (body.faces.length > STEP_LIMITS.faces) return [];
    const surfaces = new Map<number, StepSurface>();
    const faces = body.faces.map((face) => {
        const corner = face.bounds[0]?.[0]?.points[0] ?? null,
          id = referenceIn(face.surface) ?? 0,
          known = surfaces.get(id);
        const surface = known ?? stepSurface(body.geometry, face.surface, corner);
        // The two sides of a turned line are told by the face.
        if (surface.kind !== "revolution") surfaces.set(id, surface);
        return { face, surface };
      }),
      found = axisOfBody(faces);
    return found ? [{ body, faces, ...found }] : [];
  });
  return turned.toSorted((a, b) => b.area - a.area);
}

/** Name and size of a body, by the edges of its faces. */
function drawnBody({ body, faces, axis }: Turned, factor: number): DrawnBody {
  let [left, right, high] = [Infinity, -Infinity, 0];
  for (const { face } of faces)
    for (const p of pointsOfFace(face)) {
      const { z, r } = sectionPoint(axis, p);
      [left, right, high] = [Math.min(left, z), Math.max(right, z), Math.max(high, r)];
    }
  const length = Math.max(right - left, 0) * factor;
  return { name: body.name, across: toDiameter(radius(high * factor)), length };
}

/** Notes on what the file lacks. A file that ends early is read as far as it goes. */
function faultNotes(faults: readonly Part21Fault[], count: number): DrawingNote[] {
  const broken = count - faults.filter((f) => f.code === "cut").length;
  const notes: DrawingNote[] = [];
  if (broken < count) notes.push({ code: "truncated", severity: "warning", values: {} });
  if (broken > 0) notes.push({ code: "broken", severity: "warning", values: { count: broken } });
  return notes;
}

function unitOf({ units }: StepBody, chosen: DrawingUnit["unit"] | undefined): DrawingUnit {
  if (chosen) return { unit: chosen, source: "chosen" };
  return { unit: Math.abs(units.length - 25.4) < SAME_STEP ? "inch" : "mm", source: units.known ? "file" : "assumed" };
}

/** Names of units other than mm and inch, by their size in mm. */
const UNIT_NAMES: readonly (readonly [size: number, name: string])[] = [
  [1000, "m"],
  [100, "dm"],
  [10, "cm"],
  [0.001, "µm"],
  [304.8, "ft"],
];

/** Factor from the unit of the file to the chosen one. */
const factorOf = ({ units }: StepBody, chosen: DrawingUnit["unit"] | undefined) =>
  chosen ? (chosen === "inch" ? 25.4 : 1) / units.length : 1;

function drawn(curves: readonly SectionCurve[], layer: string, factor: number): DrawnCurve[] {
  const sized = (p: { readonly z: number; readonly r: number }) => at(p.z * factor, p.r * factor);
  const outline = curves.map(({ segment: s, kind }): DrawnCurve => {
    const ends = { from: sized(s.from), to: sized(s.to) };
    return {
      segment: s.kind === "line" ? { kind: "line", ...ends } : { ...s, ...ends, centre: sized(s.centre) },
      layer,
      kind: kind.toUpperCase(),
      role: "outline",
    };
  });
  const boxes = outline.map((c) => part.boxOf(c.segment)),
    left = boxes.reduce((n, b) => Math.min(n, b.left), Infinity),
    right = boxes.reduce((n, b) => Math.max(n, b.right), -Infinity);
  if (outline.length === 0) return [];
  const out = Math.max((right - left) * OUT.share, OUT.least);
  const centre = part.line(at(left - out, 0), at(right + out, 0));
  return [...outline, { segment: centre, layer, kind: "AXIS", role: "centre" }];
}

function sectionNotes({ body, axis }: Turned, section: HalfSection, fitted: number): DrawingNote[] {
  const left = leftOutOf(section.others, axis),
    notes: DrawingNote[] = [];
  for (const shape of ["flats", "holes", "crossHoles", "others"] as const)
    if (left[shape] > 0) notes.push({ code: "notTurned", severity: "warning", values: { shape, count: left[shape] } });
  if (body.broken > 0) notes.push({ code: "broken", severity: "warning", values: { count: body.broken } });
  if (fitted > 0)
    notes.push({ code: "fitted", severity: "info", values: { kind: "SPLINE", count: fitted, tolerance: FIT } });
  const unit = UNIT_NAMES.find(([size]) => Math.abs(body.units.length / size - 1) < SAME_STEP)?.[1];
  if (unit) notes.push({ code: "unitConverted", severity: "info", values: { unit } });
  return notes;
}

/**
 * Half section of the turned part in a STEP file (AP203, AP214, AP242), above its axis; z along the axis as in the file. Of
 * several bodies the given one, else that with the largest turned surface. The unit replaces the one of the file. Never
 * throws; what was left out is in the notes.
 */
export function readStep(bytes: Uint8Array, { unit, body }: DrawingGiven = {}): Drawing {
  const file = readPart21(decoded(bytes));
  if (file.faults.some((f) => f.code === "notPart21"))
    return refused({ code: "unreadable", severity: "error", values: { kind: "STEP" } });
  if (file.faults.some((f) => f.code === "tooMany" || f.code === "tooLarge"))
    return refused({ code: "tooMany", severity: "error", values: { limit: PART21_LIMITS.entities } });
  const notes = faultNotes(file.faults, file.faultCount),
    { bodies, more } = stepBodies(file);
  if (bodies.length === 0) return refused({ code: "noSolid", severity: "error", values: {} }, ...notes);
  const all = turnedBodies(bodies),
    taken = body !== undefined && all[body] ? body : 0,
    turned = all[taken];
  if (!turned && bodies.some((b) => b.faces.length > STEP_LIMITS.faces))
    return refused({ code: "tooMany", severity: "error", values: { limit: STEP_LIMITS.faces } });
  if (!turned) return refused({ code: "noRevolved", severity: "error", values: {} }, ...notes);
  const section = halfSection(turned.body, turned.faces, turned.axis),
    curves = mended(section.curves),
    fitted = curves.filter((c) => c.isFitted).length,
    count = bodies.length + more - 1;
  if (count > 0) {
    const values = { name: turned.body.name, count, turned: all.length - 1 };
    notes.push({ code: "otherBodies", severity: "warning", values });
  }
  return {
    curves: drawn(curves, turned.body.name, factorOf(turned.body, unit)),
    unit: unitOf(turned.body, unit),
    texts: [],
    tolerance: fitted > 0 ? FIT : 0,
    notes: [...notes, ...sectionNotes(turned, section, fitted)],
    bodies: { all: all.map((each) => drawnBody(each, factorOf(each.body, unit))), drawn: taken },
  };
}
