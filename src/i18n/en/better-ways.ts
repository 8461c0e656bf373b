import type { Shape } from "../shape.ts";

/** Improvements of a program: tried changes, each with its gain. */
export const betterWays = {
  title: "Improvements",
  about: "Each suggestion was simulated: same part, no rougher surface, no additional findings.",
  list: "Suggestions",
  preparing: "Looking for changes …",
  trying: (tried: number, of: number) => `${tried} of ${of} changes tried`,
  found: (n: number, of: number) =>
    n === 1 ? `1 improvement; ${of} changes tried.` : `${n} improvements; ${of} changes tried.`,
  none: (of: number) => `No improvement found; ${of} changes tried.`,
  nothing: "There is no change to try in this program.",
  stopped: (tried: number, of: number) => `Stopped: ${tried} of ${of} changes tried.`,
  failed: "The program could not be calculated.",
  stop: "Stop",
  again: "Search again",
  use: "Use",
  useLong: (what: string) => `Use: ${what}`,
  used: (what: string) => `Used: ${what}.`,
  undo: "Undo",
  updating: "Trying again with the changed program …",
  noTime: "The machine data state no tool change time: a change counts 0 s.",
  faulty: "The program has errors: only changes with a better check result are suggested.",
  noMaterial: "The program states no material: no cutting data are suggested.",
  and: (first: string, last: string) => `${first} and ${last}`,
  operation: (n: number, title: string) => (title === "" ? `Operation ${n}` : `Operation ${n} “${title}”`),
  operations: (numbers: string) => `Operations ${numbers}`,
  gains: {
    verdict: "Better check result",
    residualGone: (tool: string) => (tool === "" ? "No residual material" : `No residual material with tool ${tool}`),
    residualLess: (area: string) => `${area} less residual material`,
    bendsLess: (length: string) => `Workpiece deflects ${length} less`,
    toolGone: (tool: string) => `Tool ${tool} not needed`,
    toolsLess: (n: number) => (n === 1 ? "1 tool less" : `${n} tools less`),
    changesLess: (n: number) => (n === 1 ? "1 tool change less" : `${n} tool changes less`),
    shorter: (time: string) => `${time} shorter`,
  },
  measures: {
    seconds: "Time",
    tools: "Tools",
    changes: "Tool changes",
    residual: "Residual material",
    bending: "Deflection",
  },
  kinds: {
    noCut: (operation: string) => `${operation} cuts nothing and is deleted.`,
    fewerTools: (operations: string, tool: string) =>
      `${operations} with tool ${tool}, which the program calls anyway.`,
    severalTools: (operations: string, tools: string) =>
      `${operations} with tools ${tools}, which the program calls anyway.`,
    fewerChanges: (operation: string, next: string) => `${operation} is moved to ${next}: both use the same tool.`,
    restOperation: (operation: string, tool: string) =>
      `${operation}, then one more operation with tool ${tool} for the residual material.`,
    otherTool: (operation: string, tool: string, instead: string) =>
      `${operation} with tool ${tool} instead of ${instead}.`,
    otherCycle: (operation: string, cycle: string) => `${operation} with cycle ${cycle}.`,
    otherCycleAndTool: (operation: string, cycle: string, tool: string) =>
      `${operation} with cycle ${cycle} and tool ${tool}.`,
    otherChoice: (operation: string, value: string) => `${operation}: ${value}.`,
    infeed: (operation: string, value: string, tool: string, most: string) =>
      `${operation}: ${value}. Cautious limit for tool ${tool}, from cutting edge, spindle power and stiffness: ${most}.`,
    stiffness: (operation: string, value: string, most: string) =>
      `${operation}: ${value}. The workpiece is slender; at most ${most} is allowed for its deflection.`,
    start: (operation: string, axis: string, from: string, to: string) =>
      `${operation} cuts air at first: start at ${axis} ${to} instead of ${from}.`,
    oneCall: (operations: string) => `${operations} in one call, roughing and finishing.`,
    cuttingSpeed: (operations: string, from: string, to: string, material: string) =>
      `${operations}: cutting speed ${from} → ${to} m/min, from the cutting data of ${material}.`,
    feed: (operation: string, value: string, material: string) =>
      `${operation}: ${value}, from the cutting data of ${material} and the tool nose.`,
  },
} as const;

export type BetterWaysTexts = Shape<typeof betterWays>;
