import type { HelpTexts } from "../../en/workplace/help.ts";

export const help = {
  picture: (cycle) => `轮廓图，循环 ${cycle}`,
  highlighted: (parameter, label, value) => `突出显示：${parameter} ${label}，${value}`,
  stale: "轮廓无效；显示上一张有效图形",
  partial: "Q 编号代表尚未输入的值。",
  noValue: "尚无数值",
  inWords: {
    diameter: (value) => `直径 ${value} mm`,
    oversizeDiameter: (value) => `直径方向 ${value} mm`,
    radial: (value) => `半径方向 ${value} mm`,
    axial: (value) => `Z ${value} mm`,
    axialDepth: (value) => `Z 向 ${value} mm`,
    length: (value) => `${value} mm`,
    angle: (value) => `${value} 度`,
    feed: (value) => `进给 ${value}`,
    count: (value) => value,
    factor: (value) => `系数 ${value}`,
    percent: (value) => `百分之 ${value}`,
    revolutions: (value) => `${value} 转`,
    auto: "FAUTO，即刀具调用的进给",
    choice: (value, meaning) => `${value}，${meaning}`,
  },
  element: { none: "无", chamfer: "倒角", radius: "圆角" },
  reserved: "（无功能）",
  notToScale: "未按比例",
} satisfies HelpTexts;
