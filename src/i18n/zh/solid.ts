import type { SolidTexts } from "../en/solid.ts";

export const solid: SolidTexts = {
  title: "三维视图",
  picture: (cut, state) => `回转体三维图${cut ? "，切去四分之一" : ""}，Z 向右。${state}`,
  keys: "方向键转动视图，按住 Shift 平移；加减键缩放，0 显示全部；1、2、3 为斜视、正视和端视。",
  views: "视角",
  quarter: "切去四分之一",
  quarterShort: "四分之一",
  iso: "斜视",
  front: "正视",
  end: "端视",
  threads: "此处螺纹画成环槽，不含导程。",
  left: "左旋螺纹：M4，或进给背离卡盘。",
  milled: "铣削部分不在此实体中：见工作平面。",
  noBlank: "未定义毛坯：仅显示路径。",
  surfaces: "表面",
  textures: { raw: "毛坯面", rough: "粗加工", thread: "螺纹", finished: "精加工" },
  marked: { residual: "残留材料", gouge: "过切、碰撞" },
  missing: "此浏览器没有 WebGL，无法显示三维图，改为显示剖面。",
  lost: "显卡暂时不可用。三维图恢复之前显示剖面。",
  again: "重试三维图",
};
