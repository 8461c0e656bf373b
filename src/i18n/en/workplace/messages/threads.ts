import type { MessagesTexts } from "../../../message-texts.ts";
import type { Write } from "../../../write.ts";

/** The value that a finding proposes, if any. */
const nearest = (value: number | undefined, say: (value: number) => string) =>
  value === undefined ? "" : ` Proposed: ${say(value)}.`;

const ALL_ALONG = " No usual run-in avoids it: start the thread at its free end, or turn an undercut there first.";
/** A position on the synchronized axis of a thread: Z, or a diameter in a face. */
const placeOn = (axis: "X" | "Z", value: number, w: Write): string =>
  axis === "X" ? `X${w.diameter(value)}` : `Z${w.signed(value)}`;

export const threads = {
  pitchZero: () => "A thread requires a pitch greater than 0.",
  depthFromPitch: (d, w) =>
    `Depth from the pitch, metric ISO profile: ${w.number(d.factor)} × ${w.size(d.pitch)} = ${w.length(d.depth)} on the radius.`,
  depthOfOtherProfile: (d, w) =>
    `Q473 = 0 uses the depth of the metric profile: ${w.number(d.factor)} × ${w.size(d.pitch)} = ${w.length(
      d.depth,
    )}. This factor applies to 60°; the insert has ${w.angle(d.angle)}. ${
      d.right === undefined
        ? d.nearest === undefined
          ? "Enter the thread depth of this profile."
          : "Trapezoidal thread (30°): half the pitch plus the crest clearance."
        : `Whitworth (55°): ${w.number(d.right)} × the pitch.`
    }${nearest(d.nearest, w.size)}`,
  toothAssumed: (d, w) =>
    `CUTLENGTH of the thread tool is empty: a tooth height of ${w.length(d.height)} is assumed. Enter the height to check shoulders next to the thread with the actual insert.`,
  threadOverInsert: (d, w) =>
    `Depth ${w.length(d.depth)} exceeds the tooth height ${w.length(d.most)}. Use a thread tool with a higher tooth (CUTLENGTH).`,
  threadTooSteep: (d, w) =>
    `The thread rises at ${w.angle(d.angle)}: the flanks of the insert allow less than ${w.angle(d.most)}. Enter a flatter cone or change the thread axis.`,
  threadMeets: (d, w) =>
    `${d.place === "over" ? "" : `In the ${d.place === "before" ? "run-in" : "overrun"} the tool runs into material. `}At ${w.place(
      d.x,
      d.z,
    )}, there are ${w.length(d.over)} of material above the thread crest${
      d.most === undefined
        ? d.place === "over"
          ? ": the first pass cuts this too; between the threads it remains."
          : "."
        : `; the insert has clearance for ${w.size(d.most)}.`
    }`,
  flankInfeedTooSteep: (d, w) =>
    `With ${w.angle(d.angle)} the passes damage the finished flank: max. half the point angle, ${w.angle(d.most)}.${nearest(
      d.nearest,
      w.angle,
    )}`,
  runOutTooLong: (d, w) =>
    `The run-out of ${w.size(d.size)} is longer than the thread: max. ${w.size(d.max)}.${nearest(d.nearest, w.size)}`,
  threadTurnsBack: (d) =>
    `The thread must run in one direction along ${d.axis} from start to end: this axis is synchronized to the spindle.`,
  runInBlocked: (d, w) =>
    `At the start of the run-in, ${w.place(d.x, d.z)}, the tool would be in the material.${
      d.nearest === undefined ? ALL_ALONG : nearest(d.nearest, w.size)
    }`,
  threadSurfaceSpeed: (d, w) =>
    `Thread at a constant surface speed (VCONST:ON, ${w.number(d.cuttingSpeed)} m/min): the speed follows the diameter${
      d.slow === undefined || d.fast === undefined ? "" : `, from ${w.number(d.slow)} to ${w.number(d.fast)} rpm`
    }, so the passes may not follow the same thread. Program VCONST:OFF with S.`,
  threadOverruns: (d, w) =>
    `The thread ends at ${placeOn(d.axis, d.end, w)} and overruns to ${placeOn(d.axis, d.to, w)}; ${
      d.meets === "shaft" ? "contour damage there:" : "the insert flank hits the shoulder, contour damage:"
    } ${w.area(d.area)} at ${w.place(d.x, d.z)}. End the thread earlier (Q494), use a run-out (Q474), or turn a wide enough undercut (DIN 76).`,
  crestMissing: (d, w) =>
    `The thread crest lacks ${w.length(d.missing)}: not enough material. Correct: ${
      "diameter" in d ? w.diameter(d.diameter) : `Z${w.signed(d.z)}`
    }.`,
  threadTooMany: (d, w) =>
    `${w.number(d.turns)} spindle revolutions in all passes exceed the maximum of ${w.number(d.most)}.`,
  taperImpossible: (d, w) => `With an angle of ${w.angle(d.angle)} the thread has no end point.`,
  threadFeedOverLimit: (d, w) =>
    `Speed ${w.number(d.speed)} × pitch = ${w.feed(d.feed, "mm/min")} exceeds the maximum axis feed ${w.feed(d.most, "mm/min")}. Max. ${w.number(d.upTo)} rpm.`,
  runInShort: (d, w) =>
    `At ${w.number(d.speed)} rpm the run-in of ${w.size(d.runIn)} is too short to reach the feed. Rule of thumb: speed × pitch / 400 = ${w.length(d.needed)}.${nearest(d.nearest, w.size)}`,
} satisfies Partial<MessagesTexts["of"]>;
