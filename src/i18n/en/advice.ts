import type { Shape } from "../shape.ts";

/** Advice on values, and cutting data. Numbers arrive as text. */
export const advice = {
  title: "Advice",
  lead: "Rules of thumb applied to your values. Estimates: machine, coating and clamping are not known.",
  none: "No advice on these values.",
  nothingOpen: "Open a program to get advice on its values.",
  mark: (n: number) => `Advice: ${n}`,
  show: "Show advice",
  take: (value: string) => `Use ${value}`,
  operation: (n: number, cycle: number) => `Operation ${n}, cycle ${cycle}`,
  of: {
    depthOverEdge: (depth: string, edge: string, most: string) =>
      `The pass is ${depth} mm deep, the edge ${edge} mm long. Max. two thirds of the edge: ${most} mm.`,
    feedOverNose: (feed: string, nose: string, most: string) =>
      `Feed ${feed} mm exceeds 0.8 × tool nose radius ${nose} mm. Max. ${most} mm.`,
    rough: (rz: string, feed: string, nose: string, wanted: string, better: string) =>
      `Feed ${feed} mm and nose radius ${nose} mm give Rz ${rz} µm (f² / 8r). For Rz ${wanted} µm: ${better} mm.`,
    power: (power: string, most: string, speed: string, better: string) =>
      `About ${power} kW at ${speed} m/min (Kienzle); the spindle has ${most} kW. Sufficient for an infeed of ${better} mm.`,
    speedLimited: (limit: string, held: string, smallest: string, left: string) =>
      `With SMAX ${limit} the cutting speed is constant down to ⌀ ${held}. At ⌀ ${smallest} only ${left} m/min remain.`,
    noLimit: (speed: string) =>
      `${speed} m/min without SMAX: towards the axis the spindle runs at its maximum speed. Enter a limit.`,
    speedFar: (speed: string, usual: string) =>
      `${speed} m/min is far from the usual starting value for this material, ${usual} m/min.`,
  },
  material: "Material",
  ofDevice: (material: string) => `Default: ${material}`,
  deviceMaterial: "Default material",
  groups: {
    P: "steel",
    M: "stainless steel",
    K: "cast iron",
    N: "non-ferrous metal",
    S: "difficult to machine",
    H: "hardened steel",
  },
  starting: "Starting values",
  startingLead:
    "For coated carbide, CBN for hardened steel. Starting values; follow the data of the insert manufacturer.",
  start: (material: string, speeds: string) => `${material}: start with ${speeds}.`,
  startSource: "Estimate from handbooks: coated carbide, CBN for hardened steel.",
  startOwn: "From your table.",
  values: {
    roughSpeed: "Speed, roughing",
    roughFeed: "Feed, roughing",
    finishSpeed: "Speed, finishing",
    finishFeed: "Feed, finishing",
    kc11: "kc1.1",
    mc: "mc",
  },
  units: { speed: "m/min", feed: "mm/rev", kc: "N/mm²" },
  spindle: "Cutting speed",
  table: {
    title: "Shop cutting data",
    lead:
      "Replace the values with your own; they are stored on this device and are part of the backup. Default " +
      "kc1.1 and mc follow tables of Röhm (steel, grey iron) and Iscar (the others): estimates.",
    name: "Material",
    group: "Group",
    power: "Spindle power, kW",
    add: "Add material",
    remove: (name: string) => `Remove ${name}`,
    reset: "Restore default values",
    save: "Export",
    open: "Import",
    taken: "The file was imported.",
    wrong: "This file contains no cutting data.",
    cell: (what: string, name: string) => `${what}, ${name}`,
    newName: "New material",
    refused: "Invalid value; the last valid value applies.",
  },
};

export type AdviceTexts = Shape<typeof advice>;
