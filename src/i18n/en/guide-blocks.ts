import type { Shape } from "../shape.ts";
import { blockKinds } from "./guide-blocks/kinds.ts";
import { blockWords } from "./guide-blocks/words.ts";

/**
 * Pages of the guide for the blocks of a program and for the words that one fills in there. A word is named by its
 * field; where it means something of its own in one kind of block, by both: "call.label".
 */
export const guideBlocks = {
  title: "Blocks of a program",
  lead: "What each block does, and a page for each of its words.",
  words: "Its words",
  toBlock: "The block",
  inProgram: "In the program",
  rule: "On the control",
  recalled: "Recalled, not read in a printed page: verify it on your control.",
  sampleLead: "The kernel has run a small program with each of these.",
  ownLead: "The kernel has run your program with each of these; your work stays as it is.",
  /** Why a word has no live picture. */
  why: {
    name: "There is no live picture: a name moves nothing. It only has to be the one that is meant elsewhere.",
    axis: "There is no live picture: the kernel cuts in the plane Z/X, and this axis does not lie in it.",
    milling: "There is no live picture: this counts for milling, and the kernel shows what turning cuts.",
    free: "There is no live picture: a free contour is kept here and not run.",
    choice:
      "There is no live picture: another choice wants other blocks round it, and with the same ones it shows nothing.",
    together:
      "There is no live picture: this value goes together with others. With it alone changed, the control would not take the" +
      " block.",
    compensation:
      "There is no live picture here: compensation begins and ends with a straight block. The page of L shows it.",
    functions:
      "There is no live picture here: of the M functions, M136 and M137 change the cut. The page of the M functions shows that.",
    same: "There is no live picture: with other values the tool goes the same way and leaves the same part.",
    yours:
      "Your own block is not shown: with other values the same is cut there, or nothing that the kernel can cut, as in a" +
      " milled plane.",
  },
  functions: "M functions",
  kinds: blockKinds,
  of: blockWords,
  /** Where a word has a rule of its own. */
  rules: {
    "blankCylinder.outside": "D is the ⌀, R the radius. It has to be larger than the bore.",
    "blankCylinder.length": "L counts from the face towards the chuck.",
    "blankCylinder.distance": "DIST may be left out: the face then lies in Z0.",
    "blankCylinder.inside": "DI may be left out for full material.",
    "toolCall.tool": "A number, a name in quotes, or a QS parameter; 5.1 is an index of tool 5.",
    "spin.cuttingSpeed": "VC counts while VCONST is on.",
    "spin.speed": "S counts while VCONST is off.",
    "spin.speedLimit": "SMAX holds until another SPIN block gives one.",
    feed: "A feed counts until the next one; a block without F keeps it.",
    X: "I in front of the axis makes it incremental.",
    compensation: "It begins and ends with a straight block. CC, RND and CHF keep it.",
    label: "LBL 0 may stand as often as needed; no other twice.",
    repeat: "Up to 65534.",
    target: "Q0 to Q99 are free for the operator.",
    functions: "At most four of them; M functions of one group replace each other.",
    polarAngle: "Between −360° and +360°.",
    toolAxis: "It decides the plane: with Z it is X/Y while milling, Z/X while turning.",
  },
  m: {
    M0: "Stops; NC start goes on.",
    M1: "Stops where the operator has switched that on.",
    M3: "Spindle on, clockwise.",
    M4: "Spindle on, anticlockwise.",
    M5: "Spindle off.",
    M8: "Coolant on.",
    M9: "Coolant off.",
    M13: "Spindle clockwise and coolant on.",
    M14: "Spindle anticlockwise and coolant on.",
    M30: "End of the program, back to its beginning.",
    M89: "Calls the cycle behind every positioning block.",
    M91: "Coordinates of this block count from the machine datum. Where that is, nobody here knows.",
    M92: "Coordinates of this block count from a point of the machine builder.",
    M99: "Calls the cycle behind this block.",
    M136: "Feeds count in mm a turn.",
    M137: "Feeds count in mm a minute again.",
    M140: "Back along the tool axis by MB.",
    M303: "Spindle of the turned part on; which sense, the machine builder says.",
    M304: "Spindle of the turned part on, the other way.",
  },
};

export type GuideBlocksTexts = Shape<typeof guideBlocks>;
