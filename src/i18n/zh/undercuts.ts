import type { UndercutTexts } from "../en/undercuts.ts";

export const undercuts: UndercutTexts = {
  label: "退刀槽",
  of: (element) => `元素 ${element}，按代号输入退刀槽`,
  sizes: "规格",
  example: "例如 F0.8×0.3 或 DIN 76-A",
  none: "未知代号。可用：DIN 509 和 ISO 18388 的 E、F、H（r×t1）；DIN 76 的 A 至 D（带螺距）。",
  noPlace: "圆柱面与端面在此相交后即可得到直径。",
  taken: (name) => `${name}：已填入各字`,
  load: { usual: "一般载荷", fatigue: "较高疲劳强度" },
  source: "取自 DIN 509:2006-12 和 DIN 76-1:2004-06 的公开表格，公称尺寸。本数控系统手册未印出。",
  notes: {
    nearest: (asked, taken) => `标准中没有 ${asked}。最接近的规格：${taken}。`,
    diameter: (from, to) => (to === null ? `标准规定用于 ⌀${from} 以上。` : `标准规定用于 ⌀${from} 以上至 ⌀${to}。`),
    side: (asked, taken) => `${asked} 型用于另一侧，改用 ${taken} 型。`,
    pitch: (pitch) => `DIN 76 中没有螺距 ${pitch}。`,
    formG: "UDC 没有 G 型：请用直线和圆弧绘制。",
    faceOfF: "循环会留下端面中的凹槽（t2）。作为工序插入“按标准的退刀槽”，用轨迹程序段切出。",
    faceOfH: (t2) => `TYPE_H 不在端面中切出 t2 = ${t2}。`,
    allowance: (z) => `磨削前的尺寸，z = ${z}：轮廓也要带此余量编程。`,
  },
};
