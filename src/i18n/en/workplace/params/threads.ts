import type { SomeParamTexts } from "../../../param-text.ts";

const printed = false;

export const threads = {
  clearanceRunIn: {
    prompt: "Set-up clearance?",
    printed,
    label: "Set-up clearance",
    explanation:
      "Lift-off distance between passes. In this cycle also the run-in: each pass begins at this distance in " +
      "front of the start.",
  },
  threadPosition: {
    prompt: "Thread position (0=ext./1=int.)?",
    printed,
    label: "Position",
    explanation:
      "Whether the thread is cut outside or inside. The nominal diameter is the crest outside and the root " +
      "inside.",
    choices: { 0: "external thread", 1: "internal thread" },
  },
  threadOrientation: {
    prompt: "Thread orientation (0=long./1=transv.)?",
    printed,
    label: "Orientation",
    explanation: "Axis that is synchronized to the spindle: the pitch is measured along this axis.",
    choices: { 0: "along the axis", 1: "across the axis, in a face" },
  },
  threadDiameter: {
    prompt: "Thread diameter?",
    printed,
    label: "Thread ⌀",
    explanation: "Nominal diameter: the crest of an external thread, the root of an internal one.",
  },
  threadStartDiameter: {
    prompt: "Diameter at thread start?",
    printed,
    label: "Start ⌀",
    explanation: "Nominal diameter where the thread starts. With Q464 = 2 it follows from the end and the angle.",
  },
  threadEndDiameter: {
    prompt: "Diameter at thread end?",
    printed,
    label: "End ⌀",
    explanation: "Nominal diameter where the thread ends. With Q464 = 4 it follows from the start and the angle.",
  },
  threadPitch: {
    prompt: "Thread pitch?",
    printed,
    label: "Pitch",
    explanation:
      "Tool travel per spindle revolution. With several starts this is the lead; the distance from thread to " +
      "thread is the lead divided by the number of starts.",
  },
  threadDepth: {
    prompt: "Thread depth?",
    printed,
    label: "Depth",
    explanation:
      "Depth on the radius. 0: from the pitch, as for a metric ISO thread (outside 0.6134, inside 0.5413 × the pitch).",
  },
  threadRunOut: {
    prompt: "Run-out length?",
    printed,
    label: "Run-out",
    explanation:
      "Distance at the end of the thread over which the tool rises from full depth to the crest. 0: the tool " +
      "retracts after the overrun, from full depth.",
  },
  threadRunIn: {
    prompt: "Starting path?",
    printed,
    label: "Run-in",
    explanation: "Distance in front of the thread in which the axis accelerates to the feed.",
  },
  threadOverrun: {
    prompt: "Overrun path?",
    printed,
    label: "Overrun",
    explanation:
      "Distance behind the thread in which the axis decelerates. Without a run-out it is traversed at full " +
      "depth: an undercut is required.",
  },
  taperForm: {
    prompt: "Dimension type of taper (0-4)?",
    printed,
    label: "Taper given by",
    explanation:
      "Values that define the line of the thread. The angle Q469 is measured from a parallel to the axis in " +
      "cutting direction.",
    choices: {
      0: "start and end point",
      1: "end point, start diameter, angle",
      2: "end point, start Z, angle",
      3: "start point, end diameter, angle",
      4: "start point, end Z, angle",
    },
  },
  taperAngle: {
    prompt: "Taper angle?",
    printed,
    label: "Taper angle",
    explanation:
      "Angle between the line of the thread and the axis, positive if the diameter increases in cutting " +
      "direction. Not used with Q464 = 0.",
  },
  firstInfeed: {
    prompt: "Maximum cutting depth?",
    printed,
    label: "First infeed",
    explanation:
      "Depth of the first cut, on the radius. With a constant chip cross-section each following infeed is " +
      "smaller, but never less than one twentieth of the first.",
  },
  infeedAngle: {
    prompt: "Angle of infeed?",
    printed,
    label: "Infeed angle",
    explanation:
      "Direction of the infeed relative to the perpendicular to the thread: the tool also moves laterally, so " +
      "mostly the leading flank cuts. At most half the point angle of the insert.",
  },
  infeedType: {
    prompt: "Type of infeed (0/1)?",
    printed,
    label: "Infeed type",
    explanation: "How the depth is divided into passes.",
    choices: { 0: "constant chip cross-section", 1: "constant depth" },
  },
  startingAngle: {
    prompt: "Starting angle?",
    printed,
    label: "Starting angle",
    explanation: "Spindle angle at which the thread begins: it rotates the thread about the axis.",
  },
  threadStarts: {
    prompt: "Number of threads?",
    printed,
    label: "Starts",
    explanation: "Number of thread starts; each begins 360° divided by this number after the previous one.",
  },
  airCuts: {
    prompt: "Number of air cuts?",
    printed,
    label: "Air cuts",
    explanation: "Passes at the final depth without infeed, for each start.",
  },
} satisfies SomeParamTexts;
