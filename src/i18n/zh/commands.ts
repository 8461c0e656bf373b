import type { CommandsTexts } from "../en/commands.ts";

export const commands: CommandsTexts = {
  title: "命令",
  search: "搜索命令、循环、页面",
  none: "未找到。",
  count: (n: number) => `${n} 个命令`,
  start: "起始页",
  course: "课程",
  guide: "帮助",
  glossary: "术语表",
  groups: {
    recent: "最近使用",
    action: "操作",
    page: "页面",
    program: "程序",
    cycle: "循环",
    lesson: "课",
    example: "示例",
    setting: "设置",
  },
  kinds: {
    action: "操作",
    page: "页面",
    program: "程序",
    cycle: "循环",
    lesson: "课",
    example: "示例",
    setting: "设置",
  },
};
