import type { SomeParamTexts } from "../../../param-text.ts";

export const special = {
  blankAllowance: {
    prompt: "毛坯余量?",
    printed: false,
    label: "毛坯余量",
    explanation: "循环之前轮廓上的余量，垂直于轮廓测量，端面也一样。",
  },
  cuttingLines: {
    prompt: "切削线类型(0/1)?",
    printed: false,
    label: "切削线",
    explanation: "余量如何分成各次走刀。",
    choices: { 0: "恒定切屑截面：较长的走刀较薄，每次切除相同面积", 1: "等距：各次走刀厚度相同" },
  },
  infeedParallel: {
    prompt: "最大切削深度?",
    printed: false,
    label: "最大进刀量",
    explanation: "每次走刀的最大进刀量，垂直于轮廓测量。0：一次走刀。",
  },
  precessionAngle: {
    prompt: "进动角?",
    printed: false,
    label: "进动角",
    explanation: "使坐标系绕主轴轴线Z旋转。两个主轴平行时可输入任意角度，否则只有两个角度有意义。",
  },
  reverseTool: {
    prompt: "翻转刀具(0=否/1=是)?",
    printed: false,
    label: "翻转刀具",
    explanation: "将刀具绕自身轴旋转180°，切削刃成镜像。",
    choices: { 0: "不翻转", 1: "旋转180°" },
  },
  inclinedMachining: {
    prompt: "倾斜加工(0/1/2/3)?",
    printed: false,
    label: "倾斜加工",
    explanation: "倾斜轴如何到达倾斜角。",
    choices: {
      0: "轴已定位：坐标系随之调整；数控系统要求M144或M128/TCPM",
      1: "定位轴，刀尖作补偿运动",
      2: "定位轴，不作补偿运动",
      3: "只计算轴角度（Q120、Q121、Q122），不运动；随后自行定位轴",
    },
  },
  incidenceAngle: {
    prompt: "倾斜角?",
    printed: false,
    label: "倾斜角",
    explanation: "刀具相对工件倾斜的角度。",
  },
  tiltingFeed: {
    prompt: "定位进给速率?",
    printed: false,
    label: "定位进给",
    explanation: "倾斜轴移动的进给速率，mm/min。",
  },
  preferredDirection: {
    prompt: "倾斜角优先方向?",
    printed: false,
    label: "优先方向",
    explanation: "在倾斜轴的多个位置中选取哪一个。",
    choices: {
      0: "最近的位置",
      1: "0°至+180°之间",
      2: "+90°至+180°之间",
      [-2]: "−90°至−180°之间",
      [-1]: "0°至−180°之间",
    },
  },
  eccentricTurning: {
    prompt: "偏心车削(0-3)?",
    printed: false,
    label: "偏心车削",
    explanation: "为偏离工作台中心的车削耦合各轴。0和3以外的值保留，但未验证。",
    choices: { 0: "关闭耦合", 1: "打开耦合，绕预设点旋转", 2: "打开耦合，绕原点旋转", 3: "耦合保持不变" },
  },
  eccentricWithoutStop: {
    prompt: "偏心车削无停止(0/1)?",
    printed: false,
    label: "偏心无停止",
    explanation: "偏心车削开始前程序是否停止。",
    choices: { 0: "先停止", 1: "不停止" },
  },
} satisfies SomeParamTexts;
