import type { MessagesTexts } from "../../../message-texts.ts";
import type { Write } from "../../../write.ts";

/** What a finding offers, where it offers something. */
const nearest = (value: number | undefined, say: (value: number) => string) =>
  value === undefined ? "" : ` Nearest value that works: ${say(value)}.`;

const ALL_ALONG = " No usual run-in leads past it: start the thread at its free end, or turn a relief there first.";
/** A place on the axis that a thread runs along: a Z, or in a face a diameter. */
const placeOn = (axis: "X" | "Z", value: number, w: Write): string =>
  axis === "X" ? `X${w.diameter(value)}` : `Z${w.signed(value)}`;

export const threads = {
  pitchZero: () => "A thread needs a pitch greater than 0.",
  depthFromPitch: (d, w) =>
    `Depth from the pitch, metric ISO profile: ${w.number(d.factor)} × ${w.size(d.pitch)} = ${w.length(d.depth)} on the radius.`,
  depthOfOtherProfile: (d, w) =>
    `Q473 = 0 takes the depth of the metric profile: ${w.number(d.factor)} × ${w.size(d.pitch)} = ${w.length(
      d.depth,
    )}. That factor belongs to ` +
    `60°; this insert has ${w.angle(d.angle)}. ${
      d.right === undefined ? "Enter the depth of its profile." : `Whitworth (55°): ${w.number(d.right)} × the pitch.`
    }${nearest(d.nearest, w.size)}`,
  toothAssumed: (d, w) =>
    `CUTLENGTH of the thread tool is empty: the tooth is taken to be ${w.length(
      d.height,
    )} high. Enter its height, so that shoulders beside the ` + "thread are checked with the real insert.",
  threadOverInsert: (d, w) =>
    `${w.length(d.depth)} are deeper than the insert is high: ${w.length(d.most)}. Take a thread tool with a higher tooth (CUTLENGTH).`,
  threadMeets: (d, w) =>
    `${d.place === "over" ? "" : `In the ${d.place === "before" ? "run-in" : "overrun"} the tool runs into material. `}At ${w.place(
      d.x,
      d.z,
    )}, ${w.length(d.over)} of material stand over the crest of the thread${
      d.most === undefined
        ? d.place === "over"
          ? ": the first pass takes them as well, and between the grooves they stay."
          : "."
        : `; the insert has room for ${w.size(d.most)}.`
    }`,
  flankInfeedTooSteep: (d, w) =>
    `With ${w.angle(d.angle)} the passes cut into the finished flank: at most half the point angle, ${w.angle(d.most)}.${nearest(
      d.nearest,
      w.angle,
    )}`,
  runOutTooLong: (d, w) =>
    `The run-out of ${w.size(d.size)} is longer than the thread: at most ${w.size(d.max)}.${nearest(d.nearest, w.size)}`,
  threadTurnsBack: (d) =>
    `The thread has to run on along ${d.axis} from start to end: that axis is locked to the spindle.`,
  runInBlocked: (d, w) =>
    `Where the run-in begins, at ${w.place(d.x, d.z)}, the tool would stand in material.${
      d.nearest === undefined ? ALL_ALONG : nearest(d.nearest, w.size)
    }`,
  threadSurfaceSpeed: (d, w) =>
    `Thread at a constant surface speed (VCONST:ON, ${w.number(d.cuttingSpeed)} m/min): the speed follows the diameter${
      d.slow === undefined || d.fast === undefined ? "" : `, from ${w.number(d.slow)} to ${w.number(d.fast)} rpm`
    }, and the passes may not meet the same groove. Program VCONST:OFF with S.`,
  threadOverruns: (d, w) =>
    `The thread ends at ${placeOn(d.axis, d.end, w)} and overruns to ${placeOn(d.axis, d.to, w)}; ${
      d.meets === "shaft" ? "there it cuts" : "there a flank of the insert meets the shoulder, which loses"
    } ${w.area(d.area)} of the finished part, at ${w.place(
      d.x,
      d.z,
    )}. End the thread earlier (Q494), lift along a run-out (Q474), or turn a relief (DIN 76) that is wide enough.`,
  crestMissing: (d, w) =>
    `The crest of the thread is missing by ${w.length(d.missing)}: there is not enough material. Right would be ${
      "diameter" in d ? w.diameter(d.diameter) : `Z${w.signed(d.z)}`
    }.`,
  threadTooMany: (d, w) => `${w.number(d.turns)} turns of the spindle in all passes are more than ${w.number(d.most)}.`,
  taperImpossible: (d, w) => `An angle of ${w.angle(d.angle)} leads from the start of the thread to no end.`,
  threadFeedOverLimit: (d, w) =>
    `Speed ${w.number(d.speed)} × pitch is a feed of ${w.number(d.feed)} mm/min, more than the axis can: ${w.number(d.most)}. Up to ` +
    `${w.number(d.upTo)} rpm it can follow.`,
  runInShort: (d, w) =>
    `At ${w.number(d.speed)} rpm the run-in of ${w.size(d.runIn)} is too short to reach the feed: speed × pitch / 400 gives ` +
    `${w.length(d.needed)}. Our rule of thumb.${nearest(d.nearest, w.size)}`,
} satisfies Partial<MessagesTexts["of"]>;
