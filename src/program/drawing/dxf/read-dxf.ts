import { INCH } from "../../../kernel/units.ts";
import { part } from "../../../kernel/geometry/point.ts";
import type { Drawing, DrawingGiven, DrawingNote, DrawingUnit, DrawnCurve } from "../drawing.ts";
import { FIT, plainCurve } from "../fit.ts";
import { viewOf } from "../plane.ts";
import { rolesByWeight } from "../roles.ts";
import { after, placed, placedCurve, stretch } from "../space.ts";
import { at } from "../../../kernel/geometry/point.ts";
import { readDocument, type DxfDocument } from "./document.ts";
import { expanded, type Expanded } from "./expand.ts";
import { numberOf, readTags } from "./tags.ts";

/** Most lines and arcs of a drawing. */
export const MOST_CURVES = 20_000;
/** Most texts that are kept as hints. */
const MOST_TEXTS = 2000;

/** $INSUNITS: name and mm (DXF reference; 21 to 24 are US survey units, for maps). */
const UNITS: Readonly<Record<number, readonly [name: string, mm: number]>> = {
  1: ["inch", INCH],
  2: ["ft", 12 * INCH],
  4: ["mm", 1],
  5: ["cm", 10],
  6: ["m", 1000],
  8: ["µin", INCH / 1e6],
  9: ["mil", INCH / 1000],
  10: ["yd", 36 * INCH],
  13: ["µm", 0.001],
  14: ["dm", 100],
};

interface Scale {
  readonly unit: DrawingUnit;
  readonly mm: number;
  readonly notes: readonly DrawingNote[];
}

/** Unit of a drawing: as chosen, by $INSUNITS, by $MEASUREMENT (0 is inch), or mm assumed. */
function scaleOf(doc: DxfDocument, chosen: "mm" | "inch" | undefined): Scale {
  const variable = (name: string) => numberOf(doc.header.get(name)?.find((t) => t.code === 70)?.text);
  const byUnits = UNITS[variable("$INSUNITS") ?? 0],
    measurement = variable("$MEASUREMENT");
  if (chosen) return { unit: { unit: chosen, source: "chosen" }, mm: chosen === "inch" ? INCH : 1, notes: [] };
  if (byUnits) {
    const [name, mm] = byUnits,
      isImperial = mm % INCH === 0 || [8, 9].includes(variable("$INSUNITS") ?? 0);
    const disagree = measurement !== null && isImperial === (measurement === 1);
    return {
      unit: { unit: isImperial ? "inch" : "mm", source: "file" },
      mm,
      notes: [
        ...(disagree ? [{ code: "unitsDisagree", severity: "warning", values: { unit: name } } as const] : []),
        ...(mm !== 1 ? [{ code: "unitConverted", severity: "info", values: { unit: name } } as const] : []),
      ],
    };
  }
  if (measurement === 0)
    return {
      unit: { unit: "inch", source: "measurement" },
      mm: INCH,
      notes: [{ code: "unitConverted", severity: "info", values: { unit: "inch" } }],
    };
  return { unit: { unit: "mm", source: measurement === 1 ? "measurement" : "assumed" }, mm: 1, notes: [] };
}

/** What a space of the drawing hides, cannot show or repeats, as notes. */
function notesOf(from: Expanded): DrawingNote[] {
  const notes: DrawingNote[] = [];
  from.hiddenLayers.forEach((count, layer) =>
    notes.push({ code: "hiddenLayer", severity: "warning", values: { layer, count } }),
  );
  if (from.invisible > 0) notes.push({ code: "invisible", severity: "warning", values: { count: from.invisible } });
  from.skipped.forEach((count, kind) => notes.push({ code: "skipped", severity: "info", values: { kind, count } }));
  if (from.broken > 0) notes.push({ code: "broken", severity: "warning", values: { count: from.broken } });
  for (const block of from.missing) notes.push({ code: "missingBlock", severity: "warning", values: { block } });
  for (const block of from.recursive) notes.push({ code: "recursiveBlock", severity: "warning", values: { block } });
  return notes;
}

const refused = (note: DrawingNote): Drawing => ({
  curves: [],
  unit: { unit: "mm", source: "assumed" },
  texts: [],
  tolerance: 0,
  notes: [note],
});

/** Reads a DXF file, text or binary, of any release. Never throws for what a file contains; bounded in size and time. */
export function readDxfFile(bytes: Uint8Array, { unit: chosen }: DrawingGiven = {}): Drawing {
  const tags = readTags(bytes);
  if (!tags) return refused({ code: "unreadable", severity: "error", values: { kind: "DXF" } });
  const doc = readDocument(tags),
    model = expanded(doc, "model"),
    isModel = model.curves.length > 0 || model.elsewhere === 0,
    shown = isModel ? model : expanded(doc, "paper");
  if (shown.isFull || doc.tooMany)
    return refused({ code: "tooMany", severity: "error", values: { limit: MOST_CURVES } });
  const { unit, mm, notes: unitNotes } = scaleOf(doc, chosen),
    scaled = shown.curves.map((c) => ({ ...c, curve: placedCurve(stretch(mm, mm, mm), c.curve) })),
    view = viewOf(scaled.map((c) => c.curve)),
    inPlane = scaled.filter((c) => !view.isOutside(c.curve)),
    placing = after(view.placing, stretch(mm, mm, mm));
  const fitted = new Map<string, number>();
  const plain = inPlane.map((c) => {
    const made = plainCurve(placedCurve(view.placing, c.curve));
    if (made.isFitted) fitted.set(c.kind, (fitted.get(c.kind) ?? 0) + 1);
    return { ...c, segments: made.segments, length: made.segments.reduce((sum, s) => sum + part.lengthOf(s), 0) };
  });
  const roles = rolesByWeight(plain);
  const curves = plain.flatMap(({ segments, layer, kind, role }, i): DrawnCurve[] =>
    segments.map((segment) => ({ segment, layer, kind, role: roles[i] ?? role })),
  );
  if (curves.length > MOST_CURVES)
    return refused({ code: "tooMany", severity: "error", values: { limit: MOST_CURVES } });
  const outside = scaled.length - inPlane.length;
  const notes: DrawingNote[] = [
    ...(doc.complete ? [] : [{ code: "truncated", severity: "warning", values: {} } as const]),
    ...unitNotes,
    ...(isModel
      ? model.elsewhere > 0
        ? [{ code: "paperSpace", severity: "info", values: { count: model.elsewhere } } as const]
        : []
      : [{ code: "paperUsed", severity: "warning", values: {} } as const]),
    ...(view.plane === "xy" ? [] : [{ code: "plane", severity: "info", values: { plane: view.plane } } as const]),
    ...(outside > 0 ? [{ code: "otherPlane", severity: "warning", values: { count: outside } } as const] : []),
    ...notesOf(shown),
  ];
  fitted.forEach((count, kind) =>
    notes.push({ code: "fitted", severity: "info", values: { kind, count, tolerance: FIT } }),
  );
  const texts = shown.texts.slice(0, MOST_TEXTS).map(({ text, at: spot }) => {
    const [x, y] = placed(placing, spot);
    return { text, at: at(x, y) };
  });
  return { curves, unit, texts, tolerance: fitted.size > 0 ? FIT : 0, notes };
}
