import { at, part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { axial, diameter, radians, STEP, toRadius } from "../../kernel/units.ts";
import type { ContourTexts } from "../../i18n/en/workplace/contour.ts";
import type { Language } from "../../i18n/languages.ts";
import { formatNumber } from "../../i18n/number.ts";
import { dimensionsOf, type ContourDimension } from "../../program/job/contour-dimensions.ts";
import type { RowField, RowsReading } from "../../program/job/contour-rows.ts";
import type { ContourRow } from "../../program/job/job.ts";
import type { Dimension } from "../../view/dimensions/dimension.ts";
import type { DimensionRequest } from "../../view/dimensions/placed-dimensions.ts";

/** A dimension with its text, ready to be put on the drawing. */
export interface DrawnDimension extends DimensionRequest {
  readonly dimension: ContourDimension;
  /** Accessible name: what it is the dimension of. */
  readonly name: string;
  /** Of the chosen element. */
  readonly own: boolean;
}

const pointAt = ({ x, z }: { readonly x: number; readonly z: number }) => part.point(axial(z), toRadius(diameter(x)));

/** The angle of an element to +Z at a point, degrees; as far as it is known, only its legs are drawn. */
function angleFrom(vertex: Pt, degrees: number): Dimension {
  const leg = (way: number) => part.sum(vertex, at(STEP * Math.cos(way), STEP * Math.sin(way)));
  return { form: "angle", vertex, from: leg(0), to: leg(radians(degrees)) };
}

/** The size of a radius or a chamfer: a leader to its middle, into the material first. */
function sizeOf(on: Segment): Dimension {
  const middle = part.pointOn(on, 0.5);
  return { form: "leader", at: middle, towards: part.sum(middle, part.leftOf(part.direction(on, middle))) };
}

/** Geometry that a dimension measures, on the part; null while unknown. */
function measuredOf({ row, field, value }: ContourDimension, reading: RowsReading): Dimension | null {
  const read = reading.rows[row],
    { x, z } = read?.inherited ?? { x: null, z: null };
  const end = read?.end ? pointAt(read.end) : null,
    from = x === null || z === null ? null : pointAt({ x, z });
  switch (field) {
    case "x":
    case "z": {
      const at = end ?? read?.pole;
      return at ? { form: "ordinate", of: field === "x" ? "diameter" : "axial", at } : null;
    }
    case "r": {
      const on = reading.contour.segments[reading.rowOfSegment.indexOf(row)];
      return on ? sizeOf(on) : null;
    }
    case "length":
      return end && from && { form: "along", from, to: end };
    case "PR":
      return read?.pole && end ? { form: "along", from: read.pole, to: end } : null;
    default: {
      const at = field === "PA" ? read?.pole : from;
      return at && value !== null ? angleFrom(at, value) : null;
    }
  }
}

/** An angle along an axis that nobody typed: a print omits it. */
const isImplied = ({ field, value, follows }: ContourDimension) =>
  field === "angle" && follows && value !== null && value % 90 === 0;

const SIGNS: Readonly<Record<RowField, string>> = {
  x: "⌀ ",
  z: "Z ",
  r: "R ",
  length: "",
  angle: "",
  PR: "PR ",
  PA: "PA ",
};

function textOf(dimension: ContourDimension, row: ContourRow, language: Language): string {
  const { field, value, text, follows } = dimension;
  const shown =
    value === null ? (follows ? "?" : text) : formatNumber(language, field === "r" ? Math.abs(value) : value, 3);
  const unit = field === "angle" || field === "PA" ? "°" : "";
  const whole = `${row.kind === "CHF" ? "CHF " : SIGNS[field]}${shown}${value === null ? "" : unit}`;
  return follows ? `(${whole})` : whole;
}

/** The name of a field of an element, as the table has it. */
export function fieldName(t: ContourTexts, row: ContourRow, index: number, field: RowField): string {
  const n = index + 1;
  switch (field) {
    case "x":
      return t.xOf(n);
    case "z":
      return t.zOf(n);
    case "angle":
      return t.angleOf(n);
    case "length":
      return t.lengthOf(n);
    case "PR":
      return t.polarRadiusOf(n);
    case "PA":
      return t.polarAngleOf(n);
    default:
      return row.kind === "CHF" ? t.chamferOf(n) : t.radiusOf(n);
  }
}

/** All dimensions of the selected element; of the others each diameter and position once, then radii and chamfers. */
export function drawnDimensions({
  rows,
  reading,
  chosen,
  language,
  texts,
}: {
  readonly rows: readonly ContourRow[];
  readonly reading: RowsReading;
  readonly chosen: number | null;
  readonly language: Language;
  readonly texts: ContourTexts;
}): readonly DrawnDimension[] {
  const one = (dimension: ContourDimension): readonly DrawnDimension[] => {
    const row = rows[dimension.row],
      measured = measuredOf(dimension, reading);
    if (!row || !measured) return [];
    return [
      {
        dimension,
        measured,
        key: `${row.id} ${dimension.field}`,
        text: textOf(dimension, row, language),
        name: fieldName(texts, row, dimension.row, dimension.field),
        own: dimension.row === chosen,
        needed: dimension.row === chosen && !isImplied(dimension),
      },
    ];
  };
  const own = chosen === null ? [] : dimensionsOf(rows, reading, chosen);
  const others = rows.flatMap((_, i) => (i === chosen ? [] : dimensionsOf(rows, reading, i)));
  const said = new Set<string>();
  const isNew = ({ field, value }: ContourDimension) => {
    const words = `${field} ${value === null ? "" : value.toFixed(3)}`;
    return value !== null && !said.has(words) && said.add(words).size > 0;
  };
  own.forEach(isNew);
  const ordinates = [...others]
    .filter((d) => d.field === "x" || d.field === "z")
    .sort((a, b) => Number(a.follows) - Number(b.follows));
  const sizes = others.filter((d) => d.field === "r" && d.value !== null);
  return [...own, ...ordinates.filter(isNew), ...sizes].flatMap(one);
}
