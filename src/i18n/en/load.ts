import type { Shape } from "../shape.ts";

/**
 * Roughness and load by colour: the scale, the values at a place, and the list of the greatest values. Numbers arrive
 * as text.
 */
export const load = {
  names: {
    roughness: "Theoretical roughness Rz",
    depth: "Depth of cut",
    chip: "Chip area",
    feed: "Feed per revolution",
    speed: "Cutting speed",
  },
  units: { roughness: "µm", depth: "mm", chip: "mm²", feed: "mm/rev", speed: "m/min" },
  abouts: {
    roughness: "Rz ≈ f²/(8·r), where the nose radius alone forms the surface",
    depth: "Measured in the stock, perpendicular to the path",
    chip: "Cross section per revolution: depth of cut times feed",
    feed: "A feed in mm/min is divided by the spindle speed",
    speed: "At the tip",
  },
  scale: "Scale",
  between: (low: string, high: string, unit: string) => `${low} to ${high} ${unit}`,
  working: "Measuring in the stock …",
  failed: "Measuring failed.",
  nothing: "Nothing is cut.",
  notByNose: "Not formed by the nose radius",
  limited: "Speed limit reached",
  limitedLong: "speed limit reached, cutting speed not maintained",
  now: "Now",
  here: "Here",
  greatest: "Greatest",
  least: "Lowest at the limit",
  place: (x: string, z: string, block: string) => `X⌀ ${x}, Z ${z}, block ${block}`,
  go: "Go there",
  goTo: (place: string) => `Go there: ${place}`,
  feedAndNose: (feed: string, nose: string) => `f ${feed} mm, r ${nose} mm`,
  exactly: (value: string) => `exact arc ${value} µm`,
  perMinute: (value: string) => `${value} mm/min`,
  rpm: (value: string) => `${value} rpm`,
  by: {
    nose: "f²/(8·r)",
    partly: "nose radius and edge, from the insert outline",
    edge: "not the nose radius: straight edge along the surface",
    shape: "not the nose radius: tool stopped here",
    thread: "not the nose radius: thread",
    drill: "not the nose radius: drill",
    unknown: "feed per revolution unknown",
  },
  table: (name: string) => `${name} by operation`,
  operation: "Operation",
  value: "Value",
};

export type LoadTexts = Shape<typeof load>;
