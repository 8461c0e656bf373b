import type { Shape } from "../../shape.ts";

export const help = {
  picture: (cycle: string) => `Drawing of the contour, cycle ${cycle}`,
  highlighted: (parameter: string, label: string, value: string) => `Highlighted: ${parameter} ${label}, ${value}`,
  stale: "Invalid contour; last valid drawing",
  partial: "Q numbers represent values not entered yet.",
  noValue: "no value yet",
  inWords: {
    diameter: (value: string) => `diameter ${value} mm`,
    oversizeDiameter: (value: string) => `${value} mm on the diameter`,
    radial: (value: string) => `${value} mm on the radius`,
    axial: (value: string) => `Z ${value} mm`,
    axialDepth: (value: string) => `${value} mm along Z`,
    length: (value: string) => `${value} mm`,
    angle: (value: string) => `${value} degrees`,
    feed: (value: string) => `feed ${value}`,
    count: (value: string) => value,
    factor: (value: string) => `factor ${value}`,
    percent: (value: string) => `${value} percent`,
    revolutions: (value: string) => `${value} revolutions`,
    auto: "FAUTO, the feed of the tool call",
    choice: (value: string, meaning: string) => `${value}, ${meaning}`,
  },
  element: { none: "none", chamfer: "chamfer", radius: "radius" },
  reserved: "(no function)",
  notToScale: "not to scale",
};

export type HelpTexts = Shape<typeof help>;
