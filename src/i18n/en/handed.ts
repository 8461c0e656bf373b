import type { Shape } from "../shape.ts";

const tools = (n: number) => (n === 1 ? "1 tool" : `${n} tools`);

export const handed = {
  title: "Hand on",
  lead:
    "Whoever opens it sees the same picture, the same numbers and the same verdict. No server takes part: everything is in the link, or " +
    "in the file.",
  working: "Finding out which tools it needs …",
  along: "What goes along",
  facts: {
    name: "Name",
    kind: "Kind",
    blocks: "Blocks",
    files: "Files beside it",
    tools: "Tools",
    control: "Control",
    machine: "Machine",
    size: "Size",
  },
  program: "Whole program",
  cycle: (number: number, name: string) => `Cycle ${number}, ${name}`,
  none: "none",
  kilobytes: (n: string) => `${n} kB`,
  link: "Link",
  copyLink: "Copy the link",
  linkLong: "Many mail programs and messengers cut links of this length. Hand on the file instead.",
  hereOnly: "This page is on this device only: another device cannot open the link. Hand on the file instead.",
  linkTooLong: "This makes a link that browsers do not open. Hand on the file instead.",
  qr: "QR code",
  qrName: (name: string) => `QR code of the link to ${name}`,
  qrHint: "Point the camera of a tablet at it.",
  qrTooLong: (length: string, most: string) =>
    `With ${length} characters the link is too long for a code that a camera reads; ${most} are the most.`,
  share: "Share …",
  files: "Files",
  file: "As a file",
  report: "Report (JSON)",
  reportHint:
    "The report is the same to the byte wherever this work is opened and left as it is: compare the two files.",
  noReport: "The calculation gave no report, so all tools of the table go along.",

  inside: (name: string) => `Open ${name}?`,
  from: { link: "This link carries a work.", file: "This file carries a work." },
  open: "Open",
  notNow: "Not now",
  ofItsOwn: "It becomes a work of its own; nothing of yours is changed.",
  bare: "none: it runs with the tools of this device",
  tool: (number: string, name: string) => `T${number} ${name}`.trim(),
  state: { same: "as in your table", free: "not in your table", differs: "other values than yours" },
  sameControl: "as on this device",
  otherControl: (mine: string) => `this device: ${mine}`,

  bar: (n: number) => `The open work runs with ${tools(n)} of its own.`,
  barControl: (control: string) => `The open work runs as on a ${control}, as it was handed on.`,
  barMachine: (machine: string) =>
    `The open work is timed with other machine data than those of this device: ${machine}.`,
  ofWork: "Tools of this work",
  ofWorkLead: "It was handed on with these tools and runs with them, not with the table of this device.",
  theirs: "With the work",
  mine: "In your table",
  column: "Column",
  becomes: (tool: string) => `What becomes of ${tool}`,
  as: { mine: "Keep mine", theirs: "Take theirs", free: "Put theirs at a free number" },
  keep: "Keep these tools in my table",
  kept: (added: number, replaced: number) =>
    [added > 0 && `${tools(added)} added to your table`, replaced > 0 && `${tools(replaced)} replaced in it`]
      .filter(Boolean)
      .join(", ") + ".",
  nothingToKeep: "Nothing to do: your table stays as it is.",
  allMine: "Your table has all of them as they are here.",
  moved: (from: number, to: number) =>
    `Tool ${from} of the work stands in your table as tool ${to}: TOOL CALL has to name ${to} there.`,
  changeCalls: (n: number) => (n === 1 ? "Change it in 1 TOOL CALL" : `Change it in ${n} TOOL CALLs`),
  callsChanged: "The program calls the new numbers.",
  useMine: "Use my table instead",
  control: (its: string, mine: string) => `Control of this work: ${its}. This device: ${mine}.`,
  useControl: (mine: string) => `Use ${mine} instead`,
  machine: (its: string, mine: string) => `Machine of this work: ${its}. This device: ${mine}.`,
  useMachine: "Use the machine data of this device",
  noMachine: "none",
};

export type HandedTexts = Shape<typeof handed>;
