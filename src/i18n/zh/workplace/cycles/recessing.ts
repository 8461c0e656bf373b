import type { CycleTexts } from "../../../cycle-text.ts";
import { safePosition, turnMode } from "./notes.ts";

const rough = [
  "以实心进给切入实心材料，直至留有余量的深度",
  "在底部停顿，然后退出",
  "在工件前方横向移动一个重叠步距",
  "以粗加工进给在前一次切入旁切入",
  "重复直至达到宽度，再沿倾斜或圆弧的侧壁切削",
  "快移退至循环起点",
];
const finish = [
  "快移至第一侧",
  "精加工第一侧壁",
  "精加工一半槽底，抬刀",
  "快移退出",
  "快移至第二侧",
  "精加工第二侧壁",
  "精加工另一半槽底，抬刀",
  "快移退至循环起点",
];
const order = "粗加工从槽底到一侧壁，再到另一侧壁；也可精加工或完整加工。梳状切槽先切整刀，再切中间的筋。";
const notes = [
  turnMode,
  safePosition,
  "若刃口平直部分（刃宽减两倍半径）不小于刃宽的一半，两次切入的间距不超过该平直部分，中间不留残余材料。",
  "槽深大于CUTLENGTH时，只切到刃长的深度，并显示提示。",
  "参数列表和步骤未与手册核对；请在数控系统上核实。",
];
const sections = "轮廓有多个凹谷时逐段加工：一段的槽底和侧壁切完后，再切下一段。";

export const recessing = {
  860: {
    name: "径向轮廓切槽",
    summary: "在圆柱面或孔内按轮廓切槽，槽数不限。",
    description: [
      "以朝向轴线（孔内则背离轴线）的并排切入去除子程序轮廓与起点之间的材料。之前须用循环14指定轮廓。",
      order,
      sections,
    ],
    rough,
    finish,
    notes,
  },
  861: {
    name: "径向切槽（简单）",
    summary: "在圆柱面或孔内切直壁槽，从起点到一个角点。",
    description: ["以并排切入在圆柱面或孔内加工槽，位于循环起点与角点Q493、Q494之间。起点就是槽的第一个角点。", order],
    rough,
    finish,
    notes,
  },
  862: {
    name: "径向切槽（扩展）",
    summary: "在圆柱面或孔内切槽，可带斜侧壁、倒角和槽底圆角。",
    description: ["以并排切入在圆柱面或孔内加工槽。棱边可加倒角或圆角，两侧壁可倾斜，槽底角可倒圆。", order],
    rough,
    finish,
    notes,
  },
  870: {
    name: "轴向轮廓切槽",
    summary: "在端面按轮廓切槽，槽数不限。",
    description: ["以沿轴线方向的并排切入去除子程序轮廓与起点之间的材料。之前须用循环14指定轮廓。", order, sections],
    rough,
    finish,
    notes,
  },
  871: {
    name: "轴向切槽（简单）",
    summary: "在端面切直壁槽，从起点到一个角点。",
    description: ["以并排切入在端面加工槽，位于循环起点与角点Q493、Q494之间。起点就是槽的第一个角点。", order],
    rough,
    finish,
    notes,
  },
  872: {
    name: "轴向切槽（扩展）",
    summary: "在端面切槽，可带斜侧壁、倒角和槽底圆角。",
    description: ["以并排切入在端面加工槽。棱边可加倒角或圆角，两侧壁可倾斜，槽底角可倒圆。", order],
    rough,
    finish,
    notes,
  },
} satisfies CycleTexts;
