import type { Part21Entity, Part21File, Part21Value } from "../../files/part21.ts";
import { enumerationIn, listIn, numberIn, recordOf, referenceIn } from "../../files/part21-values.ts";
import type { StepUnits } from "./step-geometry.ts";

/** Prefixes of SI units (ISO 10303-41). */
const PREFIXES: Readonly<Record<string, number>> = {
  KILO: 1e3,
  HECTO: 1e2,
  DECA: 10,
  DECI: 0.1,
  CENTI: 1 / 1e2,
  MILLI: 1 / 1e3,
  MICRO: 1 / 1e6,
  NANO: 1 / 1e9,
};
const UNSAID: StepUnits = { length: 1, angle: 1, known: false };

/** Size of a unit in the SI unit of its kind (metre, radian); a converted unit is a multiple of another. */
function sizeOf(file: Part21File, v: Part21Value, depth = 0): number | null {
  const id = referenceIn(v),
    unit = id === null ? undefined : file.entities.get(id);
  if (!unit || depth > 4) return null;
  const si = recordOf(unit, "SI_UNIT")?.values;
  if (si) {
    // Of a simple instance the dimensions come first.
    const [prefix] = si.slice(-2).map(enumerationIn);
    return prefix ? (PREFIXES[prefix] ?? null) : 1;
  }
  const converted = recordOf(unit, "CONVERSION_BASED_UNIT")?.values.at(-1),
    measureId = converted === undefined ? null : referenceIn(converted),
    measure = measureId === null ? undefined : file.entities.get(measureId);
  const values = measure?.find((r) => r.type.endsWith("MEASURE_WITH_UNIT") && r.values.length === 2)?.values,
    n = values ? numberIn(values[0]) : null,
    base = values ? sizeOf(file, values[1], depth + 1) : null;
  return n !== null && base !== null && n > 0 ? n * base : null;
}

/** Units of a context of representation. */
function unitsOf(file: Part21File, context: Part21Entity | undefined): StepUnits | null {
  const units = listIn(recordOf(context, "GLOBAL_UNIT_ASSIGNED_CONTEXT")?.values.at(-1));
  if (units.length === 0) return null;
  const size = (kind: string) => {
    for (const v of units) {
      const id = referenceIn(v);
      if (id !== null && recordOf(file.entities.get(id), kind)) return sizeOf(file, v);
    }
    return null;
  };
  const length = size("LENGTH_UNIT");
  return { length: length === null ? 1 : length * 1000, angle: size("PLANE_ANGLE_UNIT") ?? 1, known: length !== null };
}

/**
 * Units by item of a representation: a file may hold representations in different units. Without any context lengths
 * are mm and angles radians.
 */
export function stepUnits(file: Part21File): (item: number) => StepUnits {
  const contexts = new Map<number, StepUnits | null>(),
    byItem = new Map<number, StepUnits>();
  const unitsIn = (context: number) => {
    const known = contexts.get(context);
    if (known !== undefined) return known;
    const made = unitsOf(file, file.entities.get(context));
    contexts.set(context, made);
    return made;
  };
  let first: StepUnits | null = null;
  for (const entity of file.entities.values())
    for (const r of entity) {
      if (!r.type.endsWith("REPRESENTATION") || r.values.length < 3) continue;
      const context = referenceIn(r.values[2]),
        units = context === null ? null : unitsIn(context);
      if (!units) continue;
      first ??= units;
      for (const item of listIn(r.values[1])) {
        const id = referenceIn(item);
        if (id !== null) byItem.set(id, units);
      }
    }
  return (item) => byItem.get(item) ?? first ?? UNSAID;
}
