import type { SomeParamTexts } from "../../../param-text.ts";

export const recessing = {
  plungeLimit: {
    prompt: "切槽深度限制?",
    printed: false,
    label: "深度限制",
    explanation: "一次切入的最大深度。更深的切入被均匀分段，段间刀具退回0.5毫米以断屑。0：一次切到底。",
  },
  recessingOverlap: {
    prompt: "切槽重叠?",
    printed: false,
    label: "重叠",
    explanation:
      "相邻两次切入的横向步距，为CUTWIDTH的倍数。步距均匀分配，最后一次切入位于另一侧壁。梳状切槽时为筋的宽度。",
  },
  solidFeed: {
    prompt: "实心切入的进给系数?",
    printed: false,
    label: "实心进给",
    explanation: "切入实心材料的进给，为粗加工进给Q478的百分比。与已切处重叠的切入用全进给。",
  },
  retraction: {
    prompt: "退刀方式(0/1)?",
    printed: false,
    label: "退刀",
    explanation: "刀具如何离开切口。",
    choices: { 0: "沿轮廓直接退出", 1: "先斜向离开侧壁，再退出" },
  },
  dwellTurns: {
    prompt: "停顿转数?",
    printed: false,
    label: "停顿",
    explanation: "退刀前刀具停在切口底部时主轴转过的圈数。",
  },
  combRecessing: {
    prompt: "梳状切槽(0/1)?",
    printed: false,
    label: "梳状",
    explanation: "切入的顺序。",
    choices: { 0: "逐次并排，相互重叠", 1: "先切整刀，再切中间的筋" },
  },
} satisfies SomeParamTexts;
