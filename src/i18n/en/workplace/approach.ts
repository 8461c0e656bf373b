import type { Shape } from "../../shape.ts";

/**
 * Approach and departure: prompts, picture, choice of a form, and the view of the working plane. Numbers arrive as
 * text.
 */
export const approach = {
  form: (block: string) => `Prompts of ${block}`,
  approach: "Approach",
  departure: "Departure",
  value: (word: string, prompt: string) => `${word}: ${prompt}`,
  list: "All prompts of the block",
  empty: "not set",
  left: "omitted",
  function: "Function",
  otherForm: "Change function",
  incremental: "Prefix I: incremental",
  parameter: "Q parameter without a value; no drawing yet.",
  /* the programmed point: PA of an approach, PN of a departure */
  ends: {
    PA: {
      label: "point PA",
      prompt: (axis: string) => `${axis} of the first contour point PA?`,
      about: "Point of the contour where the cut begins, as on the drawing; not the tool centre.",
    },
    PN: {
      label: "point PN",
      prompt: (axis: string) => `${axis} of the end point PN?`,
      about: "Position after the departure, outside the contour, without radius compensation.",
    },
  },
  /* one prompt each */
  words: {
    Z: {
      label: "tool axis",
      prompt: "Depth or height in the tool axis?",
      about: "If omitted, the tool keeps its height. TNC 640 moves in the plane first, TNC7 in all axes at once.",
    },
    PR: { label: "polar radius", prompt: "Distance from the pole CC?", about: "The pole is the previous CC block." },
    PA: {
      label: "polar angle",
      prompt: "Angle about the pole CC?",
      about: "Measured from the first axis; counterclockwise is positive.",
    },
    LEN: {
      label: "length",
      prompt: "Length of the straight line?",
      about: "From the auxiliary point PH to PA, or from PE to PN. With LN a minus sign selects the other side.",
    },
    CCA: {
      label: "centre angle",
      prompt: "Centre angle of the arc?",
      about: "Angle that the arc covers, up to 360°.",
    },
    R: {
      label: "radius",
      prompt: "Radius of the arc?",
      about: "Radius of the path of the tool centre. With CT a minus sign puts the arc on the side of the workpiece.",
    },
    SIDE: {
      label: "compensation",
      prompt: "Radius compensation: RL, RR or R0?",
      about: "RL: tool to the left of the contour, RR: to the right, R0: on the contour.",
    },
    F: { label: "feed", prompt: "Feed?", about: "Active from PH; with LCT from PS. FMAX and FAUTO are possible." },
    M: { label: "function", prompt: "Miscellaneous function M?", about: "Separate several functions with spaces." },
  },
  sides: { RL: "left of the contour", RR: "right of the contour", R0: "without compensation" },
  shapes: {
    LT: { name: "straight, tangential", about: "A straight line tangential to the contour." },
    LN: { name: "straight, perpendicular", about: "A straight line perpendicular to the contour." },
    CT: { name: "arc, tangential", about: "An arc with a centre angle, tangential to the contour." },
    LCT: {
      name: "line and arc, tangential",
      about: "A straight line and an arc, both tangential: the radius alone defines them.",
    },
  },
  /* the picture */
  picture: (block: string, points: string) => `Drawing of ${block}. ${points}`,
  point: (name: string, where: string) => `${name} at ${where}`,
  points: {
    PS: "start point",
    PH: "auxiliary point",
    PA: "first contour point",
    PE: "last contour point",
    PN: "end point",
    centre: "centre of the arc",
  },
  drag: "Drag a point to change its value, or enter the value in the prompts.",
  noPicture: "The drawing appears when the point is complete and the block is next to a contour element.",
  stale: "Last valid drawing",
  dots: { contour: "on the contour", centre: "tool centre" },
  pointTable: "Points of APPR and DEP",
  lines: { centre: "path of the tool centre", block: "feed of the block", before: "previous feed", rapid: "rapid" },
  /* choosing */
  coordinates: {
    title: "Coordinates of the point",
    cartesian: "Cartesian",
    polar: "Polar",
    noPole: "Polar functions (PLT, PLN, PCT, PLCT) need a pole: insert CC before this block.",
  },
  choose: "Choose a function",
  chooseAbout: "All eight functions on the same contour, with the same tool.",
  take: (block: string, name: string) => `${block}: ${name}`,
  chosen: "chosen",
  /* the working plane */
  view: "View of the working plane",
  viewPicture: (state: string) => `Working plane, X to the right, Y upwards. ${state}`,
  depth: "Depth",
  depthStrip: (low: string, high: string) => `Z along the path, from ${low} to ${high}`,
  free: "Free",
  pointAt: (name: string, where: string, block: string) => `${name}: ${where}, block ${block}`,
  feedMove: "Feed",
  milled: {
    title: "Milled to Z",
    depth: (z: string) => `to Z ${z}`,
    shoulder: (z: string) => `not milled, Z ${z}`,
    lower: (z: string) => `below Z ${z}`,
    drawn: "Milled stock is drawn, not verified: flat cutter from above, radius from the tool table.",
    noBlank: "No blank in this plane",
    tooLong: (most: string) => `More than ${most} motions: the path is drawn without stock.`,
    noRadius: "A tool without a radius removes nothing in the drawing.",
    rapid: (blocks: string) => `Rapid traverse through material: block ${blocks}`,
  },
  compensated: "Path of the tool centre",
  radius: "R",
  toolUnknown: "tool radius unknown",
  moves: (count: string) => `Moves (${count})`,
};

export type ApproachTexts = Shape<typeof approach>;
