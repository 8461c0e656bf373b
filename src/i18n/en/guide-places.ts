import type { Shape } from "../shape.ts";

/**
 * Pages of the guide for prompts that are no parameter of a cycle. Each has what it is, and what is often done wrong
 * with it.
 */
export const guidePlaces = {
  other: "Other prompts",
  setup: "Set-up",
  approach: "Approach and departure",
  contour: "Contour",
  ownCycles: "Your cycles",
  runWith: "The kernel has run the cycle with each of these.",
  places: {
    "blank.outside": {
      about:
        "The ⌀ of the raw bar: D in BLK FORM CYLINDER. The proof takes the material off it; the machine never sees it.",
      mistakes: [
        "The finished ⌀ is entered: the picture shows no material where the machine has some, and a rapid that hits it is not found.",
        "Bar and casting are thicker than their nominal size: the tolerance belongs into it.",
      ],
    },
    "blank.bore": {
      about: "⌀ of a hole that is there before turning: DI in BLK FORM CYLINDER. Inside cycles begin from it.",
      mistakes: [
        "0 stays although a hole was drilled: the proof then finds the bar in full material.",
        "The hole is narrower than tool and shank together: they touch on the way in.",
      ],
    },
    "blank.length": {
      about: "Whole length of the blank: L in BLK FORM CYLINDER, with the piece that the chuck holds.",
      mistakes: [
        "Only the free length is entered: the jaws stand where the tool has to go.",
        "The length for parting off is forgotten.",
      ],
    },
    "blank.allowance": {
      about:
        "How far the face of the blank stands in front of the workpiece zero: DIST. Z0 usually is the finished face.",
      mistakes: [
        "0 although the face is still rough: in front of Z0 the tool meets material at rapid.",
        "A minus sign: the blank begins behind Z0, and the first passes cut air.",
      ],
    },
    tool: {
      about:
        "TOOL CALL takes an insert with its nose radius and its orientation TO out of the table. The same values with another insert make " +
        "another part: the nose stays in corners, the edges limit flanks.",
      mistakes: [
        "Tool number and place in the turret are mixed up: another insert cuts.",
        "An outside tool is called for an inside contour: its orientation does not fit.",
      ],
    },
    "start.x": {
      about:
        "Where the tip stands across when the cycle is called, as ⌀. Cycles without a start diameter begin their contour here; " +
        "all come from here and go back here.",
      mistakes: [
        "It lies inside the blank: the first rapid goes through material.",
        "A radius is typed: the tool stands at half the distance from the axis.",
      ],
    },
    "start.z": {
      about:
        "Where the tip stands along the axis when the cycle is called: in front of the material, on the side from which the cycle works.",
      mistakes: [
        "It lies behind a collar: the way to the first pass goes through it.",
        "The side is wrong: a cycle that cuts towards the chuck has to be called from the right.",
      ],
    },
    "spindle.cuttingSpeed": {
      about:
        "VC in m/min: the control changes the speed with the ⌀, n = 1000 · vc / (π · d). The path stays as it is; time, heat and surface " +
        "change.",
      mistakes: [
        "There is no SMAX beside it: towards the axis the spindle turns as fast as it can.",
        "Revolutions are entered: 1500 m/min is far too fast for steel.",
      ],
    },
    "spindle.speed": {
      about:
        "S in revolutions a minute, the same at every ⌀: right for threads. Towards the axis the cutting speed falls to nothing.",
      mistakes: [
        "It is left from a thin part: on a large ⌀ the edge runs too fast.",
        "It is used for facing: towards the centre the surface gets worse.",
      ],
    },
    "spindle.limit": {
      about:
        "SMAX in revolutions a minute: constant cutting speed never turns the spindle faster. Chuck, clamping and imbalance decide it, " +
        "not the insert.",
      mistakes: [
        "The limit of the chuck is overlooked: jaws lose their grip as the speed grows.",
        "It is so low that the cutting speed is held on the largest ⌀ only.",
      ],
    },
    perRevolution: {
      about: "With M136 feeds count in mm a turn, without it in mm a minute.",
      mistakes: [
        "M136 is missing: 0.3 then means 0.3 mm a minute, and the tool seems to stand still.",
        "A feed a minute is left in a prompt: 200 mm a turn.",
      ],
    },
    rapid: {
      about: "How fast the machine goes at rapid. Only the estimated time depends on it; the program does not hold it.",
      mistakes: ["It is taken for a feed: it never cuts.", "Times of two machines are compared with the rapid of one."],
    },
  },
  on: "on",
  off: "off",
  form: {
    points: "Its points",
    of: {
      PS: "Programmed right before APPR, with R0.",
      PH: "Worked out by the control from form and values.",
      PA: "Stands in the APPR block.",
      PE: "Stands in the last block of the contour.",
      PN: "Outside: DEP LCT names it, the others work it out.",
    },
    polar: "The point is given from the pole CC: by the distance PR and the angle PA.",
    ownLead: "Drawn at the contour of your block.",
    sampleLead: "Drawn at a corner, with a tool of 8 mm radius.",
    way: "Way",
    danger: "Why PS→PH is dangerous",
    dangers: [
      "From PS to PH the control does not check whether the contour is damaged.",
      "With LT, LN and CT this way runs at the feed programmed last: behind FMAX at rapid. With LCT it runs at the feed of its block.",
      "Put PS on the side from which the contour begins, so that the straight line to PH is free. The app checks this line.",
    ],
    leaving: "Behind PN the next block goes its own way: PN has to be clear of part and chuck.",
    mistakes: {
      all: "RL and RR are exchanged: the tool cuts its own width into the part.",
      LT: "The element is not free where it is lengthened: the straight piece goes through a shoulder.",
      LN: "The tool turns by 90° at the contour and stops for a moment: it leaves a mark on a finished face.",
      CT: "The block has R0: an arc needs RL or RR. A minus in front of R puts the arc on the side of the workpiece.",
      LCT: "The point outside lies within the circle of R: there is no tangent.",
    },
    others: "The other forms",
  },
  elements: {
    lead: "The contour stands behind the main program, under a label that CYCL DEF 14 names. Its direction decides from where it is cut.",
    title: "Its elements",
    of: {
      L: "Straight to its end point. A coordinate that is missing stays as it was.",
      RND: "Rounds the corner between the elements before and behind it.",
      CHF: "Cuts the corner off, by the same length on both sides.",
      CR: "Arc to its end point with a radius; a minus takes the longer way.",
      CC: "Centre of the next C, and pole of the polar elements.",
      C: "Arc about CC to its end point, in the direction DR.",
      CT: "Arc to its end point that goes on from the element before without a corner.",
      LP: "Straight to a point that distance and angle from CC give.",
      CP: "Arc about CC up to an angle.",
      CTP: "Arc without a corner to a point given from CC.",
      UDC: "Undercut of a standard form between two elements.",
      GRV: "Recess in the middle of a straight element.",
    },
    mistakes: [
      "The first line is taken for an element: it is the start point only.",
      "X is typed as a radius; it is a ⌀.",
      "RND or CHF stands first or last: there is no corner.",
      "A rounding is longer than the elements beside it.",
      "The contour goes on into the chuck.",
    ],
  },
};

export type GuidePlacesTexts = Shape<typeof guidePlaces>;
