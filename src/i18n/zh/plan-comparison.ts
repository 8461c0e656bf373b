import type { PlanComparisonTexts } from "../en/plan-comparison.ts";

export const planComparison: PlanComparisonTexts = {
  title: "一个零件，两个方案",
  about:
    "自动方案用同样的图纸和同样的刀具生成。两个方案都不是唯一正确的做法：每处差别都在您的程序里试过，并重新检查了整个零件。",
  planning: (tries) => `正在生成自动方案：已试 ${tries} 道工序`,
  trying: (n) => `正在您的程序里试做：第 ${n} 处差别`,
  failed: "无法计算对比。",
  noPlan: "这张图纸无法生成加工方案。",
  noProgram: "您的程序里还没有工序。",
  again: "重试",
  yours: "您的方案",
  planner: "自动方案",
  whole: "整个零件",
  facts: { time: "时间", changes: "换刀次数", tools: "刀具", left: "残余材料", goals: "目标" },
  met: "全部达到",
  missed: (goals) => `未达到：${goals}`,
  withChanges: (time) => `时间中每次换刀计 ${time}。`,
  summary: (differences, planner, own) =>
    differences === 0
      ? "两个方案的做法相同。"
      : `试过 ${differences} 处差别：自动方案的做法好 ${planner} 处，您的好 ${own} 处。`,
  rows: "逐道工序",
  onlyYours: "仅您的方案有",
  onlyPlanner: "仅自动方案有",
  nothing: "没有这道工序",
  number: (n) => `第 ${n} 道`,
  thread: "螺纹",
  differs: {
    same: "刀具相同，循环相同",
    tool: "刀具不同",
    cycle: "循环不同",
    count: (own, planner) => `工序数 ${own} : ${planner}`,
    earlier: "自动方案较早",
    later: "自动方案较晚",
    faster: (time) => `您快 ${time}`,
    slower: (time) => `自动方案快 ${time}`,
    sameTime: "时间相同",
  },
  why: "自动方案为何这样做",
  values: { title: "不同的数值", value: "数值", reason: "自动方案的公式" },
  tried: {
    way: "您的程序改用自动方案的做法",
    order: "您的程序改用自动方案的顺序",
    none: "无法写入您的程序。",
    time: (time, difference) => `${time}（${difference}）`,
    left: (area) => `残余材料 ${area}`,
    clean: "没有残余材料",
    changes: (n) => `换刀 ${n} 次`,
    better: { own: "您的做法更好", other: "自动方案的做法更好", same: "结果没有差别" },
  },
};
