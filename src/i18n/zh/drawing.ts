import type { DrawingTexts } from "../drawing-note.ts";

/** What of a solid is not turned. */
function milled(shape: string, count: string): string {
  if (shape === "flats") return `${count} 个平面`;
  if (shape === "holes") return `${count} 个偏心孔`;
  return shape === "crossHoles" ? `${count} 个横向孔` : `${count} 个其他面`;
}

export const drawing: DrawingTexts = {
  unknownKind: ({ kinds }) => `该文件不是可读取的图形。可读取的格式：${kinds}。`,
  unreadable: ({ kind }) => `该文件不是可读取的 ${kind} 图形。`,
  tooLarge: ({ limit }) => `该文件大于 ${limit} MB。`,
  tooMany: ({ limit }) => `图形中的直线和圆弧超过 ${limit} 个。请只保存零件轮廓后再导入。`,
  nothing: () => "图形中没有直线、圆弧或曲线。",
  truncated: () => "文件不完整，已读取到中断处。",
  hiddenLayer: ({ layer, count }) => `图层 ${layer} 已关闭或冻结：忽略 ${count} 个对象。`,
  invisible: ({ count }) => `不可见，已忽略：${count} 个对象。`,
  paperSpace: ({ count }) => `位于布局（图纸空间），已忽略：${count} 个对象。`,
  paperUsed: () => "模型空间为空，已读取布局。请检查比例。",
  skipped: ({ kind, count }) => `未使用：${count} × ${kind}。`,
  broken: ({ count }) => `因数值不完整而忽略：${count} 个对象。`,
  missingBlock: ({ block }) => `文件中没有块 ${block}；请先绑定外部参照。`,
  recursiveBlock: ({ block }) => `块 ${block} 包含自身，已忽略。`,
  otherPlane: ({ count }) => `不在图形平面内，已忽略：${count} 个对象。`,
  plane: ({ plane }) => (plane === "oblique" ? "图形位于斜平面，按正视读取。" : `图形位于 ${plane} 平面。`),
  doubled: ({ count }) => `重叠并已合并：${count} 条直线或圆弧。`,
  fitted: ({ kind, count, tolerance }) => `已用圆弧和直线代替，误差不超过 ${tolerance} mm：${count} × ${kind}。`,
  unitAssumed: ({ width, height }) => `文件未注明单位：按 mm 读取，尺寸 ${width} × ${height} mm。`,
  unitConverted: ({ unit }) => `图形单位为 ${unit}，已换算为 mm。`,
  unitsDisagree: ({ unit }) => `文件注明了两种单位，采用 ${unit}。请检查尺寸。`,
  noContour: () => "轴线的这一侧没有轮廓。",
  onlyAxis: () => "所有直线都在旋转轴上。",
  axisUnmarked: ({ x }) => `图中未画出旋转轴，轴的位置为建议值。此时最小 ⌀：${x} mm。`,
  gapJoined: ({ width, x, z }) => `X ⌀ ${x}、Z ${z} 处 ${width} mm 的间隙已闭合。`,
  gapOpen: ({ width, x, z }) => `X ⌀ ${x}、Z ${z} 处有 ${width} mm 的间隙未闭合：请增大间隙公差。`,
  axisLines: ({ count }) => `位于旋转轴上，已忽略：${count} 条直线。`,
  otherHalf: ({ count }) => `位于轴线另一侧：${count} 条直线或圆弧。`,
  otherPieces: ({ count }) => `未与轮廓相连：另有 ${count} 段。`,
  insideLines: ({ count }) => `位于轮廓内部，不属于轮廓：${count} 条直线或圆弧。`,
  notOutline: ({ count }) => `虚线或细线，不属于轮廓：${count} 条直线或圆弧。`,
  rearFace: ({ z }) => `Z ${z} 处的后端面已忽略。`,
  noSolid: () => "文件中没有实体。",
  noRevolved: () => "文件中的实体没有回转面。",
  otherBodies: ({ name, count, turned }) =>
    `采用实体${name === "" ? "" : ` ${name}`}；忽略其他 ${count} 个实体，${turned === "0" ? "均非车削件" : `其中 ${turned} 个为车削件，可在“实体”处选择`}。`,
  notTurned: ({ shape, count }) => `非车削部分，已忽略：${milled(shape, count)}。`,
};
