export const turnMode = "只能在车削模式(FUNCTION MODE TURN)下执行。在TNC7上,该功能须由机床制造商启用。";
export const safePosition = "调用前,用R0将刀具移至安全位置:该点为循环起点,决定被加工的部位。";
export const edgeLength = "刀具表中的CUTLENGTH值限制粗加工的进刀量;这时减小进刀量并显示提示信息。";
