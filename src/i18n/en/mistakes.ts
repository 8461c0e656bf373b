import type { MistakesTexts } from "../mistakes-text.ts";

export const mistakes: MistakesTexts = {
  kinds: {
    choice: ["A number is copied from another program without checking its meaning in this cycle."],
    diameter: [
      "A radius is entered instead of a diameter: the part becomes half as thick.",
      "The sign is confused with the side of the axis: X is normally positive.",
    ],
    oversizeDiameter: ["Taken for a value per side: only half of it is left on each side."],
    radial: ["Taken for a diameter: the cut becomes twice as deep as intended."],
    axial: ["The minus sign is missing: there is no part in front of Z0."],
    axialDepth: ["A negative value is entered: depths are positive, the direction follows from the contour."],
    length: ["An absolute coordinate is entered instead of a length."],
    angle: [
      "The angle is measured from the wrong axis.",
      "The flank is steeper than the insert edge can follow: residual material remains.",
    ],
    feed: [
      "M136 is missing: 0.2 then means 0.2 mm per minute and the tool seems to stand still.",
      "A feed per minute is entered while M136 is active.",
    ],
    count: ["The number is far too large, and the cycle cuts air for minutes."],
    factor: ["A percentage is entered instead of a factor: 80 % is 0.8."],
    percent: ["A factor is entered instead of a percentage: 0.8 is less than one percent."],
    revolutions: ["Taken for seconds: the time depends on the spindle speed."],
  },
  of: {
    operation: [
      "0 is kept although there is a separate finishing tool: the roughing insert also finishes.",
      "2 is selected without roughing before: the whole depth is cut at once.",
    ],
    clearance: [
      "0 or very small: the tool moves at rapid traverse up to the material and hits a slightly larger blank.",
      "So large that the start point is inside the clearance: the tool first moves away.",
    ],
    clearanceReserved: ["Increased for more distance: no effect here. Move the start point instead."],
    startDiameter: [
      "Less than the end diameter by mistake: the control then machines a bore.",
      "Less than the blank diameter: a ring of material remains in front of the contour and the first pass is " +
        "too deep.",
    ],
    endDiameter: [
      "Start and end are the same: there is nothing to cut.",
      "The finished diameter is entered including the oversize: Q483 is added again.",
    ],
    startZ: ["Z0 is on the unmachined face, which is turned later: all lengths are then too short."],
    endZ: [
      "The length of the shoulder is entered without the sign.",
      "Chuck and jaws are ignored: the end is behind them.",
    ],
    surfaceAngle: [
      "Half and full taper angle are confused: enter the angle to the axis, which is half the taper angle.",
    ],
    faceAngle: ["The angle is measured from the axis; it is measured from the perpendicular face."],
    flankAngle: ["The two flanks are swapped: Q495 is at the contour start, Q496 at the contour end."],
    secondFlankAngle: ["The two flanks are swapped: Q495 is at the contour start, Q496 at the contour end."],
    startElement: [
      "Type 0 is kept while Q502 has a size: no chamfer or radius is machined.",
      "A chamfer is selected where the drawing has a radius.",
    ],
    startElementSize: ["The element is longer than the adjacent wall."],
    endElement: ["Type 0 is kept while Q504 has a size: no chamfer or radius is machined."],
    endElementSize: ["The end chamfer is on the blank diameter: with a larger blank it has no edge."],
    cornerRadius: [
      "Less than the tool nose radius: the corner keeps the tool nose radius and residual material remains.",
      "Used for the outer edges too: use Q502 and Q504.",
    ],
    infeedRadial: [
      "Taken for the actual infeed: the depth is divided evenly and the infeed is often smaller.",
      "More than a third of the edge length: the insert is overloaded.",
      "Doubled because the diameter changes by twice the value.",
    ],
    infeedAxial: [
      "A radial value is copied from longitudinal turning: here the infeed is along Z.",
      "0 is entered for “no roughing”: it means one single pass.",
    ],
    infeedGroove: [
      "As large as the depth of the recess: the chip cannot escape.",
      "Taken for a diameter: in a face the infeed is along Z.",
    ],
    roughingFeed: [
      "More than 0.8 × tool nose radius: the edge breaks and the surface looks like a thread.",
      "So small that the chip does not break.",
    ],
    finishingFeed: [
      "The roughing feed is kept: Rz grows with the square of the feed.",
      "A very small feed for a fine surface: below the minimum chip thickness the edge only rubs.",
    ],
    oversizeZ: [
      "Kept at 0 while Q483 is set: the finishing cut rubs along the face without cutting.",
      "Larger than the tool nose radius allows in a corner: finishing meets too much material.",
    ],
    smoothing: [
      "2 is selected to save time, but the remaining steps make the finishing depth vary.",
      "Expected to change the finished contour: only the path between passes changes.",
    ],
    plunging: [
      "1 is kept although the insert has no clearance for descending flanks: the secondary edge rubs.",
      "0 is set: the undercut is not machined, without a message.",
    ],
    plungingFeed: [
      "0 is entered for “no feed”: it means the roughing feed.",
      "As high as the roughing feed although the blade cuts at full width.",
    ],
    limits: ["1 is set and Q480 and Q482 keep the values of another part."],
    limitDiameter: ["On the wrong side of the contour: nothing is left to cut."],
    limitZ: ["The sign is missing and the whole contour is beyond the limit."],
    reverseContour: [
      "2 is selected without a tool that cuts in the other direction.",
      "The contour is programmed in reverse and reversed again here: the two cancel out.",
    ],
    direction: ["Both directions (0) with a blade that may cut in one direction only."],
    offsetWidth: [
      "More than 80 % of the effective blade width: webs would remain, and the control stops.",
      "Kept at 0: the blade corner rubs along the wall in every pass.",
    ],
    depthCompensation: [
      "A positive value for a deeper recess: positive stays above the floor.",
      "Used to correct a wrong tool length: correct the tool table instead.",
    ],
    blankAllowance: ["The finishing oversize is entered: required is the allowance of the blank on the contour."],
    threadPitch: ["With several starts the distance from thread to thread is entered instead of the lead."],
    threadDepth: ["0 is entered for “no thread”: the control then calculates the depth from the pitch."],
    firstInfeed: ["Taken for the infeed of every pass: later infeeds are smaller."],
    infeedAngle: ["More than half the thread angle: the insert damages the finished flank."],
    threadStarts: ["The number of passes is entered: required is the number of thread starts."],
    airCuts: ["The number of passes is entered: air cuts are extra passes at the final depth."],
    threadRunIn: ["Too short for the spindle speed: the axis has not reached the feed where the thread begins."],
    recessingOverlap: ["The width of a plunge in mm is entered instead of the factor of the blade width."],
    plungeLimit: ["0 is entered for “no plunge”: it means one plunge to full depth."],
    dwellTurns: ["Dwell too long: the blade rubs and hardens the surface."],
  },
};
