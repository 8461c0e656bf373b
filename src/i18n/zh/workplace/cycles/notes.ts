export const turnMode = "只能在车削模式（FUNCTION MODE TURN）下执行。在TNC7上，该功能须由机床制造商启用。";
export const safePosition = "调用前，用R0将刀具移至安全位置：该点为循环起点，决定被加工的部位。";
export const edgeLength = "刀具表中的CUTLENGTH值限制粗加工的进刀量；这时减小进刀量并显示警告。";
/** What holds for every cycle that takes its contour from a subprogram. */
export const freeContour = [
  "碰撞危险：切削限位限制被加工的轮廓，但接近和离开路径可跨越限位。调用前，将刀具定位在需要切除材料的一侧。",
  turnMode,
  safePosition,
  "考虑刀片形状，避免损坏轮廓元素。刀具无法到达之处保留材料并显示警告。",
  "调用前必须编程循环14及轮廓的标签号，或编程SEL CONTOUR及其文件。",
  "轮廓中使用的局部参数（QL）必须在轮廓子程序中赋值。",
  edgeLength,
];
/** What holds where a tool plunges and no feed is asked for it. */
export const plunging =
  "切入以粗加工进给进行：这些循环不单独询问切入进给。侧面陡于切削刃能跟随的角度时，保留材料并显示警告。";
