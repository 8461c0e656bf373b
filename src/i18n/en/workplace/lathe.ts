import type { Shape } from "../../shape.ts";

/** The lathe view: picture, playback, timeline, ruler, findings and the table of moves. Numbers arrive as text. */
export const lathe = {
  title: "Lathe view",
  pictures: {
    half: (state: string) => `Half section of the work, Z to the right. ${state}`,
    full: (state: string) => `Full section of the work, Z to the right. ${state}`,
    outside: (state: string) => `The work seen from outside, Z to the right. ${state}`,
  },
  countsFrom: (x: string, z: string) => `The program counts from X⌀ ${x}, Z ${z}.`,
  pictureEmpty: "No path yet",
  known: {
    soFar: (list: string) => `Known so far: ${list}.`,
    nothing: "No value of the contour is known yet.",
    elements: (n: number) => (n === 1 ? "1 element of the contour" : `${n} elements of the contour`),
    sketch: "contour with sharp corners",
    whole: "the whole contour",
  },
  keys: "Space plays or pauses, arrow keys go move by move, Home and End go to the ends, plus and minus zoom, 0 fits.",
  beginning: "First blocks of the program",
  outdated: "Last picture that could be made",
  stages: { reading: "Reading the program …", running: "Working out the path …", proving: "Cutting and checking …" },
  checking: "Being checked …",
  stopWorking: "Stop",
  stopped: "Stopped. Text and last picture stay.",
  workAgain: "Work it out",

  /* the view */
  viewTools: "View",
  section: "Section",
  sections: { title: "View", half: "Half section", full: "Full section", outside: "Outside view", solid: "3D" },
  xUp: "X up",
  xDown: "X down",
  zoomIn: "Zoom in",
  zoomOut: "Zoom out",
  fit: "Fit",
  which: "Which cycle makes this contour?",
  ruler: "Ruler",
  rulerFlat: "Measures in the section: 3D comes back after it",
  legend: "Lines",
  holder: "Holder",
  held: { stated: "Clamping, as stated", unstated: "Rear end: clamping not stated", note: "Clamping not stated" },
  paths: {
    title: "Which paths are shown",
    all: "All paths",
    operation: "This operation",
    phase: "This phase",
    pass: "This pass",
    none: "No paths",
  },
  colours: {
    title: "What is told by colour",
    none: "No colours",
    roughness: "Roughness Rz",
    depth: "Depth of cut",
    chip: "Chip area",
    feed: "Feed per turn",
    speed: "Cutting speed and limit",
  },
  stepList: {
    title: "Steps of the manual",
    unfold: "Show all steps",
    fold: "One line",
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
  forward: "One move forward",
  back: "One move back",
  first: "To the start",
  last: "To the end",
  speed: "Speed",
  timeline: "Timeline",
  timeOf: (now: string, total: string) => `${now} of ${total}`,
  operation: (cycle: string, tool: string) => `Cycle ${cycle}, tool ${tool}`,

  /* the running move */
  now: "Running move",
  axisX: "X ⌀",
  axisZ: "Z",
  feedName: "F",
  speedName: "S",
  rapid: "Rapid",
  perTurn: "mm/rev",
  perMinute: "mm/min",
  /** How long the tool stands still. */
  turns: (n: string) => `${n} rev`,
  rpm: "rpm",
  phases: { position: "Positioning", rough: "Roughing", smooth: "Smoothing", finish: "Finishing", thread: "Threading" },
  plunging: "Plunging",
  pass: (pass: string, of: string) => `Pass ${pass} of ${of}`,
  stepOnly: (step: string, of: string) => `Step ${step} of ${of}`,
  outside: "Between the cycles",
  block: (block: string) => `Block ${block}`,
  /** What the letters of the chip stand for. */
  chip: { ap: "depth of cut", f: "feed per turn", h: "chip thickness", b: "chip width", A: "chip area" },
  atStart: "At the start",
  atEnd: "At the end",

  /* ruler */
  takeInto: (value: string, q: string) => `Take ${value} into ${q}`,
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
  earlier: "Earlier moves",
  later: "Later moves",
  range: (from: string, to: string, of: string) => `${from} to ${to} of ${of}`,
  kinds: { rapid: "Rapid", feed: "Straight", arc: "Arc", thread: "Thread", dwell: "Dwell" },
  goTo: (move: string) => `Go to move ${move}`,

  /* a tool's insert */
  insert: (tool: string) => `Insert of tool ${tool}, to scale`,
};

export type LatheTexts = Shape<typeof lathe>;
