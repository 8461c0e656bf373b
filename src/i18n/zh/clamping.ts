import type { ClampingTexts } from "../en/clamping.ts";

export const clamping: ClampingTexts = {
  title: "装夹",
  unstated: "未指定：视毛坯在后端被夹持。不检查与卡爪、卡盘或尾座的碰撞。",
  state: "指定装夹",
  remove: "移除装夹",
  kind: "夹持方式",
  kinds: {
    chuckOutside: "卡盘，外夹",
    chuckInside: "卡盘，内撑",
    softJaws: "软爪",
    collet: "弹簧夹头",
    centres: "两顶尖",
  },
  grips: {
    chuckOutside: "外夹直径",
    chuckInside: "内撑直径",
    softJaws: "外夹直径",
    collet: "夹持直径",
    centres: "拨盘直径",
  },
  nose: "夹头鼻端直径",
  words: {
    D: "夹持直径",
    LENGTH: "夹持长度",
    FACE: "前端面Z",
    SIZE: "卡盘直径",
    QUILL: "套筒直径",
    TIP: "顶尖Z",
    ANGLE: "顶尖角度",
    LIMITZ: "极限：不超过Z左侧",
    LIMITX: "极限：不进入该直径内",
  },
  tailstock: "使用尾座",
  known: "按比例绘制；刀具或刀杆与其碰撞为错误。卡爪按常用动力卡盘：请测量实物。",
  inProgram: "以注释 ;\u00A0CLAMPING … 保存在程序中，数控系统会忽略。",
  units: { mm: { diameter: "mm ⌀", length: "mm" }, inch: { diameter: "英寸 ⌀", length: "英寸" } },
};
