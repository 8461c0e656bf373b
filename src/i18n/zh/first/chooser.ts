import type { ChooserTexts } from "../../en/first/chooser.ts";

export const chooser = {
  cycles: "循环",
  search: "搜索循环",
  hint: "编号、名称或车间用语",
  languages: "可用四种语言搜索。",
  keys: "用方向键在循环之间移动。",
  found: (n) => `找到 ${n} 个循环。`,
  enter: (cycle) => `按回车选用${cycle}。`,
  none: "没有符合这些词的循环。",
  acts: (cycle) => `${cycle}：不能单独成为一项工作，它在程序中所处的位置起作用。请打开程序，在“循环”下插入。`,
  kept: (cycle) => `${cycle}：在程序中显示并保留，但不运行；其后没有验证。请把它的各行粘贴到程序文本中。`,
  recent: "最近使用",
  recentOne: (cycle) => `最近使用：${cycle}`,
  count: (n) => `${n} 个循环`,
  recalled: "参数表凭记忆",
  empty: "空白",
  insert: "插入",
  back: "全部程序段",
} satisfies ChooserTexts;
