import type { Dimension as OfParameter } from "../../cycles/define.ts";
import type { Pt } from "../../kernel/geometry/point.ts";

type Form<D> = D extends unknown ? Omit<D, "q"> : never;

/**
 * What a dimension measures, and where on the part, mm: the forms that the outlines of cycles have, a circle across its
 * centre, a radius with its centre, and an ordinate, a diameter or a position whose text stands at the edge of the
 * drawing.
 */
export type Dimension =
  | Form<OfParameter>
  | { readonly form: "circle" | "radius"; readonly at: Pt; readonly centre: Pt }
  | { readonly form: "ordinate"; readonly of: "diameter" | "axial"; readonly at: Pt };

/** A dimension of one form. */
export type DimensionOf<F extends Dimension["form"]> = Dimension & { readonly form: F };
