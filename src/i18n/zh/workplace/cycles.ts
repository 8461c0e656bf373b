import type { CyclesTexts } from "../../cycle-text.ts";
import { longitudinal } from "./cycles/longitudinal.ts";
import { transverse } from "./cycles/transverse.ts";
import { recessTurning } from "./cycles/recess-turning.ts";
import { recessing } from "./cycles/recessing.ts";
import { threads } from "./cycles/threads.ts";
import { special } from "./cycles/special.ts";

export const cycles = {
  groups: {
    special: "特殊循环",
    longitudinal: "纵向车削",
    transverse: "横向车削",
    recessTurning: "凹槽车削",
    recessing: "切槽",
    thread: "螺纹",
  },
  evidence: {
    A: "印于该数控系统的手册",
    B: "印于同系列数控系统的手册",
    L: "取自这些循环所源自的车床数控系统",
    I: "由手册内容推断",
    K1: "未与手册核对，可信度较高",
    K2: "未与手册核对",
    K3: "未与手册核对，不确定",
  },
  kinds: {
    choice: "选择",
    diameter: "直径",
    oversizeDiameter: "直径余量",
    radial: "半径值",
    axial: "沿Z轴",
    axialDepth: "沿Z轴的深度",
    length: "长度",
    angle: "角度",
    feed: "进给速率",
    count: "次数",
    factor: "系数",
    percent: "百分比",
    revolutions: "转数",
  },
  roughStep: (step, of, text) => `第${step}步（共${of}步）：${text}`,
  finishStep: (step, of, text) => `精加工第${step}步（共${of}步）：${text}`,
  positioning: "第1步之前的定位",
  kept: { 880: "滚齿", 882: "联动粗车", 883: "联动精车", 892: "检查不平衡量" },
  of: { ...special, ...longitudinal, ...transverse, ...recessTurning, ...recessing, ...threads },
} satisfies CyclesTexts;
