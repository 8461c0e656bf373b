import type { Shape } from "../shape.ts";
import { blockKinds } from "./guide-blocks/kinds.ts";
import { blockWords } from "./guide-blocks/words.ts";

/**
 * Pages of the guide for the blocks of a program and for the words in them. A word is named by its field; where one
 * kind of block gives it a special meaning, by both: "call.label".
 */
export const guideBlocks = {
  title: "Blocks of a program",
  lead: "Function of each block, and a page for each word.",
  words: "Words",
  toBlock: "Block",
  inProgram: "In the program",
  rule: "On the control",
  recalled: "Not verified against a manual; check on your control.",
  sampleLead: "A small program simulated with each of these.",
  ownLead: "Your program simulated with each of these; your program does not change.",
  /** Why a word has no animation. */
  why: {
    name: "No animation: a name has no effect on the path. It must match the name used elsewhere.",
    axis: "No animation: the simulation is in the Z/X plane, which does not contain this axis.",
    milling: "No animation: this applies to milling; only turning is shown.",
    free: "No animation: a free contour is kept but not simulated.",
    choice: "No animation: another choice requires other blocks and has no effect with these.",
    together: "No animation: this value depends on others. Changed alone, the control would reject the block.",
    compensation: "No animation here: compensation begins and ends with a straight block. See the page of L.",
    functions:
      "No animation here: of the M functions, only M136 and M137 change the cut. See the page of the M functions.",
    same: "No animation: other values give the same path and the same part.",
    yours: "Your block is not shown: other values give the same cut, or a cut that is not simulated, as in milling.",
  },
  functions: "M functions",
  kinds: blockKinds,
  of: blockWords,
  /** Rules of single words. */
  rules: {
    "blankCylinder.outside": "D is the ⌀, R the radius. The value must be larger than the bore.",
    "blankCylinder.length": "L is measured from the face towards the chuck.",
    "blankCylinder.distance": "DIST can be omitted: the face is then at Z0.",
    "blankCylinder.inside": "DI can be omitted for solid material.",
    "toolCall.tool": "A number, a name in quotes, or a QS parameter; 5.1 is an index of tool 5.",
    "spin.cuttingSpeed": "VC applies while VCONST is on.",
    "spin.speed": "S applies while VCONST is off.",
    "spin.speedLimit": "SMAX applies until another SPIN block changes it.",
    feed: "A feed is modal; a block without F keeps it.",
    X: "I before the axis makes the value incremental.",
    compensation: "Compensation begins and ends with a straight block. CC, RND and CHF keep it.",
    label: "LBL 0 may be used any number of times; other labels only once.",
    repeat: "Up to 65534.",
    target: "Q0 to Q99 are free for the operator.",
    functions: "Max. four; M functions of one group replace each other.",
    polarAngle: "Between −360° and +360°.",
    toolAxis: "Determines the plane: with Z it is X/Y in milling, Z/X in turning.",
  },
  m: {
    M0: "Program stop; continue with NC start.",
    M1: "Optional stop, if activated by the operator.",
    M3: "Spindle on, clockwise.",
    M4: "Spindle on, anticlockwise.",
    M5: "Spindle off.",
    M8: "Coolant on.",
    M9: "Coolant off.",
    M13: "Spindle clockwise and coolant on.",
    M14: "Spindle anticlockwise and coolant on.",
    M30: "End of program, return to the beginning.",
    M89: "Modal cycle call after every positioning block.",
    M91: "Coordinates in this block refer to the machine datum. Its position is not known here.",
    M92: "Coordinates in this block refer to a point defined by the machine builder.",
    M99: "Cycle call after this block.",
    M136: "Feed in mm per revolution.",
    M137: "Feed in mm per minute again.",
    M140: "Retraction along the tool axis by MB.",
    M303: "Turning spindle on; the machine builder defines the direction.",
    M304: "Turning spindle on, opposite direction.",
  },
};

export type GuideBlocksTexts = Shape<typeof guideBlocks>;
