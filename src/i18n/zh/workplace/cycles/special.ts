import type { CycleTexts } from "../../../cycle-text.ts";
import { turnMode } from "./notes.ts";

export const special = {
  800: {
    name: "调整坐标系",
    summary: "使车削坐标系适应倾斜或旋转的刀具。",
    description: [
      "说明刀具相对工件的姿态：绕自身轴旋转、翻转、倾斜。定义后立即生效，无需调用。",
      "在车削之前以及每次换刀之后使用。",
    ],
    rough: [],
    finish: [],
    notes: [
      turnMode,
      "所有角度为0、刀具未翻转且Q535为0或3时，循环不改变任何内容。其他值时保留该程序段但不仿真，从此处起程序未验证。",
      "较新软件增加退刀参数Q599；该参数予以保留。",
    ],
  },
  801: {
    name: "复位坐标系",
    summary: "取消循环800所作的调整。",
    description: ["复位车削坐标系。没有参数，定义后立即生效，无需调用。"],
    rough: [],
    finish: [],
    notes: [turnMode, "循环800之后未验证的程序仍未验证：此处不知道机床的位置。"],
  },
} satisfies CycleTexts;
