import type { MessagesTexts } from "../../message-texts.ts";
import { running } from "./messages/running.ts";
import { threads } from "./messages/threads.ts";

/** What a finding offers, where it offers something. */
const nearest = (value: number | undefined, say: (value: number) => string) =>
  value === undefined ? "" : ` Nearest value that works: ${say(value)}.`;
/** "4 blocks", "1 block". */
const count = (n: number, one: string, many: string) => `${n} ${n === 1 ? one : many}`;

const reasons: MessagesTexts["reasons"] = {
  insertRadius: "the insert radius",
  mainEdge: "the main edge of the insert",
  secondaryEdge: "the secondary edge of the insert",
  toolWidth: "the width of the tool",
  cutLength: "CUTLENGTH",
  limit: "the machining limit",
  plunging: "plunging not being allowed",
  oversize: "the oversize",
  smoothing: "steps between the passes",
  correction: "the correction of the tool",
  overCrest: "what stood over the crest of the thread",
};

const ELEMENT = { angle: "angle", length: "length", radius: "radius" };

/** What holds the work. */
const CLAMPED = {
  jaws: "the jaws",
  chuck: "the chuck",
  collet: "the collet",
  driver: "the driver",
  tailstock: "the tailstock",
  limit: "the stated limit",
};

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
    startEqualsEnd: (d, w) => `Start and end are the same: ${d.other} is ${w.value(d.value)} too.`,
    startLevelWithEnd: (d, w) =>
      `The start point stands at ${d.axis} ${w.size(d.value)}, where the contour ends: between the two there is nothing to cut.`,
    diameterNegative: (d, w) =>
      `${w.value(d.value)} is a diameter on the far side of the axis, where no contour is planned.${nearest(d.nearest, w.value)}`,
    elementTooLong: (d, w) => `${w.size(d.size)} is longer than the element allows: ${w.size(d.max)} at most.`,
    cornersTooWide: (d, w) =>
      `Two corner radii of ${w.size(d.radius)} are wider than the floor: ${w.size(d.max)} at most.`,
    wallsMeet: (d, w) => `With ${w.angle(d.angle)} the walls meet above the floor: less than ${w.angle(d.max)}.`,
    cornerSmallerThanInsert: (d, w) =>
      `Corner radius ${w.size(d.radius)} is smaller than the insert's ${w.size(d.insert)}: the corner will ` +
      `keep ${w.size(d.insert)}.`,
    recessNarrowerThanTool: (d, w) =>
      `The floor of the recess is ${w.size(d.width)} wide, tool and oversize need ${w.size(d.tool)}.${nearest(d.nearest, w.value)}`,
    angleNotFollowed: (d, w) =>
      `${d.element === undefined ? "The" : `Element ${d.element}: the`} tool cannot follow ${w.angle(d.angle)}: ${reasons[d.edge]} allows ${w.angle(
        d.max,
      )}, material stays.` + ``,
    tooManyPasses: (d, w) => `${d.passes} passes are more than ${d.most}.${nearest(d.nearest, w.size)}`,
    infeedOverCutLength: (d, w) =>
      `Infeed ${w.size(d.infeed)} is more than CUTLENGTH ${w.size(d.cutLength)}: it is reduced to ${w.size(d.cutLength)}.`,
    depthOverCutLength: (d, w) =>
      `Depth ${w.size(d.depth)} is more than CUTLENGTH ${w.size(d.cutLength)}: the rest stays.`,
    offsetReduced: (d, w) =>
      `Offset ${w.size(d.offset)} is reduced to ${w.size(d.kept)}: ` +
      `${count(d.passes, "pass shares", "passes share")} 80 % of the effective width.`,
    offsetOverLimit: (d, w) =>
      `The side offset of ${count(d.passes, "pass", "passes")} adds up to ${w.size(d.offset)}; 80 % of the ` +
      `effective width is ${w.size(d.max)}.${nearest(d.nearest, w.size)}`,
    toolUnfit: (d) =>
      `A ${d.type} tool with tip orientation ${d.orientation} cannot do this. Take ${d.types.join(" or ")} with ` +
      `orientation ${d.orientations.join(", ")}.`,
    toolCannotCutSideways: (d) => `A ${d.type} tool only plunges, this cycle also cuts sideways. Take a RECTURN tool.`,
    flanksNotChecked: () => "T-ANGLE or P-ANGLE is empty: the flanks of the insert are not checked.",
    toolColumn: (d, w) => {
      const what =
        d.value === null ? `${d.column} is missing or no number.` : `${d.column} ${w.value(d.value)} is not possible.`;
      if (d.min !== undefined && d.max !== undefined) return `${what} Allowed: ${w.value(d.min)} to ${w.value(d.max)}.`;
      if (d.min !== undefined)
        return `${what} It must be ${d.column === "CUTWIDTH" ? "more than" : "at least"} ${w.value(d.min)}.`;
      return d.max === undefined ? what : `${what} It must be less than ${w.value(d.max)}.`;
    },
    toolNumberTwice: (d) => `Tool ${d.number} stands in the table already.${nearest(d.nearest, String)}`,
    toolName: (d, w) =>
      `“${w.text(d.text)}”: a name has at most ${d.max} characters: capital letters, digits and # $ % & , - . _ only.`,
    holderAxis: (d, w) => `“${w.text(d.text)}”: the shank lies along X or along Z.`,
    holderHead: (d, w) =>
      `“${w.text(d.text)}” is no outline. Each corner is Z/X from the tip, blanks between corners, a semicolon ` +
      "between parts; a part needs three corners.",
    betterTool: (d) => `Tool ${d.tool} ${d.name} can make this contour.`,
    startInArea: (d, w) =>
      `The start point ${w.place(d.x, d.z)} lies in the area to be cut: the tool first moves to the set-up clearance.`,
    startInMaterial: (d, w) => `The start point ${w.place(d.x, d.z)} stands in the material.`,
    startBelowContour: (d, w) =>
      `The start point lies ${w.length(d.below)} below the contour start: the tool first moves up to it.`,
    startBehindContour: (d, w) =>
      `The start point lies ${w.length(d.behind)} behind the contour start: the tool first moves in Z to the set-up clearance of ${w.size(
        d.clearance,
      )} in front of it.`,
    startInPart: (d, w) =>
      `The start point lies inside the finished part: nothing is cut from there. A start point that works: ${w.place(d.x, d.z)}.`,
    insertAcrossAxis: (d, w) =>
      `The insert reaches ${w.length(d.reach)} across the axis and cuts into the finished part there.` +
      (d.nearest === undefined
        ? " It is too long for this bore."
        : ` From a start point at X${w.diameter(d.nearest)} on it stays clear.`),
    boreMissing: (d, w) =>
      `A bore is missing: the material is solid from Z${w.signed(d.z)} on, and this cycle goes on to Z${w.signed(d.to)}. Bore ${w.diameter(
        d.need,
      )} or more as far as that first.`,
    startOnWrongSide: (d, w) =>
      `The contour runs towards the start point: nothing is cut from there. A start point that works: ${w.place(d.x, d.z)}.`,
    startInsideEnvelope: (d, w) =>
      `The start point is nearer to the contour than the clearance of ${w.size(d.clearance)}: the tool goes ` +
      "straight to the contour at the finishing feed.",
    limitOnWrongSide: (d, w) =>
      `With the limit ${w.value(d.limit)} nothing is cut on the side where the tool stands.${nearest(d.nearest, w.value)}`,
    cutBehindLimit: (d, w) =>
      `Behind the limit ${w.area(d.area)} of material are cut at ${w.place(
        d.x,
        d.z,
      )}: only the contour is limited, not approach and departure.` +
      (d.finishing ? " Roughing alone (Q215 = 1) leaves it." : " Put the limit where these find no material."),
    nothingToCut: () => "Between start point and contour there is nothing to cut.",
    contourMissing: (d, w) =>
      d.label === "" ? "The contour is missing." : `The contour LBL ${w.text(d.label)} does not exist.`,
    contourTooShort: () => "A contour needs at least two different points.",
    contourFlat: (d) => `Start and end of the contour have the same ${d.axis}: there is nothing between them to cut.`,
    contourEndCovered: (d, w) =>
      `The contour ends at ${w.place(d.x, d.z)} inside itself: one of its elements reaches past this end, so that the part cannot go on.`,
    contourPoint: (d) => `Element ${d.element}: the end point is missing or cannot be reached.`,
    cornerElementAlone: (d) =>
      `Element ${d.element}: a chamfer or rounding needs an element before and behind it; a chamfer needs two lines.`,
    cornerElementTooLong: (d, w) =>
      `Element ${d.element}: ${w.size(d.size)} does not fit between its neighbours: ${w.size(d.max)} at ` + `most.`,
    arcOffCircle: (d, w) => `Element ${d.element}: the end point misses its circle by ${w.size(d.gap)}.`,
    arcTooSmall: (d, w) => `Element ${d.element}: radius ${w.size(d.radius)} is too small for its end point.`,
    elementFree: (d) =>
      d.freedom === 1
        ? `Element ${d.element}: one more value is needed.`
        : `Element ${d.element}: ${d.freedom} more values are needed.`,
    elementContradicts: (d, w) =>
      d.quantity === "tangent"
        ? `Element ${d.element} does not leave the one before it tangentially; it is off by ${w.number(d.nearest)}°.`
        : `Element ${d.element}: the ${ELEMENT[d.quantity]} ${(d.quantity === "angle" ? w.number : w.size)(
            d.given,
          )} does not agree with the other ` +
          `values; ${(d.quantity === "angle" ? w.number : w.size)(d.nearest)} does.`,
    elementUnreachable: (d) =>
      `Element ${d.element}: with this length, radius or angle it does not reach its neighbour.`,
    centreMissing: (d) => `Element ${d.element}: its centre is missing; put CC before it.`,
    contourCrossesItself: (d) => `Element ${d.element} crosses element ${d.other}.`,
    toolRadiusTooLarge: (d, w) =>
      `Element ${d.element}: a tool radius of ${w.size(d.radius)} does not fit.${nearest(d.nearest, w.size)}`,
    pathCutsContour: (d, w) =>
      `Along element ${d.element} the tool cuts ${w.length(d.depth)} into element ${d.other} at ${w.spot(
        d.x,
        d.y,
        undefined,
      )}: it is too large to pass` + `; the control compares neighbours only.${nearest(d.nearest, w.size)}`,
    approachNeedsSide: () => "CT needs RL or RR: with R0 the control stops here.",
    approachSideAssumed: () =>
      "R0 names no side: the tool is taken to come from the left of the contour. Verify on your control.",
    approachInsideCircle: (d, w) =>
      `${d.point} lies inside the circle of R ${w.size(d.radius)}: no line from there touches it.${nearest(d.nearest, w.size)}`,
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
      `Element ${d.element}: an undercut needs a cylinder parallel to the axis and a face square to it; a recess needs a ` +
      "straight element of its direction.",
    recessWord: (d) => `Element ${d.element}: ${d.word} is missing or makes no possible shape.`,
    recessWordsExclusive: (d) =>
      `Element ${d.element}: ${d.other} and ${d.word} exclude each other. Enter one of them.`,
    pitchNotListed: (d, w) => {
      const near = [d.below, d.above].flatMap((n) => (n === undefined ? [] : [w.size(n, 4)])).join(" and ");
      return `Element ${d.element}: DIN 76 has no relief for a pitch of ${w.size(
        d.pitch,
        4,
      )}; next to it are ${near}. Take one of them, or write ${d.words}.`;
    },
    undercutDefaults: (d) =>
      `Element ${d.element}: ${d.words} taken from the standard, not printed for this control. Enter the words to be sure.`,
    materialLeft: (d, w) =>
      d.asked === undefined
        ? `${w.area(d.area)} stay at ${w.place(d.x, d.z)}, left by ${reasons[d.reason]}.`
        : d.reason === "oversize"
          ? `${w.area(d.area)} of oversize stay at ${w.place(d.x, d.z)}, as asked for.`
          : `The corner at ${w.place(d.x, d.z)} is as round as the insert: ${w.area(d.area)} stay. No other radius is asked for.`,
    gouge: (d, w) => `${w.area(d.area)} of the finished part are cut away at ${w.place(d.x, d.z)}.`,
    rapidInStock: (d, w) => `A rapid runs through ${w.area(d.area)} of material at ${w.place(d.x, d.z)}.`,
    holderContact: (d, w) => `The holder touches material at ${w.place(d.x, d.z)}.`,
    cutBelowContour: (d, w) =>
      `This cut goes ${w.area(d.area)} below the contour of the cycle in block ${d.block}, at ${w.place(
        d.x,
        d.z,
      )}. If it is meant, say so.`,
    cameLoose: (d, w) =>
      `${{ piece: "A piece", ring: "A ring", slug: "A slug" }[d.shape]} of ${w.area(d.area)} at ${w.place(
        d.x,
        d.z,
      )} no longer hangs together ` + `with the clamped end: block ${d.block} cuts it loose.`,
    partedOff: (d, w) =>
      `The piece at ${w.place(d.x, d.z)}, ${w.area(d.area)}, is parted off in block ${d.block} and leaves the picture.`,
    cutOnLoosePiece: (d, w) =>
      `${w.area(d.area)} would be cut at ${w.place(d.x, d.z)} from a piece that block ${d.block} has cut off: nothing holds it any more.`,
    behindBlank: (d, w) =>
      d.motion === "unheld"
        ? `The outside is turned up to the rear end of the blank at Z${w.size(
            d.rear,
          )}: nothing is left to hold. State the clamping if it is held elsewhere.`
        : `${d.motion === "rapid" ? "A rapid runs" : "The tool cuts"} behind the rear end of the blank at Z${w.size(d.rear)}, at ${w.place(
            d.x,
            d.z,
          )}: what holds the work stands there.`,
    clampContact: (d, w) =>
      `${d.by === "tool" ? "The tool" : "The holder"} runs into ${CLAMPED[d.part]} at ${w.place(
        d.x,
        d.z,
      )}. End the cut before it or clamp otherwise.`,
    contactsUnlooked: (d) =>
      `${d.limit} moves cut the part, ran into material or touched it with the holder: from here on moves were not looked at for that.`,
    deeperThanInfeed: (d, w) =>
      "" +
      (d.pass === undefined ? "A smoothing or finishing cut" : `Pass ${w.number(d.pass)}`) +
      ` takes ${w.length(d.depth)} of stock at once; ${w.length(d.allowed)} are allowed.`,
    blankLacks: (d, w) =>
      `${w.text(d.what)} leaves out ${w.area(d.area)} of the material that stands there by the program. The outline counts.`,
    blankGone: (d, w) =>
      `${w.text(d.what)} outlines ${w.area(d.area)} where nothing stands any more. What has been cut stays cut.`,
    nothingCut: () => "This operation removes no stock.",
    airPasses: (d) => `${count(d.count, "pass touches", "passes touch")} no stock.`,

    notUnderstood: (d, w) => `“${w.text(d.text)}” is not understood: kept, not simulated.`,
    wordNotUnderstood: (d, w) => `The word “${w.text(d.text)}” is not understood.`,
    wordTwice: (d, w) => `${w.text(d.word)} stands twice in this block; the last one counts.`,
    equalsMissing: (d, w) => `“${w.text(d.text)}” has no equals sign. It is read as if it had one.`,
    blankBeforeEquals: (d, w) => `“${w.text(d.text)}” has a blank before the equals sign.`,
    badNumber: (d, w) => `“${w.text(d.text)}” is not a number.`,
    wordMissing: (d, w) => `${w.text(d.word)} is missing in this block.`,
    blockNumber: (d) => `Block number ${d.found} does not follow; ${d.expected} would.`,
    blockNumberMissing: (d) => `The block has no number; ${d.expected} would follow.`,
    listWithoutTilde: (d) =>
      `${count(d.places, "cycle list has", "cycle lists have")} no ~ at the end of the line: a control would not load the program.`,
    continuationOpen: () => "The line ends in ~, but no continuation follows.",
    isoProgram: () => "The text is DIN/ISO. Open it as a program of its own: it is translated into Klartext then.",
    frameMissing: (d) => `The program has no ${d.which}.`,

    notSimulated: (d, w) => `${w.text(d.what)}: kept, not simulated.`,
    notProved: (d, w) =>
      `${w.text(d.what)} is not simulated and can move the path or the stock: nothing is proved from here on.`,
    cycleNotSimulated: (d, w) => `Cycle ${d.cycle} ${w.text(d.name)}: kept, not simulated.`,
    noCycleDefined: () => "The call has no cycle definition before it.",
    noToolCalled: () => "No tool is called before this block.",
    toolUnknown: (d, w) => `Tool ${w.text(d.tool)} is not in the table.`,
    notInTurnMode: () => "The cycle runs only in FUNCTION MODE TURN: program that block before the call.",
    compensationActive: (d) =>
      `${d.side} is active here, and the control wants R0: program R0 in the positioning block before.`,
    feedZero: (d, w) =>
      `${w.text(d.word)}: the cutting feed is 0 here. Give a feed above 0; FAUTO takes the F of TOOL CALL.`,
    feedUnlikely: (d, w) =>
      `A feed of ${w.number(d.feed)} ${d.unit} is not likely. Check M136: with it F counts in mm per revolution.`,
    drillTooShort: (d, w) =>
      `The bore is ${w.size(d.depth)} deep, the edges of the drill (LCUTS) are ${w.size(d.edges)} long: it may rub on its shank.`,
    pitchOfTap: (d, w) => `Q239 is ${w.size(d.pitch)}, and the tap in the table has a PITCH of ${w.size(d.tap)}.`,
    freeChosen: () =>
      "From here on several contours fit what is given: the shortest is shown. A control takes the one that FSELECT names.",
    freeUnsolved: (d, w) =>
      `${w.text(d.form)}: what is given does not determine this element, or contradicts itself. Give more values, or FSELECT.`,
    cycleNeverCalled: (d) => `Cycle ${d.cycle} is defined and never called: CYCL CALL or M99 is missing behind it.`,
    neverReached: (d) => `The program ends at ${d.by}, before this block: it is never run.`,
    listOfOlderSoftware: (d, w) =>
      `The list of cycle ${d.cycle} was written by older software. The control fills in: ${d.filled
        .map((word) => w.text(word))
        .join(", ")}.`,
    parameterForeign: (d, w) =>
      `${w.text(d.name)} does not belong here: cycle ${d.cycle} has no such parameter, or it stands twice.`,
    runsIntoLabel: (d, w) =>
      `The program runs on into the contour of LBL ${w.text(d.label)}: M30 is missing before it.`,
    contourStartIncomplete: (d) => `The first block of the contour needs X and Z; ${d.axis} is missing.`,
    approachUncompensated: (d) => `${d.form} has no RL or RR: the contour behind it runs without radius compensation.`,
    labelMissing: (d, w) => `LBL ${w.text(d.label)} does not exist.`,
    labelTwice: (d, w) => `LBL ${w.text(d.label)} stands twice in the program.`,
    labelNotClosed: (d, w) => `LBL ${w.text(d.label)} is not closed by LBL 0.`,
    contourNotNamed: (d) => `Cycle ${d.cycle} needs cycle 14 with its contour before the call.`,
    contoursJoined: (d, w) =>
      `${w.text(d.joined)}: several contours make one here. Cycle ${w.number(d.cycle)} takes one contour; its path is not shown.`,
    errorRaised: (d, w) =>
      d.error === null
        ? "FN 14: the control stops here with an error; nothing behind it is run."
        : `FN 14: the control stops here with error ${w.number(d.error)}; nothing behind it is run.`,
    contourInFile: (d, w) =>
      `The contour is in the file ${w.text(d.file)}, which is not at hand: put it into a label and name it with cycle 14.`,
    feedMissing: () => "No feed is programmed.",
    spindleMissing: () => "No spindle speed is programmed; times are missing.",
    parameterUnset: (d) => `${d.name} has no value here.`,
    divisionByZero: () => "Division by zero.",
    notFinite: (d, w) => `“${w.text(d.text)}” gives no usable number.`,
    clampingUnread: (d, w) => `CLAMPING: “${w.text(d.what)}” is not understood and does not count.`,
    clampingIncomplete: (d) =>
      `CLAMPING does not count: ${d.words} is missing or impossible. Nothing is known of the clamping.`,
    clampingTwice: () => "CLAMPING stands twice: the first one counts. Delete this one.",
    clampingMisses: (d, w) =>
      `The clamping does not grip the blank: there is no surface of ${w.diameter(
        d.diameter,
      )} in its grip. Check ⌀, length and face of CLAMPING.`,
    blankMissing: () => "The program states no blank.",
    blankNotTurned: (d, w) => `A blank of the form ${w.text(d.form)} is not turned round the axis.`,
    endsExchanged: (d, w) =>
      d.axis === "X"
        ? `From X${w.diameter(d.start)} to X${w.diameter(d.end)} there is no material to cut. Start and end (${d.other}) exchanged?`
        : `From Z${w.signed(d.start)} to Z${w.signed(d.end)} there is no material to cut. Start and end (${d.other}) exchanged?`,
    endInFront: (d, w) => `Z${w.signed(d.value)} is in front of the workpiece. ${w.signed(d.nearest)}?`,
    blankAgainstContour: (d, w) =>
      ({
        outside: `The contour reaches ${w.diameter(d.contour)}, the blank only ${w.diameter(d.blank)}. Proposed: ${w.diameter(d.nearest)}.`,
        bore: `The bore of the blank is ${w.diameter(d.blank)}, the contour ends at ${w.diameter(d.contour)}: nothing is cut. Proposed: ${w.diameter(
          d.nearest,
        )}.`,
        length: `The contour reaches Z${w.signed(d.contour)}, the blank only Z${w.signed(d.blank)}. Proposed: ${w.size(d.nearest)}.`,
        allowance: `The contour begins at Z${w.signed(d.contour)}, the blank at Z${w.signed(d.blank)}: it is cut in the air. Proposed: ${w.signed(
          d.nearest,
        )}.`,
        thread: `The thread is ${w.diameter(d.contour)}, the blank ${w.diameter(d.blank)}. Proposed: ${w.diameter(d.nearest)}.`,
      })[d.place],
    blankImpossible: () => "The blank has no volume: check its measures.",
    boxTurned: (d, w) =>
      `The box turns as the cylinder round its corners, diameter ${w.size(d.outer)}. Only within diameter ${w.size(
        d.inner,
      )} is there material all round for sure. ` + "A round bar is a BLK FORM CYLINDER.",
    blankTaken: (d, w) => `${w.text(d.what)} is taken as the blank.`,
    blankAdds: (d, w) => `${w.text(d.what)} outlines ${w.area(d.area)} more than BLK FORM has. The outline counts.`,
    blankTraced: () =>
      "While the blank is traced, roughing leaves out levels that touch nothing. " +
      "Other ways in the air, which the control may shorten, are shown in full.",
    poleMissing: () => "The block needs a pole CC before it.",
    startUnknown: () => "The position before this block is not known.",
    arcImpossible: () => "No arc fits these values.",
    radiusCompensation: (d) => `${d.side} is read, but the path is not compensated.`,
    compensationUndefined: (d) =>
      `${d.side} with tip orientation TO ${d.orientation}: the direction of the compensation is not defined. ` +
      "Take a tool whose tip points to a corner, or program the path with R0.",
    sideChanged: () => "Between RL and RR the control needs a block with R0.",
    approachWithoutContour: (d) => `${d.form} needs a contour element next to it.`,
    lengthDelta: (d) =>
      `DZL and DXL of tool ${d.tool}: the control adds them to the tool lengths. The tip stays on the path; neither path nor ` +
      "stock changes.",
    toolRadiusUnknown: (d, w) =>
      `The radius of tool ${w.text(d.tool)} is not known: the path is calculated with radius 0.`,
    wordsRecalled: (d, w) =>
      `${w.text(d.what)}: its words are recalled, not checked against a printed page. Verify on your control.`,
    programEndMissing: () => "M30 or M2 is missing at the end of the main program.",
    tooManyBlocks: (d) =>
      `More than ${d.limit} blocks were executed: stopped there. If it has fewer, a jump or a repetition does not come to its end.`,
    tooManyMoves: (d) => `More than ${d.limit} moves: stopped there.`,
    contourTooLong: (d) => `The contour has more than ${d.limit} blocks: stopped there.`,
    tooManyOperations: (d) => `More than ${d.limit} cycle calls: stopped there.`,
    moreAlike: (d, w) =>
      `From here on ${w.number(d.count)} more findings of the same kind (${d.code}) are counted, not listed.`,
    callsTooDeep: (d) => `Labels call each other more than ${d.limit} deep.`,
    programsTooDeep: (d) =>
      `Programs call each other more than ${d.limit} deep: one of them calls itself without end. Stopped there.`,
    endInCalled: (d) =>
      `${d.word} stands in a called program, where a control does not allow it: the calling program goes on behind the call.`,
    programNotOpened: (d, w) => `${w.text(d.file)} is not open: open it together with this program, and it is run too.`,
    programNotSelected: () => "CALL SELECTED PGM needs a program that SEL PGM has named before.",
  },
} satisfies MessagesTexts;
