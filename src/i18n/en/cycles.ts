import type { CyclesTexts } from "../cycle-text.ts";

const turnMode = "Runs only in FUNCTION MODE TURN. On a TNC7 the machine builder must have enabled the function.";
const safePosition =
  "Before the call, position the tool with R0 at a safe place: that point is the cycle start and decides how much is cut.";
const edgeLength = "A CUTLENGTH in the tool table limits the infeed in roughing; the infeed is then reduced, with a message.";

export const cycles = {
  groups: { shoulder: "Shoulders", contour: "Free contours", recessTurning: "Recess turning" },
  evidence: {
    A: "printed in a manual page of this control",
    B: "printed for a sister control",
    L: "taken from the lathe controls these cycles come from",
    I: "inferred from printed facts",
    K1: "clearly recalled, not checked against a printed page",
    K2: "recalled, not checked against a printed page",
    K3: "uncertain, not checked against a printed page",
  },
  kinds: {
    choice: "choice",
    diameter: "diameter",
    oversizeDiameter: "oversize on the diameter",
    radial: "on the radius",
    axial: "along Z",
    axialDepth: "depth along Z",
    length: "length",
    angle: "angle",
    feed: "feed",
  },
  roughStep: (step, of, text) => `Step ${step} of ${of}: ${text}`,
  finishStep: (step, of, text) => `Finishing, step ${step} of ${of}: ${text}`,
  positioning: "Positioning before step 1",
  of: {
    812: {
      name: "Shoulder, longitudinal, extended",
      summary: "Cuts a shoulder along the axis, with chamfers, angles and a corner radius.",
      description: [
        "Turns a shoulder lengthwise. The edges at the contour start and end can get a chamfer or a radius, the circumferential "
        + "surface and the face can lean, and the inside corner can be rounded.",
        "Roughs with paraxial passes, finishes, or both. Start diameter greater than end diameter: outside machining. Smaller: "
        + "inside machining.",
        "If the start point lies in the area to be cut, the tool first moves in X, then in Z, to the set-up clearance. For "
        + "finishing it first moves in Z to the set-up clearance.",
      ],
      rough: [
        "paraxial infeed at rapid",
        "cut lengthwise at the roughing feed",
        "retract by the infeed",
        "back to the start of the cut at rapid",
        "repeat until the contour is reached",
        "back to the cycle start at rapid",
      ],
      finish: [
        "paraxial infeed at rapid",
        "finish the contour from start to end",
        "retract by the set-up clearance",
        "back to the cycle start at rapid",
      ],
      notes: [turnMode, safePosition, edgeLength],
    },
    820: {
      name: "Contour, transverse",
      summary: "Cuts a free contour from a subprogram, across the axis.",
      description: [
        "Turns any contour crosswise. The contour stands in a subprogram of lines, roundings, chamfers and arcs, named by cycle 14 "
        + "or SEL CONTOUR.",
        "Roughs with paraxial passes, finishes, or both. First contour point greater in X than the last: outside machining. "
        + "Smaller: inside machining.",
        "If Z of the start point is below the contour start, the tool first moves in Z to the contour start; for finishing, to the "
        + "set-up clearance.",
      ],
      rough: [
        "paraxial infeed at rapid",
        "cut crosswise at the roughing feed",
        "retract by the infeed",
        "back to the start of the cut at rapid",
        "repeat until the contour is reached",
        "back to the cycle start at rapid",
      ],
      finish: [
        "infeed at rapid",
        "finish the contour from start to end",
        "retract by the set-up clearance",
        "back to the cycle start at rapid",
      ],
      notes: [
        "Danger of collision: the machining limit restricts the contour that is cut, but approach and departure may cross it. "
        + "Stand the tool, before the call, on the side of the limit that is to be cut.",
        turnMode,
        safePosition,
        "The shape of the insert is taken into account so that no element is damaged. What the tool cannot reach stays, with a warning.",
        "Cycle 14 with the label of the contour, or SEL CONTOUR with its file, must stand before the call.",
        "Local parameters (QL) used in the contour must be set in the contour subprogram itself.",
        edgeLength,
      ],
    },
    852: {
      name: "Recess turning, axial, extended",
      summary: "Turns a groove into a face, with leaning walls, chamfers and floor radii.",
      description: [
        "Makes a groove in a face by recess turning: the tool plunges to a depth and then turns sideways, so there are few "
        + "lift-offs. The edges can get a chamfer or a radius, both walls can lean, and the floor corners can be rounded.",
        "Roughs with paraxial passes, finishes, or both. Start diameter greater than end diameter: outside machining. Smaller: "
        + "inside machining.",
        "If Z of the start point is below the contour start Q492, the tool first moves in Z to Q492.",
      ],
      rough: [
        "plunge to the first depth",
        "cut sideways between start and end at the roughing feed",
        "plunging elements at their own feed",
        "lift, return and approach again (one direction), or feed in at both ends (both directions)",
        "cut to the next depth",
        "repeat until the depth of the groove is reached",
        "rapid to the clearance, then one cut down each wall",
        "back to the cycle start at rapid",
      ],
      finish: [
        "rapid to the first wall",
        "finish the first wall",
        "finish the floor; with a corner radius the whole groove in one go",
        "out of the groove at rapid",
        "rapid to the second wall",
        "finish the second wall",
        "back to the cycle start at rapid",
      ],
      notes: [
        turnMode,
        safePosition,
        "From the second infeed on, each pass is 0.1 mm shorter, or shorter by Q508; this relieves the tool sideways. What stays "
        + "is taken in one cut at the end of roughing.",
        "If the offset passes 80 % of the effective width (edge width minus twice the edge radius), the control stops with an error.",
        edgeLength,
        "The page calls Q460 reserved and still names the set-up clearance in two of its steps; we use a fixed clearance there.",
      ],
    },
  },
} satisfies CyclesTexts;
