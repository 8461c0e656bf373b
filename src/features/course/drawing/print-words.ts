import type { CourseDrawingTexts } from "../../../i18n/en/course-drawing.ts";
import type { Language } from "../../../i18n/languages.ts";
import { formatNumber, formatSigned, withPrintedMinus } from "../../../i18n/number.ts";
import type { PrintWords } from "../../../view/drawing/print-sizes.ts";

/** Numbers of a workshop drawing in a language. */
export function printWords(t: CourseDrawingTexts, language: Language): PrintWords {
  const number = (value: number) => formatNumber(language, value);
  return {
    diameter: (value) => `⌀${number(value)}`,
    length: number,
    position: (value) => withPrintedMinus(number(value)),
    deviation: (value) => (value === 0 ? "0" : withPrintedMinus(formatSigned(language, value))),
    both: (value) => `±${number(Math.abs(value))}`,
    radius: (value) => t.radius(number(value)),
    // The axial value on a cone is slightly less than the given one, so hundredths are shown.
    chamfer: (size, angle) => t.chamfer(formatNumber(language, size, 2), formatNumber(language, angle, 1)),
    legs: (axial, across) => `${formatNumber(language, axial, 2)}×${formatNumber(language, across, 2)}`,
    angle: (value) => `${formatNumber(language, value, 1)}°`,
    roughness: (value) => t.micrometres(number(value)),
  };
}
