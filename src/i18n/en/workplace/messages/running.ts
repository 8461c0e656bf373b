import type { Sentences } from "../../../message-texts.ts";

const RULES = {
  signOfAngle: (word: string) =>
    `The angle and DR have different signs (${word}): the control rejects the arc. Use the same sign for both.`,
  zeroBehindCorner: (word: string) =>
    `This block after ${word} has length 0: the control cannot round or chamfer a corner with it.`,
  emptyCentre: (word: string) =>
    `${word} without coordinates uses the last point, but the previous block has only one axis: program both coordinates there or in ${word}.`,
  sideOnArc: (word: string) =>
    `Radius compensation cannot begin on an arc (${word}): program RL or RR in a straight block before it.`,
  toolCallCompensated: (word: string) =>
    `${word} is active at this TOOL CALL: the control rejects the block. Program R0 before it.`,
};

/** Messages about a running program: spindle, speeds, holes, and the printed rules of the control. */
export const running = {
  spindleStopped: ({ how, block }) => {
    const by = block === undefined ? "" : ` in block ${block}`;
    return {
      stopped:
        block === undefined
          ? "The spindle is stopped here: M3, M4, M303 or M304 is missing."
          : `The spindle is stopped here, by block ${block}. Program M3, M4, M303 or M304 before this cut.`,
      noSpeed: "The spindle has no speed here: program FUNCTION TURNDATA SPIN before this cut.",
      hand: `Wrong spindle direction for this tool, set${by}. Program the opposite direction.`,
    }[how];
  },
  toolLimit: ({ tool, column, value, limit, x, z }, w) =>
    ({
      DAXN: `Tool ${tool} cuts an axial groove of ${w.diameter(value)}; the blade is made for ${w.diameter(limit)} or more (DAXN) and rubs on the outer wall.`,
      DAXX: `Tool ${tool} cuts an axial groove of ${w.diameter(value)}; the blade is made for up to ${w.diameter(limit)} (DAXX) and rubs on the inner wall.`,
      CDX: `Tool ${tool} is ${w.length(value)} deep in the material at ${w.place(x, z)}; its cutting depth is ${w.length(limit)} (CDX).`,
      CUTDIA: `Tool ${tool} parts off ${w.diameter(value)}; it is made for up to ${w.diameter(limit)} (CUTDIA).`,
      DMIN: `Tool ${tool} is in a bore of ${w.diameter(value)} at ${w.place(x, z)}; it needs ${w.diameter(limit)} (DMIN).`,
    })[column],
  holeMissing: ({ tool, diameter, z }, w) =>
    `Tool ${tool} feeds to Z${w.signed(z)}, where there is no hole: first drill ${w.diameter(diameter)} or more.`,
  speedUnlimited: ({ diameter, block }, w) =>
    `Constant surface speed without SMAX, and block ${block} reaches ${w.diameter(
      diameter,
    )}: spindle speed is unlimited there. Program SMAX.`,
  speedUnlikely: ({ speed, most, of }, w) =>
    of === "material"
      ? `Surface speed ${w.number(speed)} m/min exceeds the maximum for turning materials (${w.number(most)} m/min).`
      : `${w.number(speed)} rpm exceeds the maximum spindle speed of the machine (${w.number(most)} rpm).`,
  offCentre: ({ y }, w) =>
    `The tool is ${w.length(y)} off centre in Y: the cut is unverified. Program Y+0 and cancel the shift in Y.`,
  toolIndexUnknown: ({ tool, rows }, w) =>
    `Tool ${w.text(tool)} is not in the table: ${
      rows.length > 0 ? `of this tool, only ${rows.join(", ")}` : "no row of this tool"
    }.`,
  firstElement: ({ word }, w) =>
    `A contour cannot begin with ${w.text(word)}: there is no previous point. Begin with a straight block with X and Z.`,
  controlRule: ({ rule, word }, w) => RULES[rule](w.text(word)),
} satisfies Partial<Sentences>;
