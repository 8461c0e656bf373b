import type { CycleTexts } from "../../../cycle-text.ts";
import { safePosition, turnMode } from "./notes.ts";

const steps = [
  "快移至安全高度和本刀深度",
  "车螺纹，进给与主轴同步",
  "快移退刀至安全高度",
  "快移返回，按Q467进刀",
  "重复直至达到深度",
  "在最终深度空刀",
  "下一头同样加工",
  "快移退至循环起点",
];
const thread = [
  "每刀从导入段走到螺纹终点，与主轴同步；各刀之间快移返回。切屑截面恒定时，深度按刀次的平方根增加。",
  "公称直径在外螺纹为牙顶，在内螺纹为牙底。从起点Z切到终点Z；旋向由此方向和主轴转向决定。",
];
const notes = [turnMode, safePosition, "车螺纹时进给倍率不起作用。", "刀具TYPE为THREAD，刀尖垂直指向材料。"];

export const threads = {
  830: {
    name: "平行轮廓螺纹",
    summary: "沿自由轮廓车削螺纹。",
    description: [...thread, "轮廓为公称直径线，必须沿同步轴单向前进。圆弧按弦切削。轮廓由循环14指定。"],
    rough: steps,
    finish: [],
    notes,
  },
  831: {
    name: "纵向螺纹",
    summary: "在圆柱上车削外螺纹或内螺纹。",
    description: [...thread, "导入段为安全高度Q460，越程为主轴一转。"],
    rough: steps,
    finish: [],
    notes,
  },
  832: {
    name: "扩展螺纹",
    summary: "在圆柱、圆锥或端面上车削螺纹，有单独的导入段和越程。",
    description: [...thread, "锥度可由两点或由一点和角度给出（Q464）。"],
    rough: steps,
    finish: [],
    notes,
  },
} satisfies CycleTexts;
