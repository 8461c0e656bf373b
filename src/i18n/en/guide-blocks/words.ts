/** What each word of a block does, by its field, and what is often done wrong with it. */
export const blockWords = {
  name: {
    about: "What the program is called.",
    mistakes: ["Blanks or umlauts stand in it: some controls refuse the file."],
  },
  unit: {
    about: "MM or INCH for all lengths and feeds of the program.",
    mistakes: ["Values are copied between programs of different units."],
  },
  toolAxis: {
    about: "The axis that the tool stands along. For turned parts it is Z.",
    mistakes: ["X or Y is left from a milling program."],
  },
  "blankBox.X": {
    about: "X of this corner. Round the axis the farthest corner decides.",
    mistakes: ["The ⌀ is typed; boxes count from the axis."],
  },
  "blankBox.Y": {
    about: "Y of this corner. Round the axis the farthest corner decides.",
    mistakes: ["The box lies beside the axis."],
  },
  "blankBox.Z": {
    about: "Z of this corner: 0.1 the back end, 0.2 the face.",
    mistakes: ["The face ends at Z0 though it is still rough."],
  },
  outsideMeasure: {
    about: "Whether the outside is given as ⌀ (D) or as radius (R).",
    mistakes: ["R is left and a ⌀ typed: the blank is twice as thick."],
  },
  insideMeasure: {
    about: "Whether the bore is given as ⌀ (DI) or as radius (RI).",
    mistakes: ["RI is left and a ⌀ typed."],
  },
  measure: {
    about: "Whether X of the outline counts as ⌀ (DIM_D) or as radius (DIM_R).",
    mistakes: ["The outline was drawn in radii and DIM_D stands there: the blank is half as thick."],
  },
  blankSource: {
    about: "Whether the outline stands behind a label of this program or in a file.",
    mistakes: ["The file is not beside the program."],
  },
  "blankRotation.label": {
    about: "Label with the outline of the blank.",
    mistakes: ["It is the label of the finished contour: nothing is left to cut."],
  },
  "turnBlank.label": {
    about: "Label with the closed outline of what stands in the chuck.",
    mistakes: ["The outline is that of the finished part."],
  },
  file: {
    about: "File with the outline, with its ending, or a QS parameter that holds its name.",
    mistakes: ["The path of another machine stands before it."],
  },
  "selectContour.file": {
    about: "File with the contour, with its ending.",
    mistakes: ["It holds a whole program with positioning blocks."],
  },
  "toolDefinition.tool": {
    about: "Number or name of the tool that is described.",
    mistakes: ["It stands in the tool table as well: that counts."],
  },
  "toolDefinition.length": {
    about: "Length of the tool beyond the reference point.",
    mistakes: ["The length of another holder is left."],
  },
  toolRadius: { about: "Radius of the tool, for the compensation of milled contours.", mistakes: ["The ⌀ is typed."] },
  "toolCall.speed": {
    about: "Revolutions of a milling or drilling spindle. While turning FUNCTION TURNDATA SPIN decides.",
    mistakes: ["It is meant for the turned part: there it does nothing."],
  },
  "toolCall.feed": {
    about: "Feed for FAUTO blocks and for blocks without a feed of their own.",
    mistakes: ["It is taken for the feed of a cycle, which has its own."],
  },
  deltaLength: {
    about: "Delta of the length, added to that of the table.",
    mistakes: ["It is used for turning tools: CORR-TCS does it there."],
  },
  deltaRadius: {
    about: "Delta of the radius: more leaves an oversize on milled contours.",
    mistakes: ["It is left from roughing."],
  },
  mode: {
    about: "TURN for turning, MILL for milling.",
    mistakes: ["MILL is forgotten behind the turning: X stays a ⌀."],
  },
  kinematics: {
    about: "Name of a kinematics of the machine, where it has several.",
    mistakes: ["The name of another machine stands there."],
  },
  constantSurface: {
    about: "On: the cutting speed is kept and the revolutions follow the ⌀. Off: the revolutions are kept.",
    mistakes: [
      "On for a thread: the pitch is only right at a fixed speed.",
      "On without SMAX: towards the axis it runs away.",
    ],
  },
  "turnCorrection.system": {
    about: "TCS: along the tool. WPL: along the part.",
    mistakes: ["WPL is meant for a wear of the tool."],
  },
  "turnCorrection.plane": {
    about: "The plane that the correction counts in: Z/X for turning.",
    mistakes: ["X/Y is left from milling."],
  },
  DZL: {
    about: "So much longer the tool counts in Z: faces move towards +Z.",
    mistakes: ["It is taken for an oversize of the contour."],
  },
  DXL: {
    about: "So much longer the tool counts in X, on the radius: the ⌀ changes by twice that.",
    mistakes: ["The difference of the ⌀ is typed."],
  },
  X: {
    about:
      "X of the end point: a ⌀ while turning, a coordinate while milling. With I it counts from where the tool stands.",
    mistakes: ["A radius is typed: the part becomes half as thick.", "I stays on: the value is added."],
  },
  Y: {
    about: "Y of the end point. While turning it stays empty.",
    mistakes: ["It is left from milling: while turning it does nothing."],
  },
  Z: {
    about: "Z of the end point. Z0 usually is the finished face; the part lies at minus.",
    mistakes: ["The minus sign is missing."],
  },
  axis: {
    about: "A further axis of the machine: rotary in degrees, parallel in mm. It is not simulated.",
    mistakes: ["It turns while the tool is in the cut."],
  },
  "CC.X": { about: "X of the centre or pole, a ⌀ while turning.", mistakes: ["A radius is typed."] },
  "CC.Y": { about: "Y of the centre or pole.", mistakes: ["It is left empty: the last one counts."] },
  "CC.Z": { about: "Z of the centre or pole.", mistakes: ["The minus sign is missing."] },
  "C.X": {
    about: "X of the end point. It has to lie on the circle round CC.",
    mistakes: ["It is rounded: the control finds no circle."],
  },
  "C.Z": {
    about: "Z of the end point. It has to lie on the circle round CC.",
    mistakes: ["It is rounded: the control finds no circle."],
  },
  "datum.X": { about: "How far the datum moves in X; while turning a ⌀.", mistakes: ["Half of it was meant."] },
  "datum.Y": { about: "How far the datum moves in Y.", mistakes: ["It is left from milling."] },
  "datum.Z": {
    about: "How far the datum moves in Z: minus is towards the chuck.",
    mistakes: ["It counts from the datum before: it does not, values replace it."],
  },
  polarRadius: {
    about: "Distance from the pole CC to the end point, in mm, not a ⌀.",
    mistakes: ["The ⌀ of the circle is typed."],
  },
  polarAngle: {
    about:
      "Direction from the pole, counted from the first axis of the plane: while turning from +Z. With I " +
      "from the last direction.",
    mistakes: ["It is counted from X while turning.", "I is forgotten in a repeat: every hole lies in the same place."],
  },
  radius: {
    about: "Radius of the arc. Plus takes the arc below 180°, minus the larger one.",
    mistakes: ["DR is the other way: the hollow becomes a bulge."],
  },
  "RND.radius": {
    about: "Radius of the rounding in the corner.",
    mistakes: ["It is smaller than the nose of the insert in an inner corner: the nose stays."],
  },
  turn: {
    about: "The sense of the arc, seen on the plane: DR- clockwise, DR+ anticlockwise.",
    mistakes: ["It is read from below the axis: there it is the other way."],
  },
  chamfer: { about: "Length along each of the two edges.", mistakes: ["It is longer than an edge beside it."] },
  compensation: {
    about: "Where the tool runs beside the programmed contour: RL to its left, RR to its right, R0 on it.",
    mistakes: ["It is switched on in the cut and not in the air.", "R0 at the end is left out."],
  },
  feed: {
    about:
      "How fast this block and those behind it go. FMAX counts in its own block only, FAUTO takes that of TOOL CALL.",
    mistakes: ["With M136 a feed a minute is typed.", "FMAX is typed where the tool cuts."],
  },
  functions: {
    about: "Up to several M functions, with blanks between them.",
    mistakes: ["M3 and M4 are mixed up: the insert rubs with its back."],
  },
  retract: {
    about: "How far the tool goes back along its axis; MAX to the end of the travel.",
    mistakes: ["Something stands in the way back."],
  },
  length: { about: "Length of the straight element.", mistakes: ["The coordinate is typed in its place."] },
  centreAngle: { about: "How far round the arc goes.", mistakes: ["The angle of the end point is typed."] },
  free: {
    about: "A value that the drawing gives of this element; each is optional.",
    mistakes: ["Too little is given: there are several solutions."],
  },
  CLSD: { about: "Begins (+) and ends (−) a closed contour.", mistakes: ["The end mark is missing."] },
  "undercut.form": {
    about: "The standard form: E into the cylinder, F into cylinder and face, H, K, U, or that of a thread.",
    mistakes: ["F where the face is already finished."],
  },
  "groove.form": {
    about: "RADIAL into a cylinder, AXIAL into a face.",
    mistakes: ["The form does not suit the element before it."],
  },
  R: { about: "Radius in the corners at the bottom.", mistakes: ["It is smaller than the nose of the insert."] },
  DEPTH: { about: "How deep it goes into the material.", mistakes: ["It is typed as a ⌀."] },
  BREADTH: { about: "How wide it is along its element.", mistakes: ["It is narrower than the insert."] },
  ANGLE: { about: "How steeply the flank rises.", mistakes: ["It is steeper than the edge of the insert can follow."] },
  "groove.DEPTH": {
    about: "Depth of the recess; the sign says on which side of the element it lies: negative towards −X or −Z.",
    mistakes: ["It is typed as a ⌀."],
  },
  "groove.ANGLE": {
    about: "Angle of each flank against the perpendicular to the element, in place of ANG_WIDTH.",
    mistakes: ["The opening angle between both flanks is typed: that is ANG_WIDTH."],
  },
  ANG_WIDTH: {
    about: "Opening angle between both flanks, in place of ANGLE.",
    mistakes: ["The angle of one flank is typed: the recess is then half as open."],
  },
  FACEDEPTH: {
    about: "How deep the undercut goes into the face.",
    mistakes: ["It is left out and the standard value counts."],
  },
  FACEANGLE: { about: "How steeply it comes out of the face.", mistakes: ["It is measured from the axis."] },
  ROT: { about: "By how much the undercut is turned.", mistakes: ["45° are usual; the sign turns it into the wall."] },
  "rotation.ROT": {
    about: "Angle by which the plane is turned, anticlockwise positive.",
    mistakes: ["It is still on for the next feature."],
  },
  PITCH: {
    about: "Pitch of the thread that the undercut belongs to: the table gives its measures.",
    mistakes: ["The ⌀ of the thread is typed."],
  },
  CENTER: {
    about: "Where the middle of the recess lies: Z on a cylinder, ⌀ on a face.",
    mistakes: ["An edge of the recess is typed."],
  },
  DIAM: { about: "⌀ of the bottom of the recess, in place of its depth.", mistakes: ["Depth and ⌀ are both given."] },
  RND: { about: "Radius on the outer edge.", mistakes: ["RND and CHF are both given."] },
  CHF: { about: "Chamfer on the outer edge.", mistakes: ["RND and CHF are both given."] },
  FAR_RND: { about: "Radius on the far outer edge, where it differs.", mistakes: ["Far and near edge are exchanged."] },
  FAR_CHF: {
    about: "Chamfer on the far outer edge, where it differs.",
    mistakes: ["Far and near edge are exchanged."],
  },
  label: { about: "Number or name of the place.", mistakes: ["The same number stands twice."] },
  "call.label": { about: "Which label is called.", mistakes: ["The label is that of a contour: it runs as a path."] },
  repeat: {
    about: "How often the part is run again, beyond the first time.",
    mistakes: ["It is one too many: the first run does not count."],
  },
  "contour.cycleLine": {
    about: "The labels with the contour, divided by /.",
    mistakes: ["The label of the blank stands there."],
  },
  cycleLine: {
    about: "What stands behind the number of the line.",
    mistakes: ["It belongs to another line of the cycle."],
  },
  how: {
    about: "Here; at positions (POS); or at each point of a pattern (PAT).",
    mistakes: ["PAT without a pattern before it."],
  },
  SCL: { about: "Factor: 1 is the same size.", mistakes: ["A percentage is typed."] },
  target: { about: "The parameter that gets the value.", mistakes: ["Q100 to Q199 belong to the control."] },
  formula: {
    about: "A number, a parameter or a calculation with + − * / and functions.",
    mistakes: ["Degrees are usual: SIN 30 is 0.5."],
  },
  text: { about: "What stands in the block, as text.", mistakes: ["Semicolons begin a comment."] },
  parameter: {
    about: "A value of a cycle that is kept here. Its meaning stands in the manual of the control.",
    mistakes: ["It is changed in the belief that the picture follows."],
  },
};
