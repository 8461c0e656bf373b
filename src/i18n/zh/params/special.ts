import type { SomeParamTexts } from "../../param-text.ts";

export const special = {
  blankAllowance: {
    prompt: "毛坯余量?",
    printed: false,
    label: "毛坯余量",
    explanation: "循环之前轮廓上的余量,处处垂直于轮廓测量,端面也一样。此为我们的理解,请在数控系统上核实。",
  },
  cuttingLines: {
    prompt: "切削线类型(0/1)?",
    printed: false,
    label: "切削线",
    explanation: "余量如何分成各次走刀。",
    choices: { 0: "恒定切屑截面:较长的走刀较薄,每次切除相同面积", 1: "等距:各次走刀厚度相同" },
  },
  infeedParallel: {
    prompt: "最大切削深度?",
    printed: false,
    label: "最大进刀",
    explanation: "一次走刀最多切除的量,垂直于轮廓测量。0:一次切完。",
  },
} satisfies SomeParamTexts;
