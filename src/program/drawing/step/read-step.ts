import { SAME_STEP } from "../../../kernel/tolerance.ts";
import { at, part } from "../../../kernel/geometry/point.ts";
import { referenceIn } from "../../files/part21-values.ts";
import { PART21_LIMITS, readPart21, type Part21Fault } from "../../files/part21.ts";
import { decoded } from "../decode.ts";
import type { Drawing, DrawingNote, DrawingUnit, DrawnCurve } from "../drawing.ts";
import { FIT } from "../fit.ts";
import { axisOfBody } from "./axis-of-body.ts";
import { halfSection, type HalfSection, type SectionCurve, type SurfacedFace } from "./half-section.ts";
import { leftOutOf } from "./left-out.ts";
import { mended } from "./mend.ts";
import type { Axis3 } from "./meridian.ts";
import { STEP_LIMITS, stepBodies, type StepBody } from "./step-body.ts";
import { stepSurface, type StepSurface } from "./step-surface.ts";

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

/** The body with the largest turned area; null where none has a face of revolution. */
function turnedBody(bodies: readonly StepBody[]): Turned | null {
  let best: Turned | null = null;
  for (const body of bodies) {
    if (body.faces.length > STEP_LIMITS.faces) continue;
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
    if (found && (!best || found.area > best.area)) best = { body, faces, ...found };
  }
  return best;
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
 * several bodies the one with the largest turned surface. The unit replaces the one of the file. Never throws; what was
 * left out is in the notes.
 */
export function readStep(bytes: Uint8Array, unit?: DrawingUnit["unit"]): Drawing {
  const file = readPart21(decoded(bytes));
  if (file.faults.some((f) => f.code === "notPart21"))
    return refused({ code: "unreadable", severity: "error", values: { kind: "STEP" } });
  if (file.faults.some((f) => f.code === "tooMany" || f.code === "tooLarge"))
    return refused({ code: "tooMany", severity: "error", values: { limit: PART21_LIMITS.entities } });
  const notes = faultNotes(file.faults, file.faultCount),
    { bodies, more } = stepBodies(file);
  if (bodies.length === 0) return refused({ code: "noSolid", severity: "error", values: {} }, ...notes);
  const turned = turnedBody(bodies);
  if (!turned && bodies.some((b) => b.faces.length > STEP_LIMITS.faces))
    return refused({ code: "tooMany", severity: "error", values: { limit: STEP_LIMITS.faces } });
  if (!turned) return refused({ code: "noRevolved", severity: "error", values: {} }, ...notes);
  const section = halfSection(turned.body, turned.faces, turned.axis),
    curves = mended(section.curves),
    fitted = curves.filter((c) => c.isFitted).length,
    count = bodies.length + more - 1;
  if (count > 0) notes.push({ code: "otherBodies", severity: "warning", values: { name: turned.body.name, count } });
  return {
    curves: drawn(curves, turned.body.name, factorOf(turned.body, unit)),
    unit: unitOf(turned.body, unit),
    texts: [],
    tolerance: fitted > 0 ? FIT : 0,
    notes: [...notes, ...sectionNotes(turned, section, fitted)],
  };
}
