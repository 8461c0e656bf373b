import type { Shape } from "../shape.ts";

const tools = (n: number) => (n === 1 ? "1 tool" : `${n} tools`);

export const handed = {
  title: "Share",
  lead: "The recipient sees the same simulation and the same result. No server is involved.",
  working: "Determining the required tools …",
  contents: "Contents",
  facts: {
    name: "Name",
    kind: "Kind",
    blocks: "Blocks",
    files: "Other files",
    tools: "Tools",
    control: "Control",
    machine: "Machine",
    size: "Size",
  },
  program: "NC program",
  cycle: (number: number, name: string) => `Cycle ${number}, ${name}`,
  none: "none",
  kilobytes: (n: string) => `${n} kB`,
  link: "Link",
  copyLink: "Copy the link",
  linkLong: "Many mail programs and messengers cut links of this length. Share the file instead.",
  hereOnly: "This page is on this device only: other devices cannot open the link. Share the file instead.",
  linkTooLong: "The link is too long for browsers. Share the file instead.",
  qr: "QR code",
  qrName: (name: string) => `QR code of the link to ${name}`,
  qrEnlarge: "Show the QR code full screen",
  qrHint: "Scan with the camera of a tablet.",
  qrTooLong: (length: string, most: string) =>
    `The link is too long for a QR code: ${length} characters, max. ${most}. Share the link or the file.`,
  share: "Share …",
  files: "Files",
  file: "As a file",
  report: "Report (JSON)",
  reportHint:
    "The report is identical, byte for byte, wherever this program is opened unchanged: compare the two files.",
  noReport: "No report is available, so all tools of the table are included.",

  inside: (name: string) => `Open ${name}?`,
  from: { link: "This link contains a program.", file: "This file contains a program." },
  open: "Open",
  notNow: "Not now",
  opensSeparately: "Opens as a separate program; your own programs are not changed.",
  bare: "none: uses the tools of this device",
  tool: (number: string, name: string) => `T${number} ${name}`.trim(),
  state: { same: "same as in your table", free: "not in your table", differs: "values differ from yours" },
  sameControl: "as on this device",
  otherControl: (mine: string) => `this device: ${mine}`,

  bar: (n: number) => `The open program uses ${tools(n)} of its own.`,
  barControl: (control: string) => `The open program is simulated for a ${control}, as shared.`,
  barMachine: (machine: string) =>
    `The times of the open program are based on other machine data than those of this device: ${machine}.`,
  ofWork: "Tools of this program",
  ofWorkLead: "This program was shared with these tools and uses them, not the table of this device.",
  theirs: "With the program",
  mine: "In your table",
  column: "Column",
  becomes: (tool: string) => `Action for ${tool}`,
  as: { mine: "Keep mine", theirs: "Use theirs", free: "Add theirs at a free number" },
  keep: "Add these tools to my table",
  kept: (added: number, replaced: number) =>
    [added > 0 && `${tools(added)} added to your table`, replaced > 0 && `${tools(replaced)} replaced in it`]
      .filter(Boolean)
      .join(", ") + ".",
  nothingToKeep: "Your table is unchanged.",
  allMine: "Your table already contains these tools with the same values.",
  moved: (from: number, to: number) =>
    `Tool ${from} of the program is tool ${to} in your table: TOOL CALL must name ${to} there.`,
  changeCalls: (n: number) => (n === 1 ? "Change 1 TOOL CALL" : `Change ${n} TOOL CALLs`),
  callsChanged: "The program calls the new numbers.",
  useMine: "Use my table instead",
  control: (its: string, mine: string) => `Control of this program: ${its}. This device: ${mine}.`,
  useControl: (mine: string) => `Use ${mine} instead`,
  machine: (its: string, mine: string) => `Machine of this program: ${its}. This device: ${mine}.`,
  useMachine: "Use the machine data of this device",
  noMachine: "none",
};

export type HandedTexts = Shape<typeof handed>;
