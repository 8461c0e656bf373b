import type { Part21Entity, Part21File, Part21Value } from "../../files/part21.ts";
import { listIn, recordOf, referenceIn } from "../../files/part21-values.ts";

const isBody = (entity: Part21Entity | undefined) => entity?.some((r) => /BREP|SURFACE_MODEL/.test(r.type)) ?? false;

/** Steps from the shape of a product to the product (ISO 10303-41): the type of each entity, and the value that leads on. */
const TO_PRODUCT: readonly (readonly [type: string, value: number])[] = [
  ["PRODUCT_DEFINITION_SHAPE", 2],
  ["PRODUCT_DEFINITION", 2],
  ["PRODUCT_DEFINITION_FORMATION", 2],
];

/**
 * Name of a body by the number of its item: that of the product whose shape it is, or its own where a product has
 * several. A shape may stand in a representation of its own
 * that is only related to that of the product.
 */
export function productNames(file: Part21File): (item: number, own: string) => string {
  const entity = (v: Part21Value) => file.entities.get(referenceIn(v) ?? Number.NaN);
  const nameOf = (shape: Part21Value): string | null => {
    let at: Part21Value = shape;
    for (const [type, value] of TO_PRODUCT)
      at = entity(at)?.find((r) => r.type.startsWith(type))?.values[value] ?? null;
    const name = recordOf(entity(at), "PRODUCT")?.values[1];
    return typeof name === "string" && name.trim() !== "" ? name.trim() : null;
  };
  const names = new Map<number, string>(),
    related: (readonly [number, number])[] = [];
  for (const records of file.entities.values())
    for (const { type, values } of records) {
      if (type === "SHAPE_DEFINITION_REPRESENTATION") {
        const name = nameOf(values[0] ?? null),
          shape = referenceIn(values[1] ?? null);
        if (name !== null && shape !== null) names.set(shape, name);
      } else if (type === "SHAPE_REPRESENTATION_RELATIONSHIP" && records.length === 1) {
        const [one, other] = [referenceIn(values[2] ?? null), referenceIn(values[3] ?? null)];
        if (one !== null && other !== null) related.push([one, other]);
      }
    }
  for (const [one, other] of related) {
    const name = names.get(one) ?? names.get(other);
    if (name !== undefined) for (const each of [one, other]) if (!names.has(each)) names.set(each, name);
  }
  const byItem = new Map<number, string>(),
    shared = new Set<string>();
  for (const [shape, name] of names)
    for (const { type, values } of file.entities.get(shape) ?? [])
      if (type.endsWith("REPRESENTATION")) {
        // Placements stand beside the bodies.
        const bodies = listIn(values[1] ?? null).flatMap((v) => (isBody(entity(v)) ? (referenceIn(v) ?? []) : []));
        if (bodies.length > 1) shared.add(name);
        for (const id of bodies) byItem.set(id, name);
      }
  return (item, own) => {
    const name = byItem.get(item) ?? "";
    return own.trim() !== "" && (name === "" || shared.has(name)) ? own.trim() : name;
  };
}
