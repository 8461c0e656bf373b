import type { CycleTexts } from "../../cycle-text.ts";
import { edgeLength, safePosition, turnMode } from "./notes.ts";

export const longitudinal = {
  812: {
    name: "台肩纵向车削(扩展)",
    summary: "沿轴向车削台肩,可带倒角、角度和内角圆角。",
    description: [
      "沿纵向车削台肩。轮廓起点和终点的棱边可加倒角或圆角,圆周面和端面可倾斜,内角可倒圆。",
      "平行轴粗加工、精加工或两者。起点直径大于终点直径:外尺寸加工;小于:内尺寸加工。",
      "如果起点在加工区内,刀具先沿X轴、再沿Z轴移至安全高度;精加工时先沿Z轴移至安全高度。",
    ],
    rough: ["快移平行轴进刀", "以粗加工进给纵向切削", "退刀一个进刀量", "快移退至切削起点", "重复,直至轮廓完成", "快移退至循环起点"],
    finish: ["快移平行轴进刀", "从起点到终点精加工轮廓", "退刀至安全高度", "快移退至循环起点"],
    notes: [turnMode, safePosition, edgeLength],
  },
} satisfies CycleTexts;
