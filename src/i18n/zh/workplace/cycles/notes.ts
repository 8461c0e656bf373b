export const turnMode = "只能在车削模式（FUNCTION MODE TURN）下执行。在TNC7上，该功能须由机床制造商启用。";
export const safePosition = "调用前，用R0将刀具移至安全位置：该点为循环起点，决定被加工的部位。";
export const edgeLength = "刀具表中的CUTLENGTH限制粗加工的进刀量；进刀量过大时自动减小并显示警告。";
/** Notes of every cycle that takes its contour from a subprogram. */
export const freeContour = [
  "碰撞危险：切削限位限制被加工的轮廓，但接近和离开路径可跨越限位。调用前，将刀具定位在需要切除材料的一侧。",
  turnMode,
  safePosition,
  "考虑刀具切削刃几何参数，避免损坏轮廓元素。刀具无法到达之处有残余材料，并显示警告。",
  "调用前必须编程循环14及轮廓的标签号，或编程SEL CONTOUR及其文件。",
  "轮廓中使用的局部参数（QL）必须在轮廓子程序中赋值。",
  edgeLength,
];
/** Note of the cycles that plunge without a plunging feed. */
export const plunging =
  "刀具以粗加工进给切入：这些循环没有单独的切入进给。侧面过陡、切削刃无法跟随时有残余材料，并显示警告。";
/** Note of cycle 812: a printed list, with one fact that the page leaves open. */
export const inclination = "手册未印出，因此未验证：Q495和Q496使各面倾斜的方向。";
