import type { MistakesTexts } from "../mistakes-text.ts";

export const mistakes: MistakesTexts = {
  kinds: {
    choice: ["A number is taken over from another program without looking up what it means in this cycle."],
    diameter: [
      "A radius is entered where the control wants a diameter: the part becomes half as thick.",
      "The sign is mixed up with the side of the axis: X is positive for an ordinary part.",
    ],
    oversizeDiameter: ["It is taken for a value per side: on each side only half of it is left."],
    radial: ["It is taken for a diameter: the cut becomes twice as deep as meant."],
    axial: ["The minus sign is forgotten: in front of Z0 there is no part."],
    axialDepth: ["A minus sign is entered: depths are positive, the direction follows from the contour."],
    length: ["An absolute coordinate is entered where a length is wanted."],
    angle: [
      "The angle is measured from the wrong axis.",
      "A flank is asked for that is steeper than the edge of the insert can follow: material stays.",
    ],
    feed: [
      "M136 is missing: 0.2 then means 0.2 mm a minute and the tool seems to stand still.",
      "A feed per minute is entered while M136 is active.",
    ],
    count: ["The number is much larger than needed, and the cycle runs for minutes in the air."],
    factor: ["A percentage is entered in place of a share: 80 % is 0.8."],
    percent: ["A share is entered in place of a percentage: 0.8 is less than one percent."],
    revolutions: ["It is taken for seconds: the time depends on the speed."],
  },
  of: {
    operation: [
      "0 is left as it is although finishing has a tool of its own: the roughing insert finishes as well.",
      "2 is chosen without anything having been roughed: the whole depth is taken at once.",
    ],
    clearance: [
      "0 or very little: the tool goes at rapid right up to the material, and a blank that is a little too large is hit.",
      "It is so large that the start point lies inside it: the tool first moves away.",
    ],
    clearanceReserved: [
      "It is changed to keep the tool farther off: here it does nothing. Only the start point helps.",
    ],
    startDiameter: [
      "It is smaller than the end diameter by mistake: the control then takes it for a bore.",
      "It is smaller than the blank: a ring of material stays in front of the contour and the first pass is too deep.",
    ],
    endDiameter: [
      "Start and end are the same: there is nothing to cut.",
      "The finished diameter is entered with its oversize: Q483 is added once more.",
    ],
    startZ: ["Z0 lies on the raw face while the face is turned later: every length is then too short."],
    endZ: [
      "The length of the shoulder is entered without its sign.",
      "Chuck and jaws are forgotten: the end lies behind them.",
    ],
    surfaceAngle: [
      "Half and full angle of a cone are mixed up: the prompt wants the angle to the axis, which is half of the cone angle.",
    ],
    faceAngle: ["The angle is measured from the axis; it counts from the square face."],
    flankAngle: ["The two flanks are exchanged: Q495 belongs to the contour start, Q496 to its end."],
    secondFlankAngle: ["The two flanks are exchanged: Q495 belongs to the contour start, Q496 to its end."],
    startElement: [
      "Type 0 stays while Q502 has a size: no edge is broken.",
      "A chamfer is chosen where the drawing has a radius.",
    ],
    startElementSize: ["It is longer than the wall that it breaks."],
    endElement: ["Type 0 stays while Q504 has a size: no edge is broken."],
    endElementSize: [
      "The chamfer at the end lies on the raw diameter: with a blank that is larger it hangs in the air.",
    ],
    cornerRadius: [
      "It is smaller than the nose radius: the corner becomes as round as the insert and material stays.",
      "It is used for the edges as well: those are Q502 and Q504.",
    ],
    infeedRadial: [
      "It is thought to be the real infeed: the depth is divided evenly and the cut is often smaller.",
      "It is larger than a third of the edge length: the insert is overloaded.",
      "It is doubled because the diameter changes by twice of it.",
    ],
    infeedAxial: [
      "A radial value is taken over from longitudinal turning: here the cut goes along Z.",
      "0 is entered as “no roughing”: it means everything in one pass.",
    ],
    infeedGroove: [
      "It is set as deep as the recess: the blade cannot get rid of the chip.",
      "A diameter is thought of: in a face the infeed runs along Z.",
    ],
    roughingFeed: [
      "It is larger than 0.8 of the nose radius: the edge breaks and the surface becomes a thread.",
      "It is so small that the chip does not break.",
    ],
    finishingFeed: [
      "The roughing feed is taken over: Rz grows with the square of the feed.",
      "A tiny feed is taken for a fine surface: below the minimum chip the edge only rubs.",
    ],
    oversizeZ: [
      "It stays 0 while Q483 is set: the finishing cut then rubs along the face without cutting.",
      "It is larger than the nose radius allows in a corner, and finishing meets a heap of material.",
    ],
    smoothing: [
      "2 is taken to save time although the steps that stay make the finishing cut jump.",
      "It is expected to change the finished contour: only the way between passes changes.",
    ],
    plunging: [
      "1 is left although the insert has no clearance for falling flanks: its secondary edge rubs.",
      "0 is set, and the undercut simply stays full without an alarm.",
    ],
    plungingFeed: [
      "0 is entered as “no feed”: it means that the roughing feed counts.",
      "It is as fast as the roughing feed although the blade is in full width.",
    ],
    limits: ["1 is set and Q480 and Q482 keep the values of another part."],
    limitDiameter: ["It lies on the wrong side of the contour: nothing is left to cut."],
    limitZ: ["The sign is forgotten and the whole contour lies beyond the limit."],
    reverseContour: [
      "2 is chosen without a tool that cuts in the other direction.",
      "The contour is programmed backwards and turned round here too: both cancel each other.",
    ],
    direction: ["Both directions (0) with a blade that may only cut one way."],
    offsetWidth: [
      "It is larger than 80 % of the effective width of the blade: webs would stay, and the control stops.",
      "It stays 0, and the corner of the blade rubs along the wall at every pass.",
    ],
    depthCompensation: [
      "A positive value is entered in the hope of a deeper groove: positive stays above the floor.",
      "It is used to correct a wrong tool length: put that into the tool table.",
    ],
    blankAllowance: [
      "The oversize for finishing is entered: what is meant is how much thicker the blank is than the contour.",
    ],
    threadPitch: ["The lead of a thread with several starts is entered in place of the pitch."],
    threadDepth: ["0 is taken for “no thread”: the control then works out the depth from the pitch."],
    firstInfeed: ["It is taken for the infeed of every pass: later ones become smaller."],
    infeedAngle: ["Half the thread angle is exceeded: the insert cuts into the finished flank."],
    threadStarts: ["The number of passes is entered: it is the number of grooves side by side."],
    airCuts: ["The number of passes is entered: these are extra cuts at the finished depth."],
    threadRunIn: ["It is too short for the speed: the axis has not reached the pitch where the thread begins."],
    recessingOverlap: ["The width of a plunge in mm is entered in place of the share of the blade width."],
    plungeLimit: ["0 is taken for “no plunge”: it means one plunge to the full depth."],
    dwellTurns: ["Long dwelling on the floor: the blade rubs and hardens the surface."],
  },
};
