import type { MessagesTexts } from "../../message-texts.ts";

/** What a finding offers, where it offers something. */
const nearest = (
  value: number | undefined,
  say: (value: number) => string,
) => (value === undefined ? "" : `最接近的可用值：${say(value)}。`);

export const threads = {
  pitchZero: () => "螺纹需要大于0的螺距。",
  depthFromPitch: (d, w) =>
    `按螺距计算的深度（ISO米制牙型）：${w.number(d.factor)} × ${w.size(d.pitch)} = ${w.length(d.depth)}（半径值）。`,
  threadOverInsert: (d, w) => `${w.length(d.depth)}超过刀片高度${w.length(d.most)}。`,
  threadMeets: (d, w) =>
    `${d.place === "over" ? "" : `${d.place === "before" ? "导入段" : "越程段"}内刀具会碰到材料。`}在${
      w.place(d.x, d.z)
    }，材料高出螺纹牙顶${w.length(d.over)}${
      d.most === undefined ? d.place === "over" ? "：第一刀会一并切除，牙槽之间的则留下。" : "。" : `；刀片只能容纳${w.length(d.most)}。`
    }`,
  flankInfeedTooSteep: (d, w) =>
    `角度${w.angle(d.angle)}会使各刀切入成品牙侧：最多为刀尖角的一半${w.angle(d.most)}。${nearest(d.nearest, w.angle)}`,
  runOutTooLong: (d, w) => `退尾长度${w.size(d.size)}大于螺纹长度：最多${w.size(d.max)}。${nearest(d.nearest, w.size)}`,
  threadTurnsBack: (d) => `螺纹必须从起点到终点沿${d.axis}单向前进：该轴与主轴同步。`,
  runInBlocked: (d, w) => `在导入段起点${w.place(d.x, d.z)}，刀具会位于材料中。${nearest(d.nearest, w.size)}`,
  threadTooMany: (d, w) => `所有走刀共${w.number(d.turns)}转主轴，超过${w.number(d.most)}。`,
  taperImpossible: (d, w) => `角度${w.angle(d.angle)}无法从螺纹起点到达终点。`,
  threadFeedOverLimit: (d, w) =>
    `转速${w.number(d.speed)} × 螺距的进给为${w.number(d.feed)} mm/min，超过轴的能力${w.number(d.most)}。转速不超过${
      w.number(d.upTo)
    } 转/分时可以跟随。`,
  runInShort: (d, w) =>
    `转速${w.number(d.speed)} 转/分时，导入段${w.size(d.runIn)}太短，达不到进给速率：转速 × 螺距 / 400 为${
      w.size(d.needed)
    } mm。我们的经验法则。${nearest(d.nearest, w.size)}`,
} satisfies Partial<MessagesTexts["of"]>;
