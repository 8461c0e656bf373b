import type { Shape } from "../../shape.ts";

/** The list of findings, the verdict on a program, and the question before a program with faults leaves the page. */
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
  fix: "Correct it",
  insert: (text: string) => `Insert ${text}`,
  write: (text: string, block: string) => `Write ${text} in block ${block}`,
  meant: "This cut is meant",
  remove: (text: string) => `Remove ${text}`,
  residue: {
    askCycle: "Which cycle takes it away?",
    thick: (mm: string) => `It is up to ${mm} mm thick.`,
    ask: "Which tool takes it?",
    trying: "The tools of the table are being tried.",
    all: (tool: string) => `Tool ${tool} leaves nothing here.`,
    leaves: (tool: string, area: string) => `Tool ${tool} leaves ${area}.`,
    none: "No tool of the table takes more of it.",
  },
  verdict: {
    title: "Proof",
    none: "–",
    proved: "Proved: no gouge, no rapid in stock",
    stays: (area: string) => `Proved; ${area} of material stay`,
    warnings: (n: number) => (n === 1 ? "Proved, with 1 warning" : `Proved, with ${n} warnings`),
    holderUnknown: "Path proved, holder not checked",
    faults: (n: number) => (n === 1 ? "1 fault" : `${n} faults`),
    unproved: "Not everything was simulated",
    nothingCut: "An operation cut nothing",
    noCycle: "Without a cycle: no rapid in stock",
    noOperation: "Nothing is proved",
    milling: "Milling is not proved",
    flanksUnknown: "Path proved, flanks not checked",
    curvatureUnknown: "Path proved, blade curvature not checked",
    faultsIn: (n: number, file: string) => (n === 1 ? `1 fault, in ${file}` : `${n} faults, the first in ${file}`),
    unprovedIn: (file: string) => `Not everything in ${file} was simulated`,
    notes: "Path checked, see notes",
    because: {
      notes: {
        feed: "A feed is one that nobody means.",
        air: "Most passes of an operation cut air.",
        residue: "More than 1 mm² of material stays that nobody asked for.",
        cutLength: "The cutting edge is too short for the depth of an operation.",
      },
      whatIn: (what: string, file: string) => `${what} in ${file}`,
      unproved: (what: string, block: string) => `From block ${block} on nothing is proved: ${what} is not simulated.`,
      unprovedAnywhere: (what: string) => `${what} is not simulated: nothing is proved.`,
      nothingCut: (cycle: string, block: string) => `Cycle ${cycle}, called in block ${block}, cut nothing.`,
      milling: (block: string) => `Milling from block ${block} on changes the stock and is not proved.`,
      noCycle: "No turning cycle was run: rapids were looked at, but no contour is known to prove the part by.",
      noOperation: "No turning cycle was run: there is nothing to prove.",
      approachesClear: "Approach and departure are clear.",
      holderUnknown: (tools: string) => `The holder was not checked for tool ${tools}: the table describes none.`,
      flanksUnknown: (tools: string) => `The flanks were not checked for tool ${tools}: T-ANGLE or P-ANGLE is empty.`,
      curvatureUnknown: (tools: string) =>
        `No range of diameters is stated for the blade of tool ${tools}, which plunges along Z.`,
    },
  },
  leaving: {
    title: "This program has faults",
    lead: (n: number) =>
      n === 1
        ? "As it is it must not run on a machine. One fault was found:"
        : `As it is it must not run on a machine. ${n} faults were found:`,
    unchecked: "This program is not checked yet",
    uncheckedLead: "The calculation has not ended. Nobody knows whether there are faults in it.",
    go: {
      copy: "Copy all the same",
      save: "Save all the same",
      download: "Download all the same",
      share: "Share all the same",
    },
    look: "Show the findings",
    cancel: "Cancel",
    withFaults: (n: number) => (n === 1 ? "It has 1 fault." : `It has ${n} faults.`),
  },
  done: {
    contour: "The contour is still missing",
    toContour: "Enter the contour",
    faults: (n: number) =>
      n === 1
        ? "All prompts are answered, but 1 fault was found"
        : `All prompts are answered, but ${n} faults were found`,
  },
};

export type FindingsTexts = Shape<typeof findings>;
