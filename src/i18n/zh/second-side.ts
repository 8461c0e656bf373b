import type { SecondSideTexts } from "../en/second-side.ts";

export const secondSide: SecondSideTexts = {
  title: "第二面",
  lead: "本程序的结果成为新程序的毛坯：左右镜像，零点在新端面上。本程序保持不变。",
  piece: "工件",
  held: (size) => `卡盘中的，${size}`,
  off: (size) => `切下的，${size}`,
  allowance: (unit) => `新端面余量，${unit}`,
  allowanceHint: "Z0 在新端面后的距离。0：端面不加工。",
  allowanceWrong: (most) => `0 到 ${most} 的长度`,
  blank: "毛坯",
  name: "新程序",
  open: "打开新程序",
  lack: {
    beginning: "程序仍在计算中。",
    older: "最新的值不产生刀具路径：结果未知。",
    faults: "程序有错误：其结果不是要加工的工件。请看检查信息。",
    noBlank: "程序没有定义毛坯。",
    nothingLeft: "没有剩余材料。",
  },
  unproved: "程序有一部分未仿真，不含在新毛坯中。",
  milling: "不含铣削：新毛坯是车削后的工件。",
};
