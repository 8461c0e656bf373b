import type { ChooserTexts } from "../../en/first/chooser.ts";

export const chooser = {
  cycles: "循环",
  search: "搜索循环",
  hint: "按编号、名称或车间用语搜索",
  languages: "可用四种语言搜索。",
  found: (n) => `找到 ${n} 个循环。`,
  enter: (cycle) => `按回车选择${cycle}。`,
  none: "没有匹配的循环。",
  acts: (cycle) => `${cycle}：只在程序中起作用。请打开程序，在“循环”下插入该循环。`,
  kept: (cycle) => `${cycle}：在程序中显示但不仿真；其后的程序未检查。请把该循环的各行粘贴到程序文本中。`,
  recent: "最近使用",
  recentOne: (cycle) => `最近使用：${cycle}`,
  count: (n) => `${n} 个循环`,
  evidence: (cycles) => `${cycles} 的参数表已与手册核对。其他循环的参数表请在机床的数控系统上核对。`,
  evidenceLink: "帮助中的参数表",
  empty: "无数值",
  insert: "插入",
  back: "全部程序段",
} satisfies ChooserTexts;
