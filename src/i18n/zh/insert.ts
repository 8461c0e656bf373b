import type { InsertTexts } from "../en/insert.ts";

export const insert: InsertTexts = {
  site: "位置",
  sites: { outside: "外圆", inside: "内孔", face: "端面" },
  surface: "表面",
  cylinder: (across, from, to) => `⌀${across}，Z${from} 至 Z${to}`,
  face: (z, from, to) => `Z${z}，⌀${from} 至 ⌀${to}`,
  picture: (surfaces) => `该工序前的毛坯，表面数：${surfaces}`,
  none: {
    outside: "毛坯此处没有外圆面。",
    inside: "毛坯还没有孔。请先钻孔，或在毛坯中给出内径。",
    face: "毛坯此处没有前端面。",
  },
  noStock: "毛坯未知：请用 BLK FORM 定义毛坯，以便给出建议尺寸。",
  fromSurface: (sizes) => `由表面得出：${sizes}`,
  fromStock: (sizes) => `建议：${sizes}`,
  open: (prompts) => `待输入：${prompts}`,
  contour: "轮廓",
  label: (label) => `LBL ${label}`,
  draw: "绘制新轮廓",
  undrawn: "请先绘制轮廓。",
  unsuitable: (tools) => `不适用的刀具（${tools}）`,
  noTool: "刀具表中没有刀具能到达此处。",
  hand: {
    title: "不用车削循环",
    of: {
      chamfer: "手动倒角 (L)",
      partOff: "切断",
      partOffChamfered: "带后倒角切断",
      drill: "轴线钻孔",
      tap: "轴线攻丝",
    },
    sizes: { size: "倒角", z: "后端面 Z" },
    noTool: "刀具表中没有适用的刀具。",
    tools: "打开刀具表",
  },
};
