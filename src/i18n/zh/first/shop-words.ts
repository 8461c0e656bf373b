import type { ShopWords } from "../../shop-words.ts";

export const shopWords: ShopWords = {
  groups: {
    special: ["设置", "坐标系", "复位"],
    longitudinal: ["纵向", "外圆", "内孔", "镗孔", "车外圆"],
    transverse: ["端面", "车端面", "平端面", "横向"],
    recessTurning: ["槽", "切槽", "车槽", "凹槽"],
    recessing: ["槽", "切槽", "切断", "凹槽"],
    thread: ["螺纹", "车螺纹", "螺距"],
  },
  free: ["轮廓", "仿形", "退刀槽"],
  same: [
    ["台阶", "台肩", "轴肩", "凸肩"],
    ["槽", "凹槽", "切槽"],
    ["端面", "平面"],
  ],
};
