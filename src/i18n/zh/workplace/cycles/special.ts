import type { CycleTexts } from "../../../cycle-text.ts";
import { turnMode } from "./notes.ts";

export const special = {
  800: {
    name: "调整坐标系",
    summary: "使车削坐标系适应倾斜或旋转的刀具。",
    description: [
      "说明刀具相对工件的姿态：绕自身轴旋转、翻转、倾斜。在程序中所处位置即生效，无需调用。",
      "在车削之前以及每次换刀之后使用。",
    ],
    rough: [],
    finish: [],
    notes: [
      turnMode,
      "所有角度为0、刀具未翻转且Q535为0或3时，不改变任何内容，程序继续运行。其他情况保留该程序段，其后的内容均未验证。",
      "较新软件增加退刀参数Q599；予以保留。",
    ],
  },
  801: {
    name: "复位坐标系",
    summary: "取消循环800所作的调整。",
    description: ["恢复车削坐标系。没有参数，在程序中所处位置即生效，无需调用。"],
    rough: [],
    finish: [],
    notes: [turnMode, "循环800留下的未验证部分仍未验证：机床此时的位置在此无从得知。"],
  },
} satisfies CycleTexts;
