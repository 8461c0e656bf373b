import type { CycleTexts } from "../../cycle-text.ts";
import { edgeLength, freeContour, safePosition, turnMode } from "./notes.ts";

const rough = ["快移平行轴进刀", "以粗加工进给横向切削", "退刀一个进刀量", "快移退至切削起点", "重复,直至轮廓完成", "快移退至循环起点"];
const finish = ["快移进刀", "从起点到终点精加工轮廓", "退刀至安全高度", "快移退至循环起点"];
/** Of the cycles that have a contour of their own. */
const own = { rough, finish, notes: [turnMode, safePosition, edgeLength] };

export const transverse = {
  820: {
    name: "轮廓横向车削",
    summary: "沿横向车削子程序中的自由轮廓。",
    description: [
      "沿横向车削任意轮廓。轮廓是由直线、圆角、倒角和圆弧组成的子程序,由循环14选择。",
      "平行轴粗加工、精加工或两者。轮廓起点的X大于终点:外尺寸加工;小于:内尺寸加工。",
      "如果起点的Z坐标小于轮廓起点,刀具先沿Z轴移至轮廓起点;精加工时移至安全高度。",
    ],
    rough,
    finish,
    notes: freeContour,
  },
  821: {
    name: "台肩端面车削",
    summary: "从刀具所在位置开始,沿横向车削直角台肩。",
    description: [
      "车削端面及其末端的圆柱面。调用时的刀具位置是加工区的一角,编程的终点是另一角;没有角度,也没有倒角。",
      "横向平行轴粗加工、精加工或两者。起点比Q493离轴线更远:外尺寸加工;更近:内尺寸加工。",
    ],
    ...own,
  },
  822: {
    name: "台肩端面车削(扩展)",
    summary: "沿横向车削台肩,可带倒角、角度和内角圆角。",
    description: [
      "沿横向车削台肩。轮廓起点和终点的棱边可加倒角或圆角,端面和圆周面可倾斜,内角可倒圆。",
      "横向平行轴粗加工、精加工或两者。起点直径大于终点直径:外尺寸加工;小于:内尺寸加工。",
      "如果起点在加工区内,刀具先沿Z轴、再沿X轴移至安全高度。",
    ],
    ...own,
  },
} satisfies CycleTexts;
