import type { Shape } from "../../shape.ts";

/** The lathe view: picture, playback, timeline, ruler, findings and the table of moves. Numbers arrive as text. */
export const lathe = {
  title: "Lathe view",
  pictures: {
    half: (state: string) => `Half section of the workpiece, Z to the right. ${state}`,
    full: (state: string) => `Full section of the workpiece, Z to the right. ${state}`,
    outside: (state: string) => `Outside view of the workpiece, Z to the right. ${state}`,
  },
  countsFrom: (x: string, z: string) => `Program datum at X⌀ ${x}, Z ${z}.`,
  pictureEmpty: "No tool path yet",
  known: {
    soFar: (list: string) => `Known so far: ${list}.`,
    nothing: "No contour values yet.",
    elements: (n: number) => (n === 1 ? "1 element of the contour" : `${n} elements of the contour`),
    sketch: "contour with sharp corners",
    whole: "the complete contour",
  },
  keys: "Space plays or pauses, arrow keys go to the next or previous move, Home and End to the start and end, plus and minus zoom, 0 fits.",
  beginning: "First blocks of the program",
  outdated: "Last valid simulation",
  stages: { reading: "Reading the program …", running: "Calculating the path …", proving: "Simulating and checking …" },
  checking: "Checking …",
  stopWorking: "Stop",
  stopped: "Stopped. The text and the last simulation are kept.",
  workAgain: "Calculate",

  /* the view */
  viewTools: "View tools",
  enlarge: "Enlarge the picture",
  reduce: "Reduce the picture",
  section: "Section",
  sections: { title: "View", half: "Half section", full: "Full section", outside: "Outside view", solid: "3D" },
  xUp: "X up",
  xDown: "X down",
  zoomIn: "Zoom in",
  zoomOut: "Zoom out",
  fit: "Fit",
  which: "Find a cycle for this contour",
  ruler: "Ruler",
  rulerFlat: "Measures in the section; 3D returns afterwards",
  legend: "Legend",
  holder: "Holder",
  held: { stated: "Specified clamping", unstated: "Rear end: clamping not specified", note: "Clamping not specified" },
  paths: {
    title: "Tool paths",
    all: "All paths",
    operation: "This operation",
    phase: "This phase",
    pass: "This pass",
    none: "No paths",
  },
  colours: {
    title: "Colour map",
    none: "No colour map",
    roughness: "Roughness Rz",
    depth: "Depth of cut",
    chip: "Chip area",
    feed: "Feed per revolution",
    speed: "Cutting speed and speed limit",
  },
  stepList: {
    title: "Steps of the manual",
    unfold: "Show all steps",
    fold: "Collapse",
  },
  lines: {
    rapid: "Rapid",
    feed: "Roughing",
    plunge: "Plunging",
    smooth: "Smoothing",
    finish: "Finishing",
    thread: "Thread",
  },

  /* playback */
  playback: "Playback",
  play: "Play",
  pause: "Pause",
  forward: "Next move",
  back: "Previous move",
  first: "To the start",
  last: "To the end",
  speed: "Speed",
  timeline: "Timeline",
  timeOf: (now: string, total: string) => `${now} of ${total}`,
  operation: (cycle: string, tool: string) => `Cycle ${cycle}, tool ${tool}`,

  /* the running move */
  now: "Current move",
  axisX: "X ⌀",
  axisZ: "Z",
  feedName: "F",
  speedName: "S",
  rapid: "Rapid",
  perTurn: "mm/rev",
  perMinute: "mm/min",
  /** Dwell of the tool. */
  turns: (n: string) => `${n} rev`,
  rpm: "rpm",
  phases: { position: "Positioning", rough: "Roughing", smooth: "Smoothing", finish: "Finishing", thread: "Threading" },
  plunging: "Plunging",
  pass: (pass: string, of: string) => `Pass ${pass} of ${of}`,
  stepOnly: (step: string, of: string) => `Step ${step} of ${of}`,
  outside: "Positioning, outside a cycle",
  block: (block: string) => `Block ${block}`,
  /** Meaning of the letters at the chip. */
  chip: { ap: "depth of cut", f: "feed per revolution", h: "chip thickness", b: "chip width", A: "chip area" },
  atStart: "At the start",
  atEnd: "At the end",

  /* ruler */
  takeInto: (value: string, q: string) => `Use ${value} for ${q}`,
  deltaX: "ΔX ⌀",
  deltaZ: "ΔZ",
  distance: "Distance",

  /* table of moves */
  moves: (count: string) => `Moves (${count})`,
  move: "Move",
  moveKind: "Kind",
  moveFeed: "Feed",
  movePhase: "Phase",
  moveBlock: "Block",
  earlier: "Previous",
  later: "Next",
  range: (from: string, to: string, of: string) => `${from} to ${to} of ${of}`,
  kinds: { rapid: "Rapid", feed: "Straight", arc: "Arc", thread: "Thread", dwell: "Dwell" },
  goTo: (move: string) => `Go to move ${move}`,

  /* a tool's insert */
  insert: (tool: string) => `Insert of tool ${tool}, to scale`,
};

export type LatheTexts = Shape<typeof lathe>;
