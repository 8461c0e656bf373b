import type { CycleTexts } from "../../../cycle-text.ts";
import { edgeLength, freeContour, plunging, safePosition, turnMode } from "./notes.ts";

const rough = [
  "快移平行轴进刀",
  "以粗加工进给横向切削",
  "退刀一个进刀量",
  "快移退至切削起点",
  "重复，直至轮廓完成",
  "快移退至循环起点",
];
const finish = ["快移进刀", "从起点到终点精加工轮廓", "退刀至安全高度", "快移退至循环起点"];
/** Steps and notes of the cycles that describe the contour by parameters. */
const own = { rough, finish, notes: [turnMode, safePosition, edgeLength] };

export const transverse = {
  820: {
    name: "轮廓横向车削",
    summary: "沿横向车削子程序中的自由轮廓。",
    description: [
      "沿横向车削任意轮廓。轮廓是由直线、圆角、倒角和圆弧组成的子程序，由循环14或SEL CONTOUR选择。",
      "平行轴粗加工、精加工或完整加工。轮廓起点的X大于终点：外尺寸加工；小于：内尺寸加工。",
      "如果起点的Z坐标小于轮廓起点，刀具先沿Z轴移至轮廓起点；精加工时移至安全高度。",
    ],
    rough,
    finish,
    notes: freeContour,
  },
  821: {
    name: "台阶端面车削",
    summary: "从刀具所在位置开始，沿横向车削直角台阶。",
    description: [
      "车削端面及其末端的圆柱面。调用时的刀具位置是加工区的一角，编程的终点是另一角；无角度、倒角和圆角。",
      "横向平行轴粗加工、精加工或完整加工。起点比Q493离轴线更远：外尺寸加工；更近：内尺寸加工。",
    ],
    ...own,
  },
  822: {
    name: "台阶端面车削（扩展）",
    summary: "沿横向车削台阶，可带倒角、角度和内角圆角。",
    description: [
      "沿横向车削台阶。轮廓起点和终点的棱边可加倒角或圆角，端面和圆周面可倾斜，内角可倒圆。",
      "横向平行轴粗加工、精加工或完整加工。起点直径大于终点直径：外尺寸加工；小于：内尺寸加工。",
      "如果起点在加工区内，刀具先沿Z轴、再沿X轴移至安全高度。",
    ],
    ...own,
  },
  823: {
    name: "切入端面车削",
    summary: "沿横向在侧面之后切入端面。",
    description: [
      "在端面上车削刀具必须切入才能到达的区域：沿轮廓起点处的侧面向下，沿底面，直到终点处的直角壁。",
      "轮廓起点旁边的材料不加工，保持在Q492的平面。",
      "横向平行轴粗加工、精加工或完整加工。起点直径大于终点直径：外尺寸加工；小于：内尺寸加工。",
      "如果起点在加工区内，刀具先沿Z轴、再沿X轴移至轮廓起点旁边的安全高度。",
    ],
    rough,
    finish,
    notes: [...own.notes, plunging],
  },
  824: {
    name: "切入端面车削（扩展）",
    summary: "沿横向在侧面之后切入端面，可带倒角、圆角和倾斜壁。",
    description: [
      "在端面上车削刀具必须切入才能到达的区域：沿轮廓起点处的侧面向下，沿底面，再沿终点处的壁向上。两端的棱边可加倒角或圆角，底面两侧的内角可倒圆，壁可倾斜。",
      "轮廓起点旁边的材料不加工，保持在Q492的平面。",
      "横向平行轴粗加工、精加工或完整加工。起点直径大于终点直径：外尺寸加工；小于：内尺寸加工。",
      "如果起点在加工区内，刀具先沿Z轴、再沿X轴移至轮廓起点旁边的安全高度。",
    ],
    rough,
    finish,
    notes: [...own.notes, plunging],
  },
} satisfies CycleTexts;
