import type { FindTexts } from "../en/find.ts";

export const find: FindTexts = {
  ctrl: "Ctrl",
  shift: "Shift",
  find: "查找",
  with: "替换为",
  replace: "替换",
  replaceOne: "替换",
  replaceAll: "全部替换",
  previous: "上一处",
  next: "下一处",
  close: "关闭",
  position: (n: number, of: number) => `${n} / ${of}`,
  count: (n: number) => (n === 0 ? "未找到" : `${n} 处`),
  replaced: (n: number) => `已替换 ${n} 处`,
  goTo: "转到",
  goToLong: "程序段、LBL、刀具、循环或 Q",
  block: (n: string) => `程序段 ${n}`,
  renumber: "重新编号程序段",
  fold: "折叠或展开所有循环",
  tools: "查找与整理",
};
