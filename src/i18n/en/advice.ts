import type { Shape } from "../shape.ts";

/** Advice on values, and cutting data. Numbers arrive as text. */
export const advice = {
  title: "Advice",
  lead: "Rules of the trade applied to your values. They are estimates: neither machine, coating nor clamping is known here.",
  none: "Nothing to advise on these values.",
  nothingOpen: "Open a work to get advice on its values.",
  mark: (n: number) => `Advice: ${n}`,
  show: "Give advice",
  take: (value: string) => `Take ${value}`,
  operation: (n: number, cycle: number) => `Operation ${n}, cycle ${cycle}`,
  of: {
    depthOverEdge: (depth: string, edge: string, most: string) =>
      `The pass is ${depth} mm deep, the edge is ${edge} mm long. Two thirds of it, ${most} mm, is what an edge should bear.`,
    feedOverNose: (feed: string, nose: string, most: string) =>
      `A feed of ${feed} mm is more than 0.8 of the nose radius ${nose} mm. Up to ${most} mm the nose stays whole.`,
    rough: (rz: string, feed: string, nose: string, wanted: string, better: string) =>
      `Feed ${feed} mm and nose ${nose} mm leave Rz ${rz} µm (f² / 8r). Rz ${wanted} µm takes ${better} mm.`,
    power: (power: string, most: string, speed: string, better: string) =>
      `About ${power} kW at ${speed} m/min (Kienzle); the spindle has ${most} kW. An infeed of ${better} mm needs no more.`,
    speedLimited: (limit: string, held: string, smallest: string, left: string) =>
      `With SMAX ${limit} the cutting speed is held down to ⌀ ${held}. At ⌀ ${smallest} only ${left} m/min of it are left.`,
    noLimit: (speed: string) =>
      `${speed} m/min without SMAX: towards the axis the spindle turns as fast as it can. Give it a limit.`,
    speedFar: (speed: string, usual: string) =>
      `${speed} m/min is far from the ${usual} m/min that this material usually starts with.`,
  },
  material: "Material",
  ofDevice: "as on this device",
  deviceMaterial: "Material of works that name none",
  groups: {
    P: "steel",
    M: "stainless steel",
    K: "cast iron",
    N: "non-ferrous metal",
    S: "hard to cut",
    H: "hardened steel",
  },
  starting: "Starting values",
  startingLead: "For coated carbide, hardened steel for CBN, to begin with; the insert’s maker knows better.",
  start: (material: string, speeds: string) => `${material}: ${speeds} as a start.`,
  startSource: "Estimate from handbooks: coated carbide, CBN for hardened steel.",
  startOwn: "From your own table.",
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
    title: "Cutting data of the shop",
    lead:
      "Replace the values by your own; they stay on this device and go into the file of everything. " +
      "kc1.1 and mc as shipped follow tables of Röhm (steel, grey iron) and Iscar (the others): estimates.",
    name: "Material",
    group: "Group",
    power: "Power of the spindle, kW",
    add: "Add a material",
    remove: (name: string) => `Remove ${name}`,
    reset: "Back to the shipped values",
    save: "Save as a file",
    open: "From a file",
    taken: "The file has been taken over.",
    wrong: "This file holds no cutting data.",
    cell: (what: string, name: string) => `${what}, ${name}`,
    newName: "New material",
    refused: "This value cannot stand there; the last one that could counts.",
  },
};

export type AdviceTexts = Shape<typeof advice>;
