import type { MessagesTexts } from "../../message-texts.ts";
import { running } from "./messages/running.ts";
import { threads } from "./messages/threads.ts";

/** The value that a finding proposes, if any. */
const nearest = (value: number | undefined, say: (value: number) => string) =>
  value === undefined ? "" : ` Proposed: ${say(value)}.`;
/** "4 blocks", "1 block". */
const count = (n: number, one: string, many: string) => `${n} ${n === 1 ? one : many}`;

const reasons: MessagesTexts["reasons"] = {
  insertRadius: "tool nose radius",
  mainEdge: "main cutting edge",
  secondaryEdge: "secondary cutting edge",
  toolWidth: "tool width",
  cutLength: "CUTLENGTH",
  limit: "machining limit",
  plunging: "plunging not allowed",
  oversize: "oversize",
  smoothing: "steps between passes",
  correction: "tool compensation",
  overCrest: "material above the thread crest",
  behindContour:
    "recess behind the contour, which this cycle does not reach; for form F insert “Undercut by name” as an operation",
};

const ELEMENT = { angle: "angle", length: "length", radius: "radius" };

/** Clamping devices. */
const CLAMPED = {
  jaws: "the jaws",
  chuck: "the chuck",
  collet: "the collet",
  driver: "the driver",
  tailstock: "the tailstock",
  limit: "the clamping limit",
};

/** Units of a feed. */
const FEED = { "mm/min": "mm/min", "mm/rev": "mm/rev" };

export const messages = {
  reasons,
  morePlaces: (place, more) => `${place} and ${more} more ${more === 1 ? "place" : "places"}`,
  of: {
    ...running,
    ...threads,
    missing: () => "Enter a value.",
    notANumber: (d, w) => `“${w.text(d.text)}” is not a number.`,
    badExpression: (d, w) => `“${w.text(d.text)}” cannot be calculated.`,
    unknownParameter: (d) => `${d.name} has no value here. Enter a number.`,
    outOfRange: (d, w) =>
      `${w.value(d.value)} is out of range: ${w.value(d.min)} to ${w.value(d.max)}.${nearest(d.nearest, w.value)}`,
    notWhole: (d, w) => `${w.number(d.value)} is not a whole number.${nearest(d.nearest, w.number)}`,
    notAChoice: (d, w) => `${w.number(d.value)} is not one of ${d.choices.join(", ")}.${nearest(d.nearest, w.number)}`,
    startEqualsEnd: (d, w) => `Start and end are equal: ${d.other} is ${w.value(d.value)} too.`,
    startLevelWithEnd: (d, w) =>
      `The start point is at ${d.axis} ${w.size(d.value)}, the same as the contour end: there is nothing to cut in between.`,
    diameterNegative: (d, w) => `${w.value(d.value)} is a diameter beyond the axis.${nearest(d.nearest, w.value)}`,
    elementTooLong: (d, w) => `${w.size(d.size)} is too long for the element: max. ${w.size(d.max)}.`,
    cornersTooWide: (d, w) =>
      `Two corner radii of ${w.size(d.radius)} are wider than the floor: max. ${w.size(d.max)}.`,
    wallsMeet: (d, w) => `With ${w.angle(d.angle)} the walls meet above the floor: enter less than ${w.angle(d.max)}.`,
    cornerSmallerThanInsert: (d, w) =>
      `Corner radius ${w.size(d.radius)} is smaller than the tool nose radius ${w.size(d.insert)}: the corner keeps ${w.size(d.insert)}.`,
    recessNarrowerThanTool: (d, w) =>
      `The recess floor is ${w.size(d.width)} wide, but tool and oversize need ${w.size(d.tool)}.${nearest(d.nearest, w.value)}`,
    angleNotFollowed: (d, w) =>
      `${d.element === undefined ? "The" : `Element ${d.element}: the`} tool cannot follow ${w.angle(d.angle)}: ` +
      (d.edge === "behindContour"
        ? "the angle leads behind the contour, where this cycle does not go with any tool"
        : `the ${reasons[d.edge]} allows ${w.angle(d.max)}`) +
      "; residual material remains.",
    tooManyPasses: (d, w) => `${d.passes} passes exceed the maximum of ${d.most}.${nearest(d.nearest, w.size)}`,
    infeedOverCutLength: (d, w) =>
      `Infeed ${w.size(d.infeed)} exceeds CUTLENGTH ${w.size(d.cutLength)}: reduced to ${w.size(d.cutLength)}.`,
    depthOverCutLength: (d, w) =>
      `Depth ${w.size(d.depth)} exceeds CUTLENGTH ${w.size(d.cutLength)}: residual material remains.`,
    offsetReduced: (d, w) =>
      `Offset ${w.size(d.offset)} is reduced to ${w.size(d.kept)}: ` +
      `${count(d.passes, "pass shares", "passes share")} 80 % of the effective width.`,
    offsetOverLimit: (d, w) =>
      `The lateral offset of ${count(d.passes, "pass", "passes")} adds up to ${w.size(d.offset)}; 80 % of the ` +
      `effective width is ${w.size(d.max)}.${nearest(d.nearest, w.size)}`,
    toolUnfit: (d) =>
      `A ${d.type} tool with tip orientation ${d.orientation} is not suitable here. Use ${d.types.join(" or ")} with ` +
      `orientation ${d.orientations.join(", ")}.`,
    toolCannotCutSideways: (d) =>
      `A ${d.type} tool can only plunge, but this cycle also cuts laterally. Use a RECTURN tool.`,
    flanksNotChecked: () => "T-ANGLE or P-ANGLE is empty: the insert flanks are not checked.",
    toolColumn: (d, w) => {
      const what =
        d.value === null
          ? d.column === "TYPE"
            ? "TYPE is missing or not a type of tool."
            : `${d.column} is missing or not a number.`
          : `${d.column} ${w.value(d.value)} is not possible.`;
      if (d.min !== undefined && d.max !== undefined) return `${what} Allowed: ${w.value(d.min)} to ${w.value(d.max)}.`;
      if (d.min !== undefined)
        return `${what} The value must be ${d.column === "CUTWIDTH" ? "more than" : "at least"} ${w.value(d.min)}.`;
      return d.max === undefined ? what : `${what} The value must be less than ${w.value(d.max)}.`;
    },
    toolNumberTwice: (d) => `Tool ${d.number} is already in the table.${nearest(d.nearest, String)}`,
    toolName: (d, w) =>
      `“${w.text(d.text)}”: a name has at most ${d.max} characters: capital letters, digits and # $ % & , - . _ only.`,
    holderAxis: (d, w) => `“${w.text(d.text)}”: the shank must be along X or along Z.`,
    holderHead: (d, w) =>
      `“${w.text(d.text)}” is not an outline. Enter each corner as Z/X from the tip, with spaces between corners and semicolons between parts; a part needs three corners.`,
    bladeSupport: (d, w) => `“${w.text(d.text)}” is no support of a blade: NONE, STRAIGHT or CURVED.`,
    straightBlade: () =>
      "A straight blade rubs in an axial groove: it needs a curved one, made for its ⌀ (DAXN, DAXX).",
    pointDiffers: (d, w) =>
      `Point length ${w.size(d.length)} does not fit ${w.angle(d.angle)}, which makes ${w.size(d.byAngle)}: the angle is used.`,
    betterTool: (d) => `Tool ${d.tool} ${d.name} is suitable for this contour.`,
    startInArea: (d, w) =>
      `The start point ${w.place(d.x, d.z)} is in the area to be machined: the tool first moves to the set-up clearance.`,
    startInMaterial: (d, w) => `The start point ${w.place(d.x, d.z)} is in the material.`,
    startBelowContour: (d, w) =>
      `The start point is ${w.length(d.below)} below the contour start: the tool first moves to the contour start.`,
    startBehindContour: (d, w) =>
      `The start point is ${w.length(d.behind)} behind the contour start: the tool first moves in Z to the set-up clearance of ${w.size(
        d.clearance,
      )} in front of it.`,
    startInPart: (d, w) =>
      `The start point is inside the finished part: nothing is cut from there. Valid start point: ${w.place(d.x, d.z)}.`,
    insertAcrossAxis: (d, w) =>
      `The insert reaches ${w.length(d.reach)} beyond the axis and damages the contour there.` +
      (d.nearest === undefined
        ? " The insert is too long for this bore."
        : ` Start at X${w.diameter(d.nearest)} or more for clearance.`),
    boreMissing: (d, w) =>
      `No bore: the material is solid from Z${w.signed(d.z)}, but the cycle machines to Z${w.signed(d.to)}. First bore ${w.diameter(
        d.need,
      )} or more down to that depth.`,
    startOnWrongSide: (d, w) =>
      `The contour runs towards the start point: nothing is cut from there. Valid start point: ${w.place(d.x, d.z)}.`,
    startInsideEnvelope: (d, w) =>
      `The start point is nearer to the contour than the clearance of ${w.size(d.clearance)}: the tool moves straight to the contour at the finishing feed.`,
    limitOnWrongSide: (d, w) =>
      `With the limit ${w.value(d.limit)} nothing is cut on the side of the tool.${nearest(d.nearest, w.value)}`,
    cutBehindLimit: (d, w) =>
      `${w.area(d.area)} of material is cut beyond the limit at ${w.place(
        d.x,
        d.z,
      )}: the limit applies to the contour, not to approach and departure.` +
      (d.finishing
        ? " Roughing only (Q215 = 1) does not cut there."
        : " Move the limit so that approach and departure are clear of material."),
    nothingToCut: () => "There is nothing to cut between start point and contour.",
    contourMissing: (d, w) =>
      d.label === "" ? "The contour is missing." : `The contour LBL ${w.text(d.label)} does not exist.`,
    contourTooShort: () => "A contour needs at least two different points.",
    contourFlat: (d) => `Start and end of the contour have the same ${d.axis}: there is nothing to cut in between.`,
    contourEndCovered: (d, w) =>
      `The contour ends at ${w.place(d.x, d.z)} inside itself: an element extends beyond this end, so the part cannot continue.`,
    contourPoint: (d) => `Element ${d.element}: the end point is missing or unreachable.`,
    cornerElementAlone: (d) =>
      `Element ${d.element}: a chamfer or rounding needs an element before and after it; a chamfer needs two lines.`,
    cornerElementTooLong: (d, w) =>
      `Element ${d.element}: ${w.size(d.size)} does not fit between the adjacent elements: max. ${w.size(d.max)}.`,
    arcOffCircle: (d, w) => `Element ${d.element}: the end point is off the circle by ${w.size(d.gap)}.`,
    arcTooSmall: (d, w) => `Element ${d.element}: radius ${w.size(d.radius)} is too small for the end point.`,
    elementFree: (d) =>
      d.freedom === 1
        ? `Element ${d.element}: one more value is needed.`
        : `Element ${d.element}: ${d.freedom} more values are needed.`,
    elementContradicts: (d, w) =>
      d.quantity === "tangent"
        ? `Element ${d.element} is not tangential to the previous element; deviation ${w.number(d.nearest)}°.`
        : `Element ${d.element}: the ${ELEMENT[d.quantity]} ${(d.quantity === "angle" ? w.number : w.size)(
            d.given,
          )} contradicts the other values; ${(d.quantity === "angle" ? w.number : w.size)(d.nearest)} fits.`,
    elementUnreachable: (d) =>
      `Element ${d.element}: with this length, radius or angle the adjacent element cannot be reached.`,
    centreMissing: (d) => `Element ${d.element}: the circle centre is missing; program CC before the element.`,
    contourCrossesItself: (d) => `Element ${d.element} crosses element ${d.other}.`,
    toolRadiusTooLarge: (d, w) =>
      `Element ${d.element}: a tool radius of ${w.size(d.radius)} does not fit.${nearest(d.nearest, w.size)}`,
    pathCutsContour: (d, w) =>
      `Along element ${d.element} the tool cuts ${w.length(d.depth)} into element ${d.other} at ${w.spot(
        d.x,
        d.y,
        undefined,
      )}: the tool is too large; the control checks adjacent elements only.${nearest(d.nearest, w.size)}`,
    approachNeedsSide: () => "CT requires RL or RR: with R0 the control stops here.",
    approachSideAssumed: () => "R0 defines no side: approach from the left of the contour is assumed. Unverified.",
    approachInsideCircle: (d, w) =>
      `${d.point} is inside the circle of R ${w.size(d.radius)}: no tangent is possible from there.${nearest(d.nearest, w.size)}`,
    approachCutsContour: (d, w) =>
      `Between ${d.point} and the contour the tool cuts ${w.length(d.depth)} into it at ${w.spot(d.x, d.y, d.z)}` +
      `; the control does not check this. Free ${d.point}: ${w.spot(d.freeX, d.freeY, d.freeZ)}.`,
    approachValueCutsContour: (d, w) =>
      `Between ${d.point} and the contour the tool cuts ${w.length(d.depth)} into it at ${w.spot(d.x, d.y, d.z)}` +
      `; the control does not check this. Free with ${d.word} ${w.size(d.nearest)}.`,
    approachBlocked: (d, w) =>
      `Between ${d.point} and the contour the tool cuts ${w.length(d.depth)} into it at ${w.spot(d.x, d.y, d.z)}` +
      "; the control does not check this.",
    undercutNeighbours: (d) =>
      `Element ${d.element}: an undercut needs a cylinder parallel to the axis and a face perpendicular to it; a recess needs a straight element in its direction.`,
    recessWord: (d) => `Element ${d.element}: ${d.word} is missing or gives no valid shape.`,
    recessWordsExclusive: (d) => `Element ${d.element}: ${d.other} and ${d.word} exclude each other. Enter only one.`,
    pitchNotListed: (d, w) => {
      const near = [d.below, d.above].flatMap((n) => (n === undefined ? [] : [w.size(n, 4)])).join(" and ");
      return `Element ${d.element}: DIN 76 has no undercut for pitch ${w.size(
        d.pitch,
        4,
      )}; nearest pitches: ${near}. Use one of these or enter ${d.words}.`;
    },
    undercutDefaults: (d) =>
      `Element ${d.element}: ${d.words} taken from the standard, unverified for this control; enter the values to be sure.`,
    materialLeft: (d, w) =>
      d.asked === undefined
        ? `${w.area(d.area)} residual material at ${w.place(d.x, d.z)}: ${reasons[d.reason]}.`
        : d.reason === "oversize"
          ? `${w.area(d.area)} oversize at ${w.place(d.x, d.z)}, as programmed.`
          : `The corner at ${w.place(d.x, d.z)} has the tool nose radius: ${w.area(d.area)} residual material. No other radius is programmed.`,
    gouge: (d, w) => `Contour damage at ${w.place(d.x, d.z)}: ${w.area(d.area)}.`,
    rapidInStock: (d, w) => `Rapid traverse through ${w.area(d.area)} of material at ${w.place(d.x, d.z)}.`,
    holderContact: (d, w) => `The holder touches material at ${w.place(d.x, d.z)}.`,
    cutBelowContour: (d, w) =>
      `This cut is below the contour of the cycle in block ${d.block} by ${w.area(d.area)}, at ${w.place(
        d.x,
        d.z,
      )}. Confirm it if intended.`,
    intendedCut: (d, w) =>
      `Marked as intended: ${d.blocks.length === 1 ? "cut" : "cuts"} below the contour in ${
        d.blocks.length === 1 ? "block" : "blocks"
      } ${d.blocks.join(", ")}, ${w.area(d.area)} at ${w.place(d.x, d.z)}.`,
    cameLoose: (d, w) =>
      `${{ piece: "A piece", ring: "A ring", slug: "A slug" }[d.shape]} of ${w.area(d.area)} at ${w.place(
        d.x,
        d.z,
      )} is no longer connected to the clamped end: block ${d.block} separates it.`,
    partedOff: (d, w) =>
      `The piece at ${w.place(d.x, d.z)}, ${w.area(d.area)}, is parted off in block ${d.block} and removed from the simulation.`,
    cutOnLoosePiece: (d, w) =>
      `Block ${d.block} separates this piece from the clamped end before it is finished: at ${w.place(d.x, d.z)}, ${w.area(d.area)} would be cut from a loose piece. Separate it last.`,
    behindBlank: (d, w) =>
      d.motion === "unheld"
        ? `The outside is turned up to the rear end of the blank at Z${w.size(d.rear)}: no surface remains for clamping. Define the clamping if the blank is held elsewhere.`
        : `${d.motion === "rapid" ? "Rapid traverse" : "Cut"} behind the rear end of the blank at Z${w.size(d.rear)}, at ${w.place(
            d.x,
            d.z,
          )}: the clamping device is there.`,
    clampContact: (d, w) =>
      `${d.by === "tool" ? "The tool" : "The holder"} collides with ${CLAMPED[d.part]} at ${w.place(
        d.x,
        d.z,
      )}. End the cut earlier or change the clamping.`,
    contactsUnlooked: (d) =>
      `${d.limit} moves damage the contour, enter material at rapid traverse or touch it with the holder: not checked further from here.`,
    deeperThanInfeed: (d, w) =>
      "" +
      (d.pass === undefined ? "A smoothing or finishing cut" : `Pass ${w.number(d.pass)}`) +
      ` cuts ${w.length(d.depth)} deep; max. ${w.length(d.allowed)} is allowed.`,
    blankLacks: (d, w) =>
      `${w.text(d.what)} omits ${w.area(d.area)} of the material present in the program. The outline applies.`,
    blankGone: (d, w) =>
      `${w.text(d.what)} outlines ${w.area(d.area)} where the material is already removed. Removed material is not restored.`,
    nothingCut: () => "This operation removes no material.",
    airPasses: (d) => `${count(d.count, "pass cuts", "passes cut")} air.`,

    notUnderstood: (d, w) => `“${w.text(d.text)}” is not recognized: kept, not simulated.`,
    wordNotUnderstood: (d, w) => `The word “${w.text(d.text)}” is not recognized.`,
    wordTwice: (d, w) => `${w.text(d.word)} is programmed twice in this block; the last one applies.`,
    equalsMissing: (d, w) => `“${w.text(d.text)}” has no equals sign; it is read as if there were one.`,
    blankBeforeEquals: (d, w) => `“${w.text(d.text)}” has a space before the equals sign.`,
    lineTooLong: (d) => `The line has more than ${d.most} characters: it stays in the text, but it is not read.`,
    badNumber: (d, w) => `“${w.text(d.text)}” is not a number.`,
    wordMissing: (d, w) => `${w.text(d.word)} is missing in this block.`,
    blockNumber: (d) => `Block number ${d.found} is out of sequence; expected ${d.expected}.`,
    blockNumberMissing: (d) => `The block has no number; expected ${d.expected}.`,
    listWithoutTilde: (d) =>
      `${count(d.places, "cycle list has", "cycle lists have")} no ~ at the end of the line: the control cannot load the program.`,
    continuationOpen: () => "The line ends in ~, but no continuation follows.",
    isoProgram: () => "The text is DIN/ISO. Open it as a separate program to convert it to Klartext.",
    frameMissing: (d) => `The program has no ${d.which}.`,

    notSimulated: (d, w) => `${w.text(d.what)}: kept, not simulated.`,
    notProved: (d, w) => `${w.text(d.what)} is not simulated and can change path or stock: unverified from here.`,
    cycleNotSimulated: (d, w) => `Cycle ${d.cycle} ${w.text(d.name)}: kept, not simulated.`,
    noCycleDefined: () => "No cycle is defined before the call.",
    noToolCalled: () => "No tool is called before this block.",
    toolUnknown: (d, w) => `Tool ${w.text(d.tool)} is not in the table.`,
    notInTurnMode: () => "The cycle runs only in FUNCTION MODE TURN: program this block before the call.",
    compensationActive: (d) =>
      `${d.side} is active here, but the control requires R0: program R0 in the previous positioning block.`,
    feedZero: (d, w) =>
      `${w.text(d.word)}: the cutting feed is 0 here. Enter a feed above 0; FAUTO uses F of TOOL CALL.`,
    feedUnlikely: (d, w) =>
      `A feed of ${w.feed(d.feed, FEED[d.unit])} is unlikely. Check M136: with M136, F is per revolution.`,
    pointBeyondDepth: (d, w) =>
      `The bore is ${w.size(d.depth)} deep, but the point of the drill is ${w.size(d.point)} long: the bore does not reach its diameter.`,
    drillTooShort: (d, w) =>
      `The bore is ${w.size(d.depth)} deep, but the drill edges (LCUTS) are ${w.size(d.edges)} long: the shank may rub.`,
    centreMouth: (d, w) =>
      `The centre hole has ⌀${w.size(d.mouth)} at the face instead of ⌀${w.size(d.wanted)}: its drill needs a depth of ${w.size(d.depth)}.`,
    pitchOfTap: (d, w) => `Q239 is ${w.size(d.pitch)}, but the tap in the table has PITCH ${w.size(d.tap)}.`,
    freeChosen: () =>
      "From here several contours match the given values: the shortest is shown. The control uses the one " +
      "selected by FSELECT.",
    freeUnsolved: (d, w) =>
      `${w.text(d.form)}: the given values do not determine this element or contradict each other. Enter more values, or FSELECT.`,
    cycleNeverCalled: (d) => `Cycle ${d.cycle} is defined but never called: CYCL CALL or M99 is missing after it.`,
    neverReached: (d) => `The program ends at ${d.by}, before this block: the block is never executed.`,
    listOfOlderSoftware: (d, w) =>
      `The parameter list of cycle ${d.cycle} comes from older software. The control adds: ${d.filled
        .map((word) => w.text(word))
        .join(", ")}.`,
    parameterForeign: (d, w) =>
      `${w.text(d.name)} is not allowed here: cycle ${d.cycle} does not have this parameter, or it is programmed twice.`,
    runsIntoLabel: (d, w) => `The program runs into the contour of LBL ${w.text(d.label)}: M30 is missing before it.`,
    contourStartIncomplete: (d) => `The first block of the contour needs X and Z; ${d.axis} is missing.`,
    approachUncompensated: (d) => `${d.form} has no RL or RR: the following contour runs without radius compensation.`,
    labelMissing: (d, w) => `LBL ${w.text(d.label)} does not exist.`,
    labelTwice: (d, w) => `LBL ${w.text(d.label)} is programmed twice.`,
    labelNotClosed: (d, w) => `LBL ${w.text(d.label)} is not closed with LBL 0.`,
    contourNotNamed: (d) => `Cycle ${d.cycle} requires cycle 14 with the contour before the call.`,
    contoursJoined: (d, w) =>
      `${w.text(d.joined)}: several contours are combined here. Cycle ${w.number(d.cycle)} uses one contour only; its path is not shown.`,
    errorRaised: (d, w) =>
      d.error === null
        ? "FN 14: the control stops here with an error; the following blocks are not executed."
        : `FN 14: the control stops here with error ${w.number(d.error)}; the following blocks are not executed.`,
    contourInFile: (d, w) =>
      `The contour is in the file ${w.text(d.file)}, which is not available: copy the contour into a label and select it with cycle 14.`,
    feedMissing: () => "No feed is programmed.",
    spindleMissing: () => "No spindle speed is programmed; times are missing.",
    parameterUnset: (d) => `${d.name} has no value here.`,
    divisionByZero: () => "Division by zero.",
    notFinite: (d, w) => `“${w.text(d.text)}” gives no usable number.`,
    clampingUnread: (d, w) => `CLAMPING: “${w.text(d.what)}” is not recognized and is ignored.`,
    clampingIncomplete: (d) => `CLAMPING is ignored: ${d.words} is missing or invalid. The clamping is unknown.`,
    clampingTwice: () => "CLAMPING is defined twice: the first one applies. Delete this one.",
    clampingMisses: (d, w) =>
      `The clamping does not grip the blank: no surface of ${w.diameter(d.diameter)} in the clamping area. Check ⌀, length and face of CLAMPING.`,
    blankMissing: () => "The program defines no blank.",
    blankNotTurned: (d, w) => `A blank of type ${w.text(d.form)} is not rotationally symmetric.`,
    endsExchanged: (d, w) =>
      d.axis === "X"
        ? `From X${w.diameter(d.start)} to X${w.diameter(d.end)} there is no material to cut. Start and end (${d.other}) swapped?`
        : `From Z${w.signed(d.start)} to Z${w.signed(d.end)} the cycle cuts away from the chuck. Start and end (${d.other}) swapped?`,
    endInFront: (d, w) => `Z${w.signed(d.value)} is in front of the workpiece. ${w.signed(d.nearest)}?`,
    startInFront: (d, w) => `Z${w.signed(d.value)} is in front of the workpiece. ${w.signed(d.nearest)}?`,
    diameterInSolid: (d, w) =>
      `${w.diameter(d.value)} is inside the solid blank: there is no bore in which the tool could begin.`,
    diameterOutside: (d, w) => `${w.diameter(d.value)} is larger than the blank, ${w.diameter(d.blank)}.`,
    blankAgainstContour: (d, w) =>
      ({
        outside: `The contour reaches ${w.diameter(d.contour)}, the blank only ${w.diameter(d.blank)}. Proposed: ${w.diameter(d.nearest)}.`,
        bore: `The bore of the blank is ${w.diameter(d.blank)}, the contour ends at ${w.diameter(d.contour)}: nothing is cut. Proposed: ${w.diameter(
          d.nearest,
        )}.`,
        length: `The contour reaches Z${w.signed(d.contour)}, the blank only Z${w.signed(d.blank)}. Proposed: ${w.size(d.nearest)}.`,
        allowance: `The contour begins at Z${w.signed(d.contour)}, the blank at Z${w.signed(d.blank)}: the first passes cut air. Proposed: ${w.signed(
          d.nearest,
        )}.`,
        thread: `The thread is ${w.diameter(d.contour)}, the blank ${w.diameter(d.blank)}. Proposed: ${w.diameter(d.nearest)}.`,
      })[d.place],
    blankImpossible: () => "The blank has no volume: check its dimensions.",
    boxTurned: (d, w) =>
      `The box is treated as the cylinder around its corners, diameter ${w.size(d.outer)}. Material all round is certain only within diameter ${w.size(d.inner)}. Use BLK FORM CYLINDER for a round bar.`,
    blankTaken: (d, w) => `${w.text(d.what)} is used as the blank.`,
    blankAdds: (d, w) => `${w.text(d.what)} outlines ${w.area(d.area)} more than BLK FORM. The outline applies.`,
    blankTraced: () =>
      "With blank update on, roughing skips levels that touch no material. Other air moves, which the control " +
      "may shorten, are shown in full.",
    poleMissing: () => "The block requires a pole CC before it.",
    startUnknown: () => "The position before this block is not known.",
    arcImpossible: () => "No arc fits these values.",
    radiusCompensation: (d) => `${d.side} is recognized, but the path is not compensated.`,
    compensationUndefined: (d) =>
      `${d.side} with tip orientation TO ${d.orientation}: the compensation direction is not defined. Use a tool whose tip points to a corner, or program the path with R0.`,
    sideChanged: () => "Between RL and RR the control requires a block with R0.",
    approachWithoutContour: (d) => `${d.form} requires an adjacent contour element.`,
    lengthDelta: (d) =>
      `DZL and DXL of tool ${d.tool}: the control adds them to the tool lengths. The tool tip stays on the path; path and stock do not change.`,
    toolRadiusUnknown: (d, w) =>
      `The radius of tool ${w.text(d.tool)} is not known: the path is calculated with radius 0.`,
    wordsRecalled: (d, w) => `${w.text(d.what)}: parameters not verified against a manual; check on your control.`,
    programEndMissing: () => "M30 or M2 is missing at the end of the main program.",
    tooManyBlocks: (d) => `More than ${d.limit} blocks executed: stopped there.`,
    tooManyRepeated: (d) =>
      `More than ${d.limit} blocks executed again: stopped there. A jump or repetition may never end.`,
    tooManyMoves: (d) => `More than ${d.limit} moves: stopped there.`,
    contourTooLong: (d) => `The contour has more than ${d.limit} blocks: stopped there.`,
    tooManyOperations: (d) => `More than ${d.limit} cycle calls: stopped there.`,
    moreAlike: (d, w) =>
      `From here ${w.number(d.count)} more findings of the same kind (${d.code}) are counted, not listed.`,
    callsTooDeep: (d) => `Label calls are nested more than ${d.limit} deep.`,
    programsTooDeep: (d) =>
      `Program calls are nested more than ${d.limit} deep: one calls itself endlessly. Stopped there.`,
    endInCalled: (d) => `${d.word} is not allowed in a called program: the calling program continues after the call.`,
    programNotOpened: (d, w) => `${w.text(d.file)} is not open: open it together with this program to run it.`,
    programNotSelected: () => "CALL SELECTED PGM requires a program selected with SEL PGM before.",
  },
} satisfies MessagesTexts;
