import type { BlockKind } from "../../../nc/blocks/names.ts";

/** Kinds without a page: an approach has one of its own, and of the others there is nothing to say. */
type Unpaged = "approach" | "departure" | "empty" | "unknown";

/** What each kind of block does, the rule of the control for it, and what is often done wrong with it. */
export const blockKinds = {
  begin: {
    about: "The first block: name and unit of the program.",
    rule: "Name and file name have to be the same.",
    mistakes: ["The file is copied under another name and the block keeps the old one."],
  },
  end: {
    about: "The last block. What stands behind it is not run.",
    rule: "Name and unit are those of BEGIN PGM.",
    mistakes: ["M30 is left out: spindle and coolant stay on at the end."],
  },
  blankBox: {
    about:
      "A box as blank by its smallest corner (0.1) and its largest (0.2). A box that is turned is taken for " +
      "the cylinder round its corners.",
    rule: "0.1 names the spindle axis; 0.2 has the larger value in each axis.",
    mistakes: ["The corners are exchanged: the box has no volume."],
  },
  blankCylinder: {
    about: "The bar or disc that is turned: ⌀ or radius, length, distance of its face from Z0, and a bore.",
    rule: "The blank serves simulation alone; the machine does not know it.",
    mistakes: ["The blank is smaller than the real one: the picture shows air where the machine cuts."],
  },
  blankRotation: {
    about: "A forged or cast blank: a contour that is rotated round the axis.",
    rule: "The contour stands behind a label or in a file, and counts in the values of its DIM.",
    mistakes: ["The contour does not come back to the axis: nobody knows where the material ends."],
  },
  blankFile: {
    about: "A blank as a body in a file, STL. It is kept and not simulated here.",
    rule: "The file lies beside the program; TARGET names the finished part.",
    mistakes: ["The file is not taken along with the program."],
  },
  toolDefinition: {
    about: "An older way to tell length and radius of a tool in the program itself.",
    rule: "Where the tool stands in the table, TOOL DEF with a number alone gets it ready in the changer.",
    mistakes: ["It is used for turning tools: these need the table of turning tools."],
  },
  toolCall: {
    about:
      "Changes the tool, or with no tool in it only speed, feed or deltas. Behind it nobody knows where the " +
      "tip stands until it is positioned.",
    rule: "It ends the values of FUNCTION TURNDATA CORR and the radius compensation.",
    mistakes: ["The first block behind it names one axis only: the other comes from anywhere."],
  },
  mode: {
    about:
      "Changes between turning and milling. While turning X is a diameter and the spindle that turns is that of the part.",
    rule: "MODE TURN before the first turning block; the machine may ask for its kinematics.",
    mistakes: ["It is missing: X counts as a radius and cycles are refused."],
  },
  spin: {
    about: "How fast the part turns: constant cutting speed with a limit, or a fixed number of revolutions.",
    rule: "It counts until the next one. It does not start the spindle: M3 or M4 does.",
    mistakes: ["It stands behind the first cut."],
  },
  turnCorrection: {
    about: "Makes the tool longer or shorter in the program: a size is corrected without the table.",
    rule: "It counts until the next TOOL CALL.",
    mistakes: ["The sign is mixed up: more DXL makes an outside diameter larger."],
  },
  turnBlank: {
    about: "Blank tracing: the control remembers what was cut, so that a cycle does not cut air again.",
    rule: "On between BLANK and BLANK OFF; the outline has to be closed.",
    mistakes: ["It stays on for a second clamping: the old blank still counts."],
  },
  L: {
    about: "Straight to a point. Axes that are left out stay where they are.",
    rule: "Feed, compensation and M functions go on to count.",
    mistakes: ["A sign is missing: Z25 lies in front of the part."],
  },
  LP: {
    about: "Straight to a point by distance and angle from the pole CC.",
    rule: "A CC block stands before it.",
    mistakes: ["There is another CC in between: the point lies elsewhere."],
  },
  C: {
    about: "Arc round the centre CC to its end point.",
    rule: "Start and end lie on one circle round CC.",
    mistakes: ["The end point does not lie on the circle: the control stops with an error."],
  },
  CP: {
    about: "Arc round CC up to an angle.",
    rule: "The radius is the distance from the start to CC.",
    mistakes: ["DR is left out: the arc goes the other way."],
  },
  CR: {
    about: "Arc to a point by its radius.",
    rule: "Four arcs fit: the sign of R and DR choose one of them.",
    mistakes: ["The radius is smaller than half the way: there is no such arc."],
  },
  CT: {
    about: "Arc that goes on from the element before without a corner.",
    rule: "Two coordinates, and an element before it.",
    mistakes: ["It stands behind a corner that was meant to stay."],
  },
  CTP: {
    about: "Tangential arc to a point given from the pole CC.",
    rule: "CC is no centre here; it is the point that is measured from.",
    mistakes: ["The pole is taken for the centre of the arc."],
  },
  CC: {
    about: "Centre of C and CP, and pole of all polar blocks.",
    rule: "It moves nothing and counts until the next CC.",
    mistakes: ["X is typed as a radius while turning; it is a ⌀."],
  },
  RND: {
    about: "Rounds the corner between the blocks before and behind it, without end points of its own.",
    rule: "It stands between two path blocks of the plane.",
    mistakes: ["The block behind is too short for the radius."],
  },
  chamfer: {
    about: "Cuts the corner between two straight blocks off by the same length on both sides.",
    rule: "It stands between two straight blocks.",
    mistakes: ["The length of the slope is typed; the length along the edge is meant."],
  },
  free: {
    about: "An element of a free contour: as much as the drawing gives. It is kept and not run here.",
    rule: "The control works the missing values out from all elements together.",
    mistakes: ["No element has enough given: no solution."],
  },
  undercut: {
    about:
      "An undercut of a standard form between a cylinder and its face. Words that are left out come from the standard.",
    rule: "It stands in the contour of a cycle, between the two elements.",
    mistakes: ["It stands in the main program: there it does nothing."],
  },
  groove: {
    about: "A recess in the straight element before it.",
    rule: "It stands in the contour of a cycle.",
    mistakes: ["It is wider than its element leaves room for."],
  },
  label: {
    about: "A place that can be called: of a subprogram, a repeat, a contour. LBL 0 ends a subprogram.",
    rule: "Each number or name once in a program.",
    mistakes: ["The subprogram stands before M30: it runs once more by itself."],
  },
  call: {
    about: "Runs what stands behind a label, once or several times.",
    rule: "Without REP up to LBL 0; with REP the part before it again.",
    mistakes: ["REP counts the repeats: 3 runs the part four times."],
  },
  jump: {
    about: "Goes on at a label when a comparison holds.",
    rule: "Both sides may be numbers or parameters.",
    mistakes: ["Nothing in the loop changes the parameter: it never ends."],
  },
  raise: {
    about: "Stops the program with an error of this number.",
    rule: "The machine builder says which text belongs to it.",
    mistakes: ["It stands where every run comes by."],
  },
  contour: {
    about: "Names the labels whose contour the next cycle turns.",
    rule: "Several labels behind each other are one list.",
    mistakes: ["The label is missing or stands before END PGM of another file."],
  },
  cycleLine: {
    about: "A line of an older cycle. Its first line has .0.",
    rule: "The lines of one cycle stand behind each other.",
    mistakes: ["A line between them is deleted: the cycle reads the next one in its place."],
  },
  cycle: {
    about: "A cycle that is kept here and not run: its values stay as they are.",
    rule: "It acts where it is called, or where it stands.",
    mistakes: ["Its effect is taken for proved: from here on the report says it is not."],
  },
  cycleCall: {
    about: "Runs the cycle that was defined last, from where the tool stands.",
    rule: "M99 in a positioning block does the same; M89 does it in every block until M99.",
    mistakes: ["The tool stands in the material when it is called."],
  },
  selectContour: {
    about: "Takes the contour of the next cycle from a file.",
    rule: "The file lies beside the program.",
    mistakes: ["The ending is left out of the name."],
  },
  contourDefinition: {
    about: "Areas, islands and voids of a contour in one block.",
    rule: "P is an area, I an island, V a void.",
    mistakes: ["An island stands before the area that it lies in."],
  },
  declareContour: {
    about: "Gives a contour a name for a contour formula.",
    rule: "It comes back unchanged and is not run here.",
    mistakes: ["The name is used twice."],
  },
  contourFormula: {
    about: "Joins declared contours: united, cut, without.",
    rule: "It comes back unchanged and is not run here.",
    mistakes: ["Brackets are left out: the signs count from the left."],
  },
  callProgram: {
    about: "Runs another program in this place.",
    rule: "Behind its END PGM this program goes on.",
    mistakes: ["M30 in the called program ends everything."],
  },
  selectProgram: {
    about: "Names the program that CALL SELECTED PGM runs.",
    rule: "The name may stand in a QS parameter.",
    mistakes: ["Another selection in between counts instead."],
  },
  callSelected: {
    about: "Runs the program that was selected last.",
    rule: "A SEL PGM stands before it.",
    mistakes: ["Nothing was selected."],
  },
  datum: {
    about: "Moves the datum: what follows counts from there.",
    rule: "It counts until the next one; RESET takes it back.",
    mistakes: ["It is still on in the second half of the program."],
  },
  datumTable: {
    about: "Moves the datum by a row of a table. What stands in the table, nobody here knows.",
    rule: "The table has to be chosen.",
    mistakes: ["Another table is active on the machine."],
  },
  mirror: {
    about: "Mirrors the coordinates of milled blocks.",
    rule: "RESET, or no axis, ends it.",
    mistakes: ["Climb cutting becomes the other way."],
  },
  rotation: {
    about: "Turns the plane of milled blocks round the datum.",
    rule: "RESET ends it.",
    mistakes: ["The pole is turned as well."],
  },
  scale: {
    about: "Makes milled coordinates larger or smaller.",
    rule: "RESET ends it.",
    mistakes: ["Per cent are typed: 99 makes it 99 times as large."],
  },
  plane: {
    about: "Tilts the working plane, or resets it. Tilted work is not run here.",
    rule: "MOVE, TURN or STAY say what the axes do.",
    mistakes: ["It is not reset before turning."],
  },
  assign: {
    about: "Gives a Q parameter a value, or works it out.",
    rule: "Q counts in all programs, QL in its own, QR stays after switching off.",
    mistakes: ["The parameter is one that a cycle uses for itself."],
  },
  assignText: {
    about: "Puts text into a QS parameter.",
    rule: "Parts are joined with ||.",
    mistakes: ["The quotes are left out."],
  },
  functions: {
    about: "M functions without a path: spindle, coolant, unit of the feed.",
    rule: "Some act before the motion of their block, some behind it.",
    mistakes: ["M136 is missing before the first feed a turn."],
  },
  stop: {
    about: "Stops until NC start is pressed.",
    rule: "Spindle and coolant stay on unless an M function says otherwise.",
    mistakes: ["It stands in the cut: the edge rubs on one place."],
  },
  comment: {
    about: "Words for who reads the program.",
    rule: "They change nothing.",
    mistakes: ["A comment tells values that were changed since."],
  },
  structure: {
    about: "A heading in the list of parts of the program.",
    rule: "The structure view of the control shows it.",
    mistakes: ["Parts are moved and their headings stay."],
  },
} satisfies Readonly<Record<Exclude<BlockKind, Unpaged>, { about: string; rule: string; mistakes: readonly string[] }>>;
