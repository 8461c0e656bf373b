import type { MessagesTexts } from "../../message-texts.ts";

/** What a finding offers, where it offers something. */
const nearest = (
  value: number | undefined,
  say: (value: number) => string,
) => (value === undefined ? "" : ` Nearest value that works: ${say(value)}.`);

export const threads = {
  pitchZero: () => "A thread needs a pitch greater than 0.",
  depthFromPitch: (d, w) =>
    `Depth from the pitch, metric ISO profile: ${w.number(d.factor)} × ${w.size(d.pitch)} = ${w.length(d.depth)} on the radius.`,
  threadOverInsert: (d, w) => `${w.length(d.depth)} are deeper than the insert is high: ${w.length(d.most)}.`,
  threadMeets: (d, w) =>
    `${d.place === "over" ? "" : `In the ${d.place === "before" ? "run-in" : "overrun"} the tool runs into material. `}At ${
      w.place(d.x, d.z)
    }, ${w.length(d.over)} of material stand over the crest of the thread${
      d.most === undefined
        ? d.place === "over" ? ": the first pass takes them as well, and between the grooves they stay." : "."
        : `; the insert has room for ${w.size(d.most)}.`
    }`,
  flankInfeedTooSteep: (d, w) =>
    `With ${w.angle(d.angle)} the passes cut into the finished flank: at most half the point angle, ${w.angle(d.most)}.${
      nearest(d.nearest, w.angle)
    }`,
  runOutTooLong: (d, w) =>
    `The run-out of ${w.size(d.size)} is longer than the thread: at most ${w.size(d.max)}.${nearest(d.nearest, w.size)}`,
  threadTurnsBack: (d) => `The thread has to run on along ${d.axis} from start to end: that axis is locked to the spindle.`,
  runInBlocked: (d, w) =>
    `Where the run-in begins, at ${w.place(d.x, d.z)}, the tool would stand in material.${nearest(d.nearest, w.size)}`,
  threadTooMany: (d, w) => `${w.number(d.turns)} turns of the spindle in all passes are more than ${w.number(d.most)}.`,
  taperImpossible: (d, w) => `An angle of ${w.angle(d.angle)} leads from the start of the thread to no end.`,
  threadFeedOverLimit: (d, w) =>
    `Speed ${w.number(d.speed)} × pitch is a feed of ${w.number(d.feed)} mm/min, more than the axis can: ${w.number(d.most)}. Up to `
    + `${w.number(d.upTo)} rpm it can follow.`,
  runInShort: (d, w) =>
    `At ${w.number(d.speed)} rpm the run-in of ${w.size(d.runIn)} is too short to reach the feed: speed × pitch / 400 gives `
    + `${w.length(d.needed)}. Our rule of thumb.${nearest(d.nearest, w.size)}`,
} satisfies Partial<MessagesTexts["of"]>;
