import type { Shape } from "../shape.ts";

/** Pages of the guide for prompts other than cycle parameters: what each prompt is, and common mistakes. */
export const guidePlaces = {
  other: "Other prompts",
  setup: "Set-up",
  approach: "Approach and departure",
  contour: "Contour",
  ownCycles: "Your cycles",
  runWith: "The cycle simulated with each of these.",
  places: {
    "blank.outside": {
      about:
        "⌀ of the blank: D in BLK FORM CYLINDER. The simulation removes material from it; the machine does not use it.",
      mistakes: [
        "The finished ⌀ is entered: the simulation lacks material that is on the machine, and rapid traverse " +
          "into it is not detected.",
        "Bars and castings are larger than their nominal size: add the tolerance.",
      ],
    },
    "blank.bore": {
      about: "⌀ of an existing bore before turning: DI in BLK FORM CYLINDER. Inside cycles start from this bore.",
      mistakes: [
        "0 is kept although a hole was drilled: the check then finds the boring bar in solid material.",
        "The bore is narrower than tool and shank: they touch when entering.",
      ],
    },
    "blank.length": {
      about: "Total length of the blank: L in BLK FORM CYLINDER, including the clamped length.",
      mistakes: [
        "Only the free length is entered: the jaws are in the way of the tool.",
        "The length for parting off is missing.",
      ],
    },
    "blank.allowance": {
      about: "Stock on the face in front of the workpiece zero: DIST. Z0 is usually the finished face.",
      mistakes: [
        "0 although the face is unmachined: in front of Z0 the tool hits material at rapid traverse.",
        "A negative value: the blank begins behind Z0, and the first passes cut air.",
      ],
    },
    tool: {
      about:
        "TOOL CALL selects an insert with its tool nose radius and orientation TO from the table. The same " +
        "values with another insert give another part: the nose radius remains in corners, the edges limit the " +
        "flanks.",
      mistakes: [
        "Tool number and turret position are confused: another insert cuts.",
        "An outside tool is called for an inside contour: its orientation does not fit.",
      ],
    },
    "start.x": {
      about:
        "X position of the tool tip at the cycle call, as ⌀. Cycles without a start diameter begin their contour " +
        "here; all cycles start from and return to this position.",
      mistakes: [
        "The position is inside the blank: the first rapid traverse goes through material.",
        "A radius is entered: the tool is at half the distance from the axis.",
      ],
    },
    "start.z": {
      about:
        "Z position of the tool tip at the cycle call: in front of the material, on the side from which the " +
        "cycle machines.",
      mistakes: [
        "The position is behind a collar: the move to the first pass goes through the collar.",
        "Wrong side: a cycle that cuts towards the chuck must be called from the right.",
      ],
    },
    "spindle.cuttingSpeed": {
      about:
        "VC in m/min: the control adapts the speed to the ⌀, n = 1000 · vc / (π · d). The path stays the same; " +
        "time, heat and surface change.",
      mistakes: [
        "SMAX is missing: towards the axis the spindle runs at its maximum speed.",
        "A spindle speed is entered: 1500 m/min is far too fast for steel.",
      ],
    },
    "spindle.speed": {
      about:
        "S in revolutions per minute, the same at every ⌀: required for threads. Towards the axis the cutting " +
        "speed falls to zero.",
      mistakes: [
        "Kept from a thin part: on a large ⌀ the cutting speed is too high.",
        "Used for facing: towards the centre the surface gets worse.",
      ],
    },
    "spindle.limit": {
      about:
        "SMAX in revolutions per minute: maximum spindle speed with constant cutting speed. Chuck, clamping and " +
        "unbalance determine it, not the insert.",
      mistakes: [
        "The limit of the chuck is ignored: jaws lose clamping force as the speed rises.",
        "Too low: the cutting speed is reached only on the largest ⌀.",
      ],
    },
    perRevolution: {
      about: "With M136 feeds are in mm per revolution, without it in mm per minute.",
      mistakes: [
        "M136 is missing: 0.3 then means 0.3 mm per minute, and the tool seems to stand still.",
        "A feed per minute is kept in a prompt: 200 mm per revolution.",
      ],
    },
    rapid: {
      about: "Rapid traverse rate of the machine. Used only for the estimated time; not part of the program.",
      mistakes: [
        "Confused with a feed: the tool never cuts at rapid traverse.",
        "Times of two machines are compared with the rate of one.",
      ],
    },
  },
  on: "on",
  off: "off",
  form: {
    points: "Points",
    of: {
      PS: "Programmed directly before APPR, with R0.",
      PH: "Calculated by the control from form and values.",
      PA: "Programmed in the APPR block.",
      PE: "Programmed in the last block of the contour.",
      PN: "Outside the contour: programmed with DEP LCT, calculated with the other forms.",
    },
    polar: "The point is defined from the pole CC by distance PR and angle PA.",
    ownLead: "Shown at the contour of your block.",
    sampleLead: "Shown at a corner, with a tool radius of 8 mm.",
    way: "Path",
    danger: "Why PS→PH is dangerous",
    dangers: [
      "From PS to PH the control does not check whether the contour is damaged.",
      "With LT, LN and CT this path runs at the last programmed feed: after FMAX at rapid traverse. With LCT it " +
        "runs at the feed of the APPR block.",
      "Place PS on the side where the contour begins, so that the straight line to PH is clear. The app checks " +
        "this line.",
    ],
    leaving: "After PN the next block is executed: PN must be clear of part and chuck.",
    mistakes: {
      all: "RL and RR are swapped: the tool cuts its own width into the part.",
      LT: "The extension of the element is not clear: the straight line goes through a shoulder.",
      LN: "The tool changes direction by 90° at the contour and stops briefly: it leaves a mark on a finished face.",
      CT: "The block has R0: an arc requires RL or RR. A negative R places the arc on the side of the workpiece.",
      LCT: "The outside point is inside the circle of R: no tangent is possible.",
    },
    others: "Other forms",
  },
  elements: {
    lead:
      "The contour is a subprogram after the main program, under the label selected by CYCL DEF 14. The direction " +
      "of the contour determines the machining direction.",
    title: "Elements",
    of: {
      L: "Straight line to the end point. A missing coordinate stays unchanged.",
      RND: "Rounds the corner between the previous and the next element.",
      CHF: "Chamfers the corner, with the same length on both sides.",
      CR: "Arc to the end point with a radius; a negative radius gives the larger arc.",
      CC: "Centre of the next C, and pole of the polar elements.",
      C: "Arc about CC to the end point, in direction DR.",
      CT: "Arc to the end point, tangential to the previous element.",
      LP: "Straight line to a point defined by distance and angle from CC.",
      CP: "Arc about CC up to an angle.",
      CTP: "Tangential arc to a point defined from CC.",
      UDC: "Undercut of standard form between two elements.",
      GRV: "Recess in the middle of a straight element.",
    },
    mistakes: [
      "The first line is taken for an element: it is only the start point.",
      "X is entered as a radius; it is a ⌀.",
      "RND or CHF is first or last: there is no corner.",
      "A rounding is too large for the adjacent elements.",
      "The contour extends into the chuck.",
    ],
  },
};

export type GuidePlacesTexts = Shape<typeof guidePlaces>;
