import type { SomeParamTexts } from "../../../param-text.ts";

const printed = false;

export const threads = {
  clearanceRunIn: {
    prompt: "安全高度?",
    printed,
    label: "安全高度",
    explanation: "各刀之间退刀时保持的距离。在本循环中也是导入段：每刀从起点前这么远处开始。",
  },
  threadPosition: {
    prompt: "螺纹位置(0=外/1=内)?",
    printed,
    label: "位置",
    explanation: "加工外螺纹还是内螺纹。公称直径在外螺纹为牙顶，在内螺纹为牙底。",
    choices: { 0: "外螺纹", 1: "内螺纹" },
  },
  threadOrientation: {
    prompt: "螺纹方向(0=纵向/1=横向)?",
    printed,
    label: "方向",
    explanation: "哪根轴与主轴同步：螺距沿该轴计量。",
    choices: { 0: "纵向，平行于轴线", 1: "横向，在端面上" },
  },
  threadDiameter: {
    prompt: "螺纹直径?",
    printed,
    label: "螺纹直径",
    explanation: "公称直径：外螺纹的牙顶，内螺纹的牙底。",
  },
  threadStartDiameter: {
    prompt: "螺纹起点直径?",
    printed,
    label: "起点直径",
    explanation: "螺纹起点处的公称直径。Q464 = 2时由终点和角度得出。",
  },
  threadEndDiameter: {
    prompt: "螺纹终点直径?",
    printed,
    label: "终点直径",
    explanation: "螺纹终点处的公称直径。Q464 = 4时由起点和角度得出。",
  },
  threadPitch: {
    prompt: "螺距?",
    printed,
    label: "螺距",
    explanation: "主轴转一圈时刀具的行程。多头螺纹时为导程；相邻牙槽的间距为导程除以头数。",
  },
  threadDepth: {
    prompt: "螺纹深度?",
    printed,
    label: "深度",
    explanation: "半径方向的深度。0：按螺距计算，如ISO米制螺纹（外0.6134、内0.5413 × 螺距）。",
  },
  threadRunOut: {
    prompt: "螺纹退尾长度?",
    printed,
    label: "退尾",
    explanation: "螺纹末端刀具从牙底升到牙顶的行程。0：刀具在越程之后才从全深退刀。",
  },
  threadRunIn: { prompt: "导入行程?", printed, label: "导入段", explanation: "螺纹前使轴加速到进给速率的行程。" },
  threadOverrun: {
    prompt: "越程?",
    printed,
    label: "越程",
    explanation: "螺纹后使轴停下的行程。没有退尾时以全深走过越程：须有退刀槽。",
  },
  taperForm: {
    prompt: "锥度标注方式(0-4)?",
    printed,
    label: "锥度由",
    explanation: "用哪些值描述螺纹线。Q469的角度从切削方向的轴线平行线起算。",
    choices: {
      0: "起点和终点",
      1: "终点、起点直径、角度",
      2: "终点、起点Z、角度",
      3: "起点、终点直径、角度",
      4: "起点、终点Z、角度",
    },
  },
  taperAngle: {
    prompt: "锥角?",
    printed,
    label: "锥角",
    explanation: "螺纹线与轴线的夹角，直径沿切削方向增大时为正。Q464 = 0时无效。",
  },
  firstInfeed: {
    prompt: "最大切削深度?",
    printed,
    label: "首次进刀",
    explanation: "第一刀的深度，半径值。切屑截面恒定时后续进刀逐渐减小，但不小于首次的二十分之一。",
  },
  infeedAngle: {
    prompt: "进刀角度?",
    printed,
    label: "进刀角度",
    explanation: "进刀方向相对螺纹垂线的角度：刀具随深度侧移，主要由前侧牙侧切削。最多为刀尖角的一半。",
  },
  infeedType: {
    prompt: "进刀类型(0/1)?",
    printed,
    label: "进刀类型",
    explanation: "深度如何分配到各刀。",
    choices: { 0: "切屑截面恒定", 1: "深度恒定" },
  },
  startingAngle: {
    prompt: "起始角?",
    printed,
    label: "起始角",
    explanation: "螺纹开始时的主轴角度：使螺纹绕轴线旋转。",
  },
  threadStarts: {
    prompt: "螺纹头数?",
    printed,
    label: "头数",
    explanation: "并列牙槽的数量；每头比前一头晚360°除以头数开始。",
  },
  airCuts: { prompt: "空刀次数?", printed, label: "空刀", explanation: "每头在最终深度、无进刀的走刀次数。" },
} satisfies SomeParamTexts;
