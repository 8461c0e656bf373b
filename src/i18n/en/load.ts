import type { Shape } from "../shape.ts";

/**
 * Roughness and load by colour: the scale, what is told of a place, and the list of the greatest values. Numbers arrive
 * as text.
 */
export const load = {
  names: {
    roughness: "Theoretical roughness Rz",
    depth: "Depth of cut",
    chip: "Chip area",
    feed: "Feed per turn",
    speed: "Cutting speed",
  },
  units: { roughness: "µm", depth: "mm", chip: "mm²", feed: "mm/rev", speed: "m/min" },
  abouts: {
    roughness: "Rz ≈ f²/(8·r), where the nose alone forms the surface",
    depth: "Measured in the stock, square to the path",
    chip: "What one turn takes: depth times feed",
    feed: "A feed in mm/min is divided by the spindle speed",
    speed: "At the tip",
  },
  scale: "Scale",
  between: (low: string, high: string, unit: string) => `${low} to ${high} ${unit}`,
  working: "Measuring in the stock …",
  failed: "This could not be measured.",
  nothing: "Nothing is cut.",
  notByNose: "Not by the nose",
  limited: "Speed limit reached",
  limitedLong: "speed limit reached, cutting speed not held",
  now: "Now",
  here: "Here",
  greatest: "Greatest",
  least: "Least at the limit",
  place: (x: string, z: string, block: string) => `X⌀ ${x}, Z ${z}, block ${block}`,
  go: "Go there",
  goTo: (place: string) => `Go there: ${place}`,
  feedAndNose: (feed: string, nose: string) => `f ${feed} mm, r ${nose} mm`,
  exactly: (value: string) => `the circle exactly ${value} µm`,
  perMinute: (value: string) => `${value} mm/min`,
  rpm: (value: string) => `${value} rpm`,
  by: {
    nose: "f²/(8·r)",
    partly: "nose and edge, from the outline of the insert",
    edge: "not by the nose: straight edge along the surface",
    shape: "not by the nose: the tool stood there",
    thread: "not by the nose: thread",
    drill: "not by the nose: drill",
    unknown: "no feed per turn known",
  },
  table: (name: string) => `${name} by operation`,
  operation: "Operation",
  value: "Value",
};

export type LoadTexts = Shape<typeof load>;
