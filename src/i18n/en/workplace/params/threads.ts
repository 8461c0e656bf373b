import type { SomeParamTexts } from "../../../param-text.ts";

const printed = false;

export const threads = {
  clearanceRunIn: {
    prompt: "Set-up clearance?",
    printed,
    label: "Set-up clearance",
    explanation:
      "Distance kept when the tool lifts between the passes. In this cycle it is the run-in too: so far in " +
      "front of the start each pass begins.",
  },
  threadPosition: {
    prompt: "Thread position (0=ext./1=int.)?",
    printed,
    label: "Position",
    explanation:
      "Whether the thread is cut outside or inside. The nominal diameter is the crest outside and the root " +
      "inside. Our reading; verify on your control.",
    choices: { 0: "external thread", 1: "internal thread" },
  },
  threadOrientation: {
    prompt: "Thread orientation (0=long./1=transv.)?",
    printed,
    label: "Orientation",
    explanation: "Which axis is locked to the spindle: the pitch is measured along it.",
    choices: { 0: "along the axis", 1: "across the axis, in a face" },
  },
  threadDiameter: {
    prompt: "Thread diameter?",
    printed,
    label: "Thread ⌀",
    explanation:
      "Nominal diameter: the crest of an external thread, the root of an internal one. Our reading; verify on your control.",
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
      "Way of the tool in one turn of the spindle. With several starts that is the lead; from groove to groove " +
      "it is the part of it that each start has. Our reading; verify on your control.",
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
      "Way at the end of the thread over which the tool rises from the depth to the crest. 0: it leaves behind " +
      "the overrun, at full depth.",
  },
  threadRunIn: {
    prompt: "Starting path?",
    printed,
    label: "Run-in",
    explanation: "Way in front of the thread on which the axis gets up to the feed.",
  },
  threadOverrun: {
    prompt: "Overrun path?",
    printed,
    label: "Overrun",
    explanation:
      "Way behind the thread on which the axis comes to rest. Without a run-out it is cut at full depth: there has to be an undercut.",
  },
  taperForm: {
    prompt: "Dimension type of taper (0-4)?",
    printed,
    label: "Taper given by",
    explanation:
      "Which values describe the line of the thread. The angle of Q469 opens from a parallel to the axis in " +
      "cutting direction. Our reading; verify on your control.",
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
      "Angle between the line of the thread and the axis, positive where the diameter grows in cutting " +
      "direction. Not used with Q464 = 0.",
  },
  firstInfeed: {
    prompt: "Maximum cutting depth?",
    printed,
    label: "First infeed",
    explanation:
      "Depth of the first cut, on the radius. With a constant chip cross-section each further infeed is " +
      "smaller, but never less than a twentieth of the first.",
  },
  infeedAngle: {
    prompt: "Angle of infeed?",
    printed,
    label: "Infeed angle",
    explanation:
      "Direction of the infeed against the perpendicular to the thread: with the depth the tool moves sideways " +
      "too, so that mostly the leading flank cuts. At most half the point angle of the insert.",
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
    explanation: "Angle of the spindle at which the thread begins: it turns the thread round the axis.",
  },
  threadStarts: {
    prompt: "Number of threads?",
    printed,
    label: "Starts",
    explanation:
      "Number of grooves that run beside each other; each begins 360° divided by this number after the one before.",
  },
  airCuts: {
    prompt: "Number of air cuts?",
    printed,
    label: "Air cuts",
    explanation: "Passes at the finished depth without infeed, for each start.",
  },
} satisfies SomeParamTexts;
