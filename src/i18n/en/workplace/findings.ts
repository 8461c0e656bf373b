import type { Shape } from "../../shape.ts";

/**
 * The list of findings, the verdict on a program, and the warning before a program with errors is copied or exported.
 */
export const findings = {
  title: "Findings",
  list: "Findings, worst first",
  none: "No findings.",
  count: (n: number) => (n === 1 ? "1 finding" : `${n} findings`),
  more: (n: number) => (n === 1 ? "1 more finding is not listed." : `${n} more findings are not listed.`),
  severities: { error: "Error", warning: "Warning", info: "Notice" },
  inBlock: (block: string) => `block ${block}`,
  blockOf: (block: string, file: string) => `block ${block} of ${file}`,
  lineOf: (line: string, file: string) => `line ${line} of ${file}`,
  goTo: (place: string) => `Go to ${place}`,
  show: (mark: string) => `Show ${mark} in the lathe view`,
  places: {
    tool: "Tool",
    startX: "Start X",
    startZ: "Start Z",
    contour: "Contour",
    blank: "Blank",
    spindle: "Spindle",
  },
  fix: "Fix",
  otherFixes: "More remedies",
  insert: (text: string) => `Insert ${text}`,
  write: (text: string, block: string) => `Write ${text} in block ${block}`,
  meant: "This cut is intended",
  runOut: (value: string) => `Run-out ${value}`,
  endThread: (place: string) => `End the thread at ${place}`,
  relief: "Insert undercut (DIN 76)",
  reliefBefore: (name: string) => `Insert undercut ${name} before the thread`,
  createTool: (tool: string) => `Create tool ${tool}`,
  remove: (text: string) => `Remove ${text}`,
  betterWays: "Find improvements",
  residue: {
    askCycle: "Find a cycle",
    thick: (mm: string) => `Max. ${mm} mm thick.`,
    ask: "Find a tool",
    trying: "Trying the tools in the table …",
    all: (tool: string) => `Tool ${tool} leaves no residual material here.`,
    leaves: (tool: string, area: string) => `Tool ${tool} leaves ${area}.`,
    none: "No tool in the table removes more.",
  },
  verdict: {
    title: "Check",
    none: "–",
    proved: "Verified: no contour damage, no rapid traverse in stock",
    stays: (area: string) => `Verified; ${area} residual material`,
    warnings: (n: number) => (n === 1 ? "Verified, with 1 warning" : `Verified, with ${n} warnings`),
    holderUnknown: "Path verified, holder not checked",
    faults: (n: number) => (n === 1 ? "1 error" : `${n} errors`),
    unproved: "Not fully simulated",
    nothingCut: "An operation cut nothing",
    noCycle: "No cycle: no rapid traverse in stock",
    noOperation: "Not verified",
    milling: "Milling not verified",
    flanksUnknown: "Path verified, flanks not checked",
    curvatureUnknown: "Path verified, blade curvature not checked",
    faultsIn: (n: number, file: string) => (n === 1 ? `1 error, in ${file}` : `${n} errors, the first in ${file}`),
    unprovedIn: (file: string) => `${file} not fully simulated`,
    notes: "Path verified, with notes",
    because: {
      notes: {
        feed: "One feed is implausible.",
        air: "Most passes of one operation cut air.",
        residue: "More than 1 mm² of unintended residual material.",
        cutLength: "The cutting edge is too short for the depth of one operation.",
      },
      whatIn: (what: string, file: string) => `${what} in ${file}`,
      unproved: (what: string, block: string) => `Unverified from block ${block} on: ${what} is not simulated.`,
      unprovedAnywhere: (what: string) => `Unverified: ${what} is not simulated.`,
      nothingCut: (cycle: string, block: string) => `Cycle ${cycle}, called in block ${block}, cut nothing.`,
      milling: (block: string) => `Milling from block ${block} on changes the stock and is not verified.`,
      noCycle:
        "No turning cycle was run: rapid traverse was checked, but there is no contour to check the part against.",
      noOperation: "No turning cycle was run: there is nothing to check.",
      approachesClear: "Approach and departure are clear.",
      holderUnknown: (tools: string) => `The holder was not checked for tool ${tools}: the table describes none.`,
      flanksUnknown: (tools: string) => `The flanks were not checked for tool ${tools}: T-ANGLE or P-ANGLE is empty.`,
      curvatureUnknown: (tools: string) => `Tool ${tools}: the ⌀ range of the axial blade (DAXN, DAXX) is empty.`,
    },
  },
  leaving: {
    title: "This program has errors",
    lead: (n: number) =>
      n === 1
        ? "Do not run the program on a machine as it is. 1 error was found:"
        : `Do not run the program on a machine as it is. ${n} errors were found:`,
    unchecked: "This program is not checked yet",
    uncheckedLead: "The calculation is still running; there may be errors.",
    go: { copy: "Copy anyway", save: "Save anyway", download: "Download anyway", share: "Share anyway" },
    look: "Show the findings",
    cancel: "Cancel",
    withFaults: (n: number) => (n === 1 ? "The program has 1 error." : `The program has ${n} errors.`),
  },
  done: {
    contour: "The contour is still missing",
    toContour: "Enter the contour",
    faults: (n: number) =>
      n === 1 ? "All prompts answered, but 1 error was found" : `All prompts answered, but ${n} errors were found`,
  },
};

export type FindingsTexts = Shape<typeof findings>;
