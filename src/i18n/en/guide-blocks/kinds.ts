import type { BlockKind } from "../../../nc/blocks/names.ts";

/** Kinds without a page here: approaches have a separate page, and the others need none. */
type Unpaged = "approach" | "departure" | "empty" | "unknown";

/** Function of each kind of block, the rule of the control, and common mistakes. */
export const blockKinds = {
  begin: {
    about: "The first block: name and unit of the program.",
    rule: "Program name and file name must be the same.",
    mistakes: ["The file is renamed and the block keeps the old name."],
  },
  end: {
    about: "The last block. Later blocks are not executed.",
    rule: "Name and unit are those of BEGIN PGM.",
    mistakes: ["M30 is missing: spindle and coolant stay on at the end."],
  },
  blankBox: {
    about:
      "Cuboid blank, defined by minimum point (0.1) and maximum point (0.2). In turning, it is treated as the " +
      "cylinder around its corners.",
    rule: "0.1 contains the spindle axis; 0.2 has the larger value in each axis.",
    mistakes: ["The points are swapped: the box has no volume."],
  },
  blankCylinder: {
    about: "Cylindrical blank: ⌀ or radius, length, distance of the face from Z0, and bore.",
    rule: "The blank is used for simulation only.",
    mistakes: ["The blank is smaller than the real one: the simulation shows air where the machine cuts."],
  },
  blankRotation: {
    about: "Forged or cast blank: a contour rotated about the axis.",
    rule: "The contour is in a label or a file; DIM defines diameter or radius values.",
    mistakes: ["The contour does not return to the axis: the end of the material is undefined."],
  },
  blankFile: {
    about: "Blank from an STL file. Kept, not simulated.",
    rule: "The file is in the folder of the program; TARGET selects the finished part.",
    mistakes: ["The file is not exported with the program."],
  },
  toolDefinition: {
    about: "Older definition of tool length and radius in the program.",
    rule: "If the tool is in the tool table, TOOL DEF with only a number prepares it in the tool changer.",
    mistakes: ["Used for turning tools: these require the turning tool table."],
  },
  toolCall: {
    about:
      "Changes the tool; without a tool, only speed, feed or deltas. After it, the tip position is unknown until " +
      "the next positioning.",
    rule: "TOOL CALL cancels FUNCTION TURNDATA CORR and radius compensation.",
    mistakes: ["The first block after it has one axis only: the other position is undefined."],
  },
  mode: {
    about: "Switches between turning and milling. In turning, X is a diameter and the turning spindle is active.",
    rule: "MODE TURN before the first turning block; the machine may require a kinematics name.",
    mistakes: ["The block is missing: X is a radius and turning cycles are rejected."],
  },
  spin: {
    about: "Speed of the turning spindle: constant cutting speed with a limit, or a fixed speed.",
    rule: "Applies until the next SPIN block. It does not start the spindle: program M3 or M4.",
    mistakes: ["The block is after the first cut."],
  },
  turnCorrection: {
    about: "Corrects the tool length in the program, without the tool table.",
    rule: "Applies until the next TOOL CALL.",
    mistakes: ["Wrong sign: a larger DXL makes an outside diameter larger."],
  },
  turnBlank: {
    about: "Blank update: the control records the removed material, so cycles avoid air cuts.",
    rule: "Active between BLANK and BLANK OFF; the outline must be closed.",
    mistakes: ["It stays on for a second clamping: the old blank still applies."],
  },
  L: {
    about: "Straight line to a point. Omitted axes do not move.",
    rule: "Feed, compensation and M functions are modal.",
    mistakes: ["The sign is missing: Z25 is in front of the part."],
  },
  LP: {
    about: "Straight line to a point defined by distance and angle from the pole CC.",
    rule: "Requires a CC block before it.",
    mistakes: ["Another CC is in between: the point changes."],
  },
  C: {
    about: "Arc about the centre CC to the end point.",
    rule: "Start and end must be on one circle about CC.",
    mistakes: ["The end point is not on the circle: the control stops with an error."],
  },
  CP: {
    about: "Arc about CC up to an angle.",
    rule: "The radius is the distance from the start to CC.",
    mistakes: ["DR is missing: the arc runs in the other direction."],
  },
  CR: {
    about: "Arc to a point, defined by the radius.",
    rule: "Four arcs are possible: the sign of R and DR select one.",
    mistakes: ["The radius is less than half the distance: no arc is possible."],
  },
  CT: {
    about: "Arc tangential to the previous element.",
    rule: "Requires two coordinates and a previous element.",
    mistakes: ["Used after a corner that should remain sharp."],
  },
  CTP: {
    about: "Tangential arc to a point defined from the pole CC.",
    rule: "CC is not the centre here; it is the reference point.",
    mistakes: ["The pole is taken for the centre of the arc."],
  },
  CC: {
    about: "Centre of C and CP, and pole of all polar blocks.",
    rule: "No movement; applies until the next CC.",
    mistakes: ["X is entered as a radius in turning; it is a ⌀."],
  },
  RND: {
    about: "Rounds the corner between the previous and the next block, without an end point.",
    rule: "Must be between two path blocks of the plane.",
    mistakes: ["The next block is too short for the radius."],
  },
  chamfer: {
    about: "Chamfers the corner between two straight blocks, same length on both sides.",
    rule: "Must be between two straight blocks.",
    mistakes: ["The length of the slope is entered; the length along the edge is required."],
  },
  free: {
    about: "Element of a free contour with the values given in the drawing. Kept, not simulated.",
    rule: "The control calculates the missing values from all elements.",
    mistakes: ["Not enough values: no solution."],
  },
  undercut: {
    about: "Undercut of standard form between a cylinder and its face. Omitted words take the standard values.",
    rule: "Must be in the contour of a cycle, between the two elements.",
    mistakes: ["Programmed in the main program: no effect there."],
  },
  groove: {
    about: "Recess in the previous straight element.",
    rule: "Must be in the contour of a cycle.",
    mistakes: ["The recess is wider than the element."],
  },
  label: {
    about: "Start of a subprogram, a program section repeat or a contour. LBL 0 ends a subprogram.",
    rule: "Each number or name only once in a program.",
    mistakes: ["The subprogram is before M30: it runs once more without a call."],
  },
  call: {
    about: "Executes the blocks after a label, once or several times.",
    rule: "Without REP: up to LBL 0. With REP: the section is repeated.",
    mistakes: ["REP is the number of repeats: 3 runs the section four times."],
  },
  jump: {
    about: "Jumps to a label if a condition is true.",
    rule: "Both sides may be numbers or parameters.",
    mistakes: ["Nothing in the loop changes the parameter: it never ends."],
  },
  raise: {
    about: "Stops the program with this error number.",
    rule: "The machine builder defines the text.",
    mistakes: ["Programmed where every run passes."],
  },
  contour: {
    about: "Selects the labels with the contour for the next cycle.",
    rule: "Consecutive labels form one list.",
    mistakes: ["The label is missing or in another file."],
  },
  cycleLine: {
    about: "A line of an older cycle. The first line has .0.",
    rule: "The lines of a cycle must be consecutive.",
    mistakes: ["A line is deleted: the cycle reads the next one instead."],
  },
  cycle: {
    about: "A cycle that is kept but not simulated: its values do not change.",
    rule: "Effective at its call or from its definition.",
    mistakes: ["Its effect is taken for verified: the program is unverified from here."],
  },
  cycleCall: {
    about: "Executes the last defined cycle from the current tool position.",
    rule: "M99 in a positioning block does the same; M89 calls in every block until M99.",
    mistakes: ["The tool is in the material at the call."],
  },
  selectContour: {
    about: "Selects a file with the contour of the next cycle.",
    rule: "The file is in the folder of the program.",
    mistakes: ["The file extension is missing."],
  },
  contourDefinition: {
    about: "Areas, islands and voids of a contour in one block.",
    rule: "P is an area, I an island, V a void.",
    mistakes: ["An island is before its area."],
  },
  declareContour: {
    about: "Gives a contour a name for a contour formula.",
    rule: "Kept unchanged, not simulated.",
    mistakes: ["The name is used twice."],
  },
  contourFormula: {
    about: "Combines declared contours: union, intersection, difference.",
    rule: "Kept unchanged, not simulated.",
    mistakes: ["Parentheses are missing: operators apply from left to right."],
  },
  callProgram: {
    about: "Executes another program here.",
    rule: "After its END PGM this program continues.",
    mistakes: ["M30 in the called program ends everything."],
  },
  selectProgram: {
    about: "Selects the program for CALL SELECTED PGM.",
    rule: "The name can be a QS parameter.",
    mistakes: ["Another selection in between applies instead."],
  },
  callSelected: {
    about: "Executes the last selected program.",
    rule: "Requires SEL PGM before it.",
    mistakes: ["Nothing was selected."],
  },
  datum: {
    about: "Shifts the datum: the following coordinates refer to the new datum.",
    rule: "Applies until the next datum shift; RESET cancels it.",
    mistakes: ["Still active in the second half of the program."],
  },
  datumTable: {
    about: "Shifts the datum by a row of a datum table. The table is not known here.",
    rule: "The table must be selected.",
    mistakes: ["Another table is active on the machine."],
  },
  mirror: {
    about: "Mirrors the coordinates of milled blocks.",
    rule: "RESET, or no axis, cancels mirroring.",
    mistakes: ["Climb milling becomes conventional milling."],
  },
  rotation: {
    about: "Rotates the plane of milled blocks about the datum.",
    rule: "RESET cancels it.",
    mistakes: ["The pole is rotated too."],
  },
  scale: {
    about: "Scales milled coordinates.",
    rule: "RESET cancels it.",
    mistakes: ["A percentage is entered: 99 enlarges 99 times."],
  },
  plane: {
    about: "Tilts the working plane, or resets it. Tilted machining is not simulated.",
    rule: "MOVE, TURN or STAY define the axis movement.",
    mistakes: ["The plane is not reset before turning."],
  },
  assign: {
    about: "Assigns or calculates a Q parameter.",
    rule: "Q is valid in all programs, QL in one program, QR is kept after switching off.",
    mistakes: ["The parameter is used by a cycle."],
  },
  assignText: {
    about: "Assigns text to a QS parameter.",
    rule: "Parts are joined with ||.",
    mistakes: ["The quotation marks are missing."],
  },
  functions: {
    about: "M functions without movement: spindle, coolant, feed unit.",
    rule: "Some are effective before the movement of the block, some after it.",
    mistakes: ["M136 is missing before the first feed per revolution."],
  },
  stop: {
    about: "Program stop until NC start.",
    rule: "Spindle and coolant stay on unless an M function changes them.",
    mistakes: ["Programmed in the cut: the edge rubs at one point."],
  },
  comment: {
    about: "Text for the reader of the program.",
    rule: "No effect on machining.",
    mistakes: ["The comment has outdated values."],
  },
  structure: {
    about: "Heading in the program structure.",
    rule: "The structure view of the control shows it.",
    mistakes: ["Blocks are moved without their heading."],
  },
} satisfies Readonly<Record<Exclude<BlockKind, Unpaged>, { about: string; rule: string; mistakes: readonly string[] }>>;
