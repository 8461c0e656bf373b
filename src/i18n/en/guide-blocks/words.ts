/** Function of each word of a block, by its field, and common mistakes. */
export const blockWords = {
  name: {
    about: "Name of the program.",
    mistakes: ["Contains spaces or umlauts: some controls reject the file."],
  },
  unit: {
    about: "MM or INCH for all lengths and feeds of the program.",
    mistakes: ["Values are copied between programs of different units."],
  },
  toolAxis: {
    about: "Tool axis. Z for turning.",
    mistakes: ["X or Y is kept from a milling program."],
  },
  "blankBox.X": {
    about: "X of this corner. In turning, the farthest corner decides.",
    mistakes: ["A ⌀ is entered; boxes are measured from the axis."],
  },
  "blankBox.Y": {
    about: "Y of this corner. In turning, the farthest corner decides.",
    mistakes: ["The box is off the axis."],
  },
  "blankBox.Z": {
    about: "Z of this corner: 0.1 the back end, 0.2 the face.",
    mistakes: ["The face ends at Z0 although it is unmachined."],
  },
  outsideMeasure: {
    about: "Outside as ⌀ (D) or as radius (R).",
    mistakes: ["R with a ⌀ entered: the blank is twice as thick."],
  },
  insideMeasure: {
    about: "Bore as ⌀ (DI) or as radius (RI).",
    mistakes: ["RI with a ⌀ entered."],
  },
  measure: {
    about: "X of the outline as ⌀ (DIM_D) or as radius (DIM_R).",
    mistakes: ["DIM_D with an outline in radius values: the blank is half as thick."],
  },
  blankSource: {
    about: "Outline in a label of this program or in a file.",
    mistakes: ["The file is not in the folder of the program."],
  },
  "blankRotation.label": {
    about: "Label with the outline of the blank.",
    mistakes: ["The label of the finished contour is entered: nothing is left to cut."],
  },
  "turnBlank.label": {
    about: "Label with the closed outline of the clamped material.",
    mistakes: ["The outline of the finished part is used."],
  },
  file: {
    about: "File with the outline, with extension, or a QS parameter with the name.",
    mistakes: ["The path of another machine is included."],
  },
  "selectContour.file": {
    about: "File with the contour, with extension.",
    mistakes: ["The file is a complete program with positioning blocks."],
  },
  "toolDefinition.tool": {
    about: "Number or name of the defined tool.",
    mistakes: ["The tool is also in the tool table: the table applies."],
  },
  "toolDefinition.length": {
    about: "Tool length from the reference point.",
    mistakes: ["The length of another holder is kept."],
  },
  toolRadius: { about: "Tool radius, for the compensation of milled contours.", mistakes: ["A ⌀ is entered."] },
  "toolCall.speed": {
    about: "Speed of the milling or drilling spindle. In turning, FUNCTION TURNDATA SPIN applies.",
    mistakes: ["Used for turning: no effect there."],
  },
  "toolCall.feed": {
    about: "Feed for FAUTO and for blocks without a feed.",
    mistakes: ["Confused with the feed of a cycle, which has a separate feed."],
  },
  deltaLength: {
    about: "Delta of the length, added to that of the table.",
    mistakes: ["Used for turning tools: use CORR-TCS instead."],
  },
  deltaRadius: {
    about: "Delta of the radius: a positive value leaves oversize on milled contours.",
    mistakes: ["Kept from roughing."],
  },
  mode: {
    about: "TURN for turning, MILL for milling.",
    mistakes: ["MILL is missing after turning: X stays a ⌀."],
  },
  kinematics: {
    about: "Name of the machine kinematics, if there are several.",
    mistakes: ["The name of another machine is entered."],
  },
  constantSurface: {
    about: "On: constant cutting speed, the spindle speed follows the ⌀. Off: constant spindle speed.",
    mistakes: [
      "On for a thread: the pitch is correct only at constant spindle speed.",
      "On without SMAX: towards the axis the speed is unlimited.",
    ],
  },
  "turnCorrection.system": {
    about: "TCS: along the tool. WPL: along the part.",
    mistakes: ["WPL is used for tool wear."],
  },
  "turnCorrection.plane": {
    about: "Plane of the compensation: Z/X for turning.",
    mistakes: ["X/Y is kept from milling."],
  },
  DZL: {
    about: "Tool length delta in Z: a positive value moves faces towards +Z.",
    mistakes: ["Confused with an oversize of the contour."],
  },
  DXL: {
    about: "Tool length delta in X, on the radius: the ⌀ changes by twice the value.",
    mistakes: ["The difference of the ⌀ is entered."],
  },
  X: {
    about:
      "X of the end point: a ⌀ in turning, a coordinate in milling. With I: incremental from the current position.",
    mistakes: ["A radius is entered: the part becomes half as thick.", "I is kept: the value is added."],
  },
  Y: {
    about: "Y of the end point. Empty in turning.",
    mistakes: ["Kept from milling: no effect in turning."],
  },
  Z: {
    about: "Z of the end point. Z0 is usually the finished face; the part is on the negative side.",
    mistakes: ["The minus sign is missing."],
  },
  axis: {
    about: "Additional machine axis: rotary axes in degrees, parallel axes in mm. Not simulated.",
    mistakes: ["The axis moves while the tool is cutting."],
  },
  "CC.X": { about: "X of the centre or pole, a ⌀ in turning.", mistakes: ["A radius is entered."] },
  "CC.Y": { about: "Y of the centre or pole.", mistakes: ["Left empty: the last value applies."] },
  "CC.Z": { about: "Z of the centre or pole.", mistakes: ["The minus sign is missing."] },
  "C.X": {
    about: "X of the end point. That point must be on the circle about CC.",
    mistakes: ["The value is rounded: the point is not on the circle."],
  },
  "C.Z": {
    about: "Z of the end point. That point must be on the circle about CC.",
    mistakes: ["The value is rounded: the point is not on the circle."],
  },
  "datum.X": { about: "Datum shift in X; a ⌀ in turning.", mistakes: ["A radius is entered."] },
  "datum.Y": { about: "Datum shift in Y.", mistakes: ["Kept from milling."] },
  "datum.Z": {
    about: "Datum shift in Z: negative is towards the chuck.",
    mistakes: ["Taken as relative to the previous shift: a new value replaces it."],
  },
  polarRadius: {
    about: "Distance from the pole CC to the end point, in mm, not a ⌀.",
    mistakes: ["The ⌀ of the circle is entered."],
  },
  polarAngle: {
    about:
      "Direction from the pole, measured from the first axis of the plane: in turning from +Z. With I: from the " +
      "last direction.",
    mistakes: ["Measured from X in turning.", "I is missing in a repeat: all holes are at the same position."],
  },
  radius: {
    about: "Radius of the arc. Positive: arc below 180°; negative: the larger arc.",
    mistakes: ["Wrong DR: a concave arc becomes convex."],
  },
  "RND.radius": {
    about: "Radius of the rounding in the corner.",
    mistakes: ["Less than the tool nose radius in an inside corner: the tool nose radius remains."],
  },
  turn: {
    about: "Direction of rotation, seen on the plane: DR- clockwise, DR+ counterclockwise.",
    mistakes: ["Viewed from below the axis: the direction is reversed."],
  },
  chamfer: { about: "Length along each of the two edges.", mistakes: ["Longer than an adjacent edge."] },
  compensation: {
    about: "Tool position relative to the programmed contour: RL left, RR right, R0 on the contour.",
    mistakes: ["Activated in the cut instead of clear of the material.", "R0 at the end is missing."],
  },
  feed: {
    about: "Feed of this and the following blocks. FMAX applies in its block only, FAUTO uses the feed of TOOL CALL.",
    mistakes: ["With M136 a feed per minute is entered.", "FMAX is used in the cut."],
  },
  functions: {
    about: "Several M functions, separated by spaces.",
    mistakes: ["M3 and M4 are swapped: the back of the insert rubs."],
  },
  retract: {
    about: "Retraction distance along the tool axis; MAX: to the traverse limit.",
    mistakes: ["An obstacle is in the retraction path."],
  },
  length: { about: "Length of the straight element.", mistakes: ["A coordinate is entered instead."] },
  centreAngle: { about: "Centre angle of the arc.", mistakes: ["The angle of the end point is entered."] },
  free: {
    about: "A value of this element from the drawing; optional.",
    mistakes: ["Too few values: several solutions."],
  },
  CLSD: { about: "Begins (+) and ends (−) a closed contour.", mistakes: ["The end mark is missing."] },
  "undercut.form": {
    about: "The standard form: E into the cylinder, F into cylinder and face, H, K, U, or that of a thread.",
    mistakes: ["F although the face is already finished."],
  },
  "groove.form": {
    about: "RADIAL into a cylinder, AXIAL into a face.",
    mistakes: ["The form does not match the previous element."],
  },
  R: { about: "Radius in the corners at the bottom.", mistakes: ["Less than the tool nose radius."] },
  DEPTH: { about: "Depth in the material.", mistakes: ["Entered as a ⌀."] },
  BREADTH: { about: "Width along the element.", mistakes: ["Narrower than the insert."] },
  ANGLE: { about: "Angle of the flank.", mistakes: ["Steeper than the insert edge can follow."] },
  "groove.DEPTH": {
    about: "Depth of the recess; the sign defines the side of the element: negative towards −X or −Z.",
    mistakes: ["Entered as a ⌀."],
  },
  "groove.ANGLE": {
    about: "Angle of each flank to the perpendicular of the element, instead of ANG_WIDTH.",
    mistakes: ["The opening angle between both flanks is entered: use ANG_WIDTH."],
  },
  ANG_WIDTH: {
    about: "Opening angle between both flanks, instead of ANGLE.",
    mistakes: ["The angle of one flank is entered: the recess is half as open."],
  },
  FACEDEPTH: {
    about: "Depth of the undercut in the face.",
    mistakes: ["Omitted: the standard value applies."],
  },
  FACEANGLE: { about: "Exit angle from the face.", mistakes: ["Measured from the axis."] },
  ROT: { about: "Rotation of the undercut.", mistakes: ["45° is usual; a wrong sign rotates it into the wall."] },
  "rotation.ROT": {
    about: "Rotation angle of the plane, counterclockwise positive.",
    mistakes: ["Still active for the next feature."],
  },
  PITCH: {
    about: "Pitch of the thread: the dimensions come from the table.",
    mistakes: ["The ⌀ of the thread is entered."],
  },
  CENTER: {
    about: "Centre of the recess: Z on a cylinder, ⌀ on a face.",
    mistakes: ["An edge of the recess is entered."],
  },
  DIAM: { about: "⌀ of the recess floor, instead of the depth.", mistakes: ["Depth and ⌀ are both entered."] },
  RND: { about: "Radius on the outer edge.", mistakes: ["RND and CHF are both entered."] },
  CHF: { about: "Chamfer on the outer edge.", mistakes: ["RND and CHF are both entered."] },
  FAR_RND: { about: "Radius on the far outer edge, if different.", mistakes: ["Far and near edge are swapped."] },
  FAR_CHF: {
    about: "Chamfer on the far outer edge, if different.",
    mistakes: ["Far and near edge are swapped."],
  },
  label: { about: "Number or name of the label.", mistakes: ["The same number is used twice."] },
  "call.label": { about: "Label to call.", mistakes: ["The label of a contour is called: it runs as a path."] },
  repeat: {
    about: "Number of repeats after the first run.",
    mistakes: ["One too many: the first run is not counted."],
  },
  "contour.cycleLine": {
    about: "Labels with the contour, separated by /.",
    mistakes: ["The label of the blank is entered."],
  },
  cycleLine: {
    about: "Content after the line number.",
    mistakes: ["The value belongs to another line of the cycle."],
  },
  how: {
    about: "At the current position, at positions (POS) or at each point of a pattern (PAT).",
    mistakes: ["PAT without a pattern before it."],
  },
  SCL: { about: "Scaling factor: 1 is the original size.", mistakes: ["A percentage is entered."] },
  target: { about: "Parameter for the result.", mistakes: ["Q100 to Q199 are reserved for the control."] },
  formula: {
    about: "A number, a parameter or a calculation with + − * / and functions.",
    mistakes: ["Angles are in degrees: SIN 30 is 0.5."],
  },
  text: { about: "Content of the block as text.", mistakes: ["A semicolon begins a comment."] },
  parameter: {
    about: "A value of a cycle that is kept but not simulated. See the manual of the control.",
    mistakes: ["Changed in the belief that the simulation follows."],
  },
};
