import type { Sentences } from "../../../message-texts.ts";

const RULES = {
  signOfAngle: (word: string) =>
    `The signs of the angle and of DR differ (${word}): the control refuses the arc. Give both the same sign.`,
  zeroBehindCorner: (word: string) =>
    `This block behind ${word} moves nowhere: the control can not round or break a corner with an element of length 0.`,
  emptyCentre: (word: string) =>
    `${word} without coordinates takes the last point, and the block before names one axis ` +
    `only: program both coordinates in it or in ${word}.`,
  sideOnArc: (word: string) =>
    `Radius compensation can not begin on an arc (${word}): program RL or RR in a straight block before it.`,
  toolCallCompensated: (word: string) =>
    `${word} is active at this TOOL CALL: the control refuses it. Program R0 before.`,
};

/** What holds while a program runs: spindle, speeds, holes, and the printed rules of the control. */
export const running = {
  spindleStopped: ({ how, block }) => {
    const by = block === undefined ? "" : ` in block ${block}`;
    return {
      stopped:
        block === undefined
          ? "The spindle does not turn here: no M3, M4, M303 or M304 has started it."
          : `The spindle does not turn here: block ${block} stopped it. Start it with M3, M4, M303 or M304 before this cut.`,
      noSpeed: "The spindle has no speed here: program FUNCTION TURNDATA SPIN before this cut.",
      hand: `The spindle turns the wrong way round for this tool: its direction is set${by}. Program the other one.`,
    }[how];
  },
  holeMissing: ({ tool, diameter, z }, w) =>
    `Tool ${tool} feeds to Z${w.signed(z)} where there is no hole: drill ${w.diameter(diameter)} or more first.`,
  speedUnlimited: ({ diameter, block }, w) =>
    `Constant surface speed has no SMAX, and block ${block} comes to ${w.diameter(
      diameter,
    )}: the speed rises without limit there. Program SMAX.`,
  speedUnlikely: ({ speed, most, of }, w) =>
    of === "material"
      ? `A surface speed of ${w.number(speed)} m/min is more than turned materials allow (${w.number(most)} m/min).`
      : `${w.number(speed)} rpm is more than the spindle of the machine does (${w.number(most)} rpm).`,
  offCentre: ({ y }, w) =>
    `The tool turns ${w.length(y)} in Y beside the centre: what it cuts there is not proved. Program Y+0 and take the shift in Y back.`,
  toolIndexUnknown: ({ tool, rows }, w) =>
    `Tool ${w.text(tool)} is not in the table: ${
      rows.length > 0 ? `of this tool it has ${rows.join(", ")}` : "it has no row of this tool"
    }.`,
  firstElement: ({ word }, w) =>
    `A contour can not begin with ${w.text(word)}: the control knows no point before it. Begin with a straight block that names X and Z.`,
  controlRule: ({ rule, word }, w) => RULES[rule](w.text(word)),
} satisfies Partial<Sentences>;
