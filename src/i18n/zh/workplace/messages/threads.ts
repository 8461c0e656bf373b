import type { MessagesTexts } from "../../../message-texts.ts";
import type { Write } from "../../../write.ts";

/** The value that a finding proposes, if any. */
const nearest = (value: number | undefined, say: (value: number) => string) =>
  value === undefined ? "" : `建议：${say(value)}。`;

const ALL_ALONG = "常用的导入行程都无法避开：请从自由端开始螺纹，或先在该处车退刀槽。";
/** A position on the synchronized axis of a thread: Z, or a diameter in a face. */
const placeOn = (axis: "X" | "Z", value: number, w: Write): string =>
  axis === "X" ? `X${w.diameter(value)}` : `Z${w.signed(value)}`;

export const threads = {
  pitchZero: () => "螺纹需要大于0的螺距。",
  depthFromPitch: (d, w) =>
    `按螺距计算的深度（ISO米制牙型）：${w.number(d.factor)} × ${w.size(d.pitch)} = ${w.length(d.depth)}（半径值）。`,
  depthOfOtherProfile: (d, w) =>
    `Q473 = 0采用米制牙型的深度：${w.number(d.factor)} × ${w.size(d.pitch)} = ${w.length(d.depth)}。该系数属于60°，此刀片为${w.angle(
      d.angle,
    )}。${d.right === undefined ? (d.nearest === undefined ? "请输入其牙型的深度。" : "梯形螺纹（30°）：螺距的一半加牙顶间隙。") : `惠氏牙型（55°）：${w.number(d.right)} × 螺距。`}${nearest(d.nearest, w.size)}`,
  toothAssumed: (d, w) =>
    `螺纹刀的CUTLENGTH为空：按牙高${w.length(d.height)}计算。请输入牙高，以便用实际刀片检查螺纹旁的台阶。`,
  threadOverInsert: (d, w) =>
    `深度${w.length(d.depth)}超过刀片牙高${w.length(d.most)}。请选用牙更高的螺纹刀（CUTLENGTH）。`,
  threadTooSteep: (d, w) =>
    `螺纹以${w.angle(d.angle)}上升：刀片的齿侧要求小于${w.angle(d.most)}。请输入较平的锥度或更换螺纹轴。`,
  threadMeets: (d, w) =>
    `${d.place === "over" ? "" : `${d.place === "before" ? "导入段" : "越程段"}内刀具会碰到材料。`}在${w.place(
      d.x,
      d.z,
    )}，材料高出螺纹牙顶${w.length(d.over)}${
      d.most === undefined
        ? d.place === "over"
          ? "：第一刀也切除该材料，牙槽之间的保留。"
          : "。"
        : `；刀片只能容纳${w.length(d.most)}。`
    }`,
  flankInfeedTooSteep: (d, w) =>
    `角度${w.angle(d.angle)}使各刀损伤成品牙侧：最多为刀尖角的一半${w.angle(d.most)}。${nearest(d.nearest, w.angle)}`,
  runOutTooLong: (d, w) => `退尾长度${w.size(d.size)}大于螺纹长度：最多${w.size(d.max)}。${nearest(d.nearest, w.size)}`,
  threadTurnsBack: (d) => `螺纹必须从起点到终点沿${d.axis}单向前进：该轴与主轴同步。`,
  runInBlocked: (d, w) =>
    `在导入段起点${w.place(d.x, d.z)}，刀具会位于材料中。${d.nearest === undefined ? ALL_ALONG : nearest(d.nearest, w.size)}`,
  threadSurfaceSpeed: (d, w) =>
    `以恒线速度（VCONST:ON，${w.number(d.cuttingSpeed)} m/min）加工螺纹：转速随直径变化${
      d.slow === undefined || d.fast === undefined ? "" : `，从${w.number(d.slow)}到${w.number(d.fast)}转/分`
    }，各刀可能不在同一牙槽中。请编程VCONST:OFF和S。`,
  threadOverruns: (d, w) =>
    `螺纹在${placeOn(d.axis, d.end, w)}结束，越程到${placeOn(d.axis, d.to, w)}；${
      d.meets === "shaft" ? "轮廓损伤" : "刀片侧刃碰到台阶，轮廓损伤"
    }${w.area(d.area)}，位于${w.place(d.x, d.z)}。请提前结束螺纹（Q494）、编程退尾（Q474）或先车足够宽的退刀槽（DIN 76）。`,
  crestMissing: (d, w) =>
    `螺纹牙顶缺少${w.length(d.missing)}：材料不足。正确的尺寸为${"diameter" in d ? w.diameter(d.diameter) : `Z${w.signed(d.z)}`}。`,
  threadTooMany: (d, w) => `所有走刀共${w.number(d.turns)}转主轴，超过最大值${w.number(d.most)}。`,
  taperImpossible: (d, w) => `角度${w.angle(d.angle)}无法从螺纹起点到达终点。`,
  threadFeedOverLimit: (d, w) =>
    `转速${w.number(d.speed)} × 螺距的进给为${w.feed(d.feed, "mm/min")}，超过轴的最大进给${w.feed(d.most, "mm/min")}。最高转速${w.number(d.upTo)} 转/分。`,
  runInShort: (d, w) =>
    `转速${w.number(d.speed)} 转/分时，导入段${w.size(d.runIn)}太短，达不到进给速率。经验法则：转速 × 螺距 / 400 = ${w.length(d.needed)}。${nearest(d.nearest, w.size)}`,
} satisfies Partial<MessagesTexts["of"]>;
