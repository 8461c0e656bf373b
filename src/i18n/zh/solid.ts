import type { SolidTexts } from "../en/solid.ts";

export const solid: SolidTexts = {
  title: "三维视图",
  picture: (cut, state) => `车削件三维图${cut ? "，四分之一剖切" : ""}，Z 向右。${state}`,
  keys: "方向键转动视图，按住 Shift 平移；加减键缩放，0 显示全部；1、2、3 为等轴测、正视和端面视图。",
  views: "视角",
  quarter: "四分之一剖切",
  quarterShort: "剖切",
  iso: "等轴测",
  front: "正视",
  end: "端面",
  threads: "螺纹画成环槽，不含导程。",
  left: "左旋螺纹：M4，或进给背离卡盘。",
  milled: "此实体不含铣削：见加工面。",
  noBlank: "未定义毛坯：仅显示路径。",
  surfaces: "表面",
  textures: { raw: "未加工", rough: "粗加工", thread: "螺纹", finished: "精加工" },
  marked: { residual: "残余材料", gouge: "轮廓损伤、碰撞" },
  missing: "此浏览器没有 WebGL，无法显示三维图，改为显示剖面。",
  lost: "与显卡的连接中断。三维图恢复之前显示剖面。",
  again: "重试三维图",
};
