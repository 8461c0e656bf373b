import type { ParamsTexts } from "../../param-text.ts";
import { turning } from "./params/turning.ts";
import { recessing } from "./params/recessing.ts";
import { threads } from "./params/threads.ts";
import { special } from "./params/special.ts";

const printed = false;
const element = { 0: "no element", 1: "chamfer", 2: "radius" };

export const params = {
  operation: {
    prompt: "Machining operation (0/1/2/3)?",
    printed,
    label: "Operation",
    explanation: "What the cycle does: roughing, finishing or both.",
    choices: {
      0: "roughing and finishing",
      1: "roughing only",
      2: "finishing only, to the finished size",
      3: "finishing only, to the oversize",
    },
  },
  clearance: {
    prompt: "Set-up clearance?",
    printed,
    label: "Set-up clearance",
    explanation: "Distance to the material for pre-positioning and retraction.",
  },
  clearanceReserved: {
    prompt: "Set-up clearance?",
    printed,
    label: "Set-up clearance (reserved)",
    explanation: "Reserved: the value has no function in this cycle. Retractions use a fixed clearance.",
  },
  startDiameter: {
    prompt: "Diameter at contour start?",
    printed,
    label: "Start ⌀",
    explanation:
      "X of the contour start, as a diameter. Greater than Q493: outside machining. Smaller than Q493: inside " +
      "machining.",
  },
  startZ: {
    prompt: "Contour start in Z?",
    printed,
    label: "Start Z",
    explanation: "Z of the contour start.",
  },
  endDiameter: {
    prompt: "Diameter at contour end?",
    printed,
    label: "End ⌀",
    explanation:
      "X of the contour end, as a diameter. Together with the start diameter, it decides between outside and " +
      "inside machining.",
  },
  endZ: {
    prompt: "Contour end in Z?",
    printed,
    label: "End Z",
    explanation: "Z of the contour end.",
  },
  surfaceAngle: {
    prompt: "Angle of circumferential surface?",
    printed,
    label: "Surface angle",
    explanation:
      "Angle between the circumferential surface and the rotary axis; 0 is a cylinder. The surface is inclined " +
      "into the area to be machined, never below it.",
  },
  flankAngle: {
    prompt: "Angle of flank?",
    printed,
    label: "Flank angle",
    explanation:
      "Angle between the flank at the contour start and a parallel to the rotary axis. The recess gets narrower " +
      "towards the floor.",
  },
  faceAngle: {
    prompt: "Angle of face?",
    printed,
    label: "Face angle",
    explanation:
      "Inclination of the face; 0 is perpendicular to the rotary axis. The face is inclined into the area to be " +
      "machined.",
  },
  secondFlankAngle: {
    prompt: "Angle of second flank?",
    printed,
    label: "Second flank angle",
    explanation: "Angle between the flank at the contour end and a parallel to the rotary axis.",
  },
  startElement: {
    prompt: "Type of starting element (0/1/2)?",
    printed,
    label: "Start element",
    explanation: "Element on the edge at the contour start.",
    choices: element,
  },
  startElementSize: {
    prompt: "Size of starting element?",
    printed,
    label: "Start element size",
    explanation: "Leg of the chamfer, or radius, at the contour start. Without an element (Q501 = 0) it has no effect.",
  },
  cornerRadius: {
    prompt: "Radius at contour corner?",
    printed,
    label: "Corner radius",
    explanation: "Radius in the inside corner. 0 or no entry: a sharp corner, in which the tool nose radius remains.",
  },
  endElement: {
    prompt: "Type of end element (0/1/2)?",
    printed,
    label: "End element",
    explanation: "Element on the edge at the contour end.",
    choices: element,
  },
  endElementSize: {
    prompt: "Size of end element?",
    printed,
    label: "End element size",
    explanation: "Leg of the chamfer, or radius, at the contour end. Without an element (Q503 = 0) it has no effect.",
  },
  infeedRadial: {
    prompt: "Maximum cutting depth?",
    printed,
    label: "Max. infeed",
    explanation:
      "Largest infeed per pass, on the radius. The depth is divided evenly, so the actual infeed is often " +
      "smaller, without a thin last cut.",
  },
  infeedAxial: {
    prompt: "Maximum cutting depth?",
    printed,
    label: "Max. infeed",
    explanation:
      "Largest infeed per pass, along Z. The depth is divided evenly, so the actual infeed is often smaller, " +
      "without a thin last cut. 0: one pass.",
  },
  infeedGroove: {
    prompt: "Maximum cutting depth?",
    printed,
    label: "Max. infeed",
    explanation:
      "Largest infeed per pass, along Z, divided evenly. The manual calls the infeed radial, but an axial recess " +
      "has its infeed in Z; unverified.",
  },
  roughingFeed: {
    prompt: "Roughing feed rate?",
    printed,
    label: "Roughing feed",
    explanation:
      "Feed of the roughing passes: mm per revolution with M136, mm per minute without. FAUTO takes the feed of " +
      "the tool call.",
  },
  oversizeDiameter: {
    prompt: "Oversize for diameter?",
    printed,
    label: "Oversize ⌀",
    explanation: "Stock left on the diameter for finishing; half of it on each side.",
  },
  oversizeZ: {
    prompt: "Oversize in Z?",
    printed,
    label: "Oversize Z",
    explanation: "Stock left on faces for finishing, along Z.",
  },
  finishingFeed: {
    prompt: "Finishing feed rate?",
    printed,
    label: "Finishing feed",
    explanation:
      "Feed of the finishing cut: mm per revolution with M136, mm per minute without. FAUTO takes the feed of " +
      "the tool call.",
  },
  smoothing: {
    prompt: "Contour smoothing (0/1/2)?",
    printed,
    label: "Smoothing",
    explanation: "How the steps between passes are removed, and how the tool lifts off.",
    choices: {
      0: "after each pass along the contour, within the infeed",
      1: "once after the last pass, along the whole contour; lifts off at 45°",
      2: "no smoothing; lifts off at 45°",
    },
  },
  reverseContour: {
    prompt: "Reverse contour (0-2)?",
    printed,
    label: "Reverse contour",
    explanation: "Direction in which the contour is machined.",
    choices: {
      0: "as programmed",
      1: "against the programmed direction",
      2: "against the programmed direction, with the tip mirrored in the feed direction (orientation 1 cuts as 7)",
    },
  },
  plunging: {
    prompt: "Allow plunging (0/1)?",
    printed,
    label: "Plunging",
    explanation: "Whether elements that fall into the material are machined.",
    choices: { 0: "falling elements are left", 1: "falling elements are machined" },
  },
  plungingFeed: {
    prompt: "Plunging feed rate (0=auto)?",
    printed,
    label: "Plunging feed",
    explanation:
      "Feed on contour elements that descend into the material. 0 or no entry: the feed of the turning operation.",
  },
  limits: {
    prompt: "Machining limits (0/1)?",
    printed,
    label: "Limits",
    explanation:
      "Restricts the machined contour to one side of Q480 and Q482: the side on which the tool is at the call. " +
      "Approach " +
      "and departure may cross the limits.",
    choices: { 0: "no limits", 1: "limits at Q480 and Q482" },
  },
  limitDiameter: {
    prompt: "Limit value for diameter?",
    printed,
    label: "Limit ⌀",
    explanation: "Limit in X, as a diameter. Active with Q479 = 1.",
  },
  limitZ: {
    prompt: "Limit value in Z?",
    printed,
    label: "Limit Z",
    explanation: "Limit in Z. Active with Q479 = 1.",
  },
  direction: {
    prompt: "Direction (0=bidir./1=unidir.)?",
    printed,
    label: "Direction",
    explanation: "Whether the passes alternate between both directions.",
    choices: { 0: "both directions", 1: "one direction, that of the contour" },
  },
  offsetWidth: {
    prompt: "Offset width?",
    printed,
    label: "Offset width",
    explanation:
      "Shortens each pass from the second infeed on, which reduces the lateral load on the insert. 0: 0.1 mm per " +
      "pass. The residual material on the walls is removed at the end of roughing. The sum per side may reach 80 " +
      "% of the effective width.",
  },
  depthCompensation: {
    prompt: "Finishing depth compensation?",
    printed,
    label: "Depth compensation",
    explanation:
      "Shifts the floor of the finishing cut to compensate for the tilt of the insert during lateral turning: a " +
      "positive value makes the recess shallower, a negative value deeper.",
  },
  ...turning,
  ...recessing,
  ...threads,
  ...special,
} satisfies ParamsTexts;
