import type { SecondSideTexts } from "../en/second-side.ts";

export const secondSide: SecondSideTexts = {
  title: "调头装夹",
  lead: "本程序加工后剩下的材料成为新程序的毛坯：左右镜像，零点在新端面上。本程序保持不变。",
  piece: "工件",
  held: (size) => `卡盘中的，${size}`,
  off: (size) => `切下的，${size}`,
  allowance: (unit) => `新端面余量，${unit}`,
  allowanceHint: "Z0 在新端面后面这么远处。0：端面不再加工。",
  allowanceWrong: (most) => `0 到 ${most} 的长度`,
  blank: "毛坯",
  name: "新程序",
  open: "打开新程序",
  lack: {
    beginning: "程序仍在计算中。",
    older: "最新的值不产生路径：无法知道剩下什么。",
    faults: "程序有错误：剩下的不是要加工的工件。请看检查结果。",
    noBlank: "程序没有给出毛坯。",
    nothingLeft: "材料没有剩余。",
  },
  unproved: "程序有一部分没有仿真，新毛坯不含这部分的加工。",
  milling: "铣削的部分不在新毛坯中：新毛坯是车削后的工件。",
};
