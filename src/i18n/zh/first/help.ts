import type { HelpMenuTexts } from "../../en/first/help.ts";

export const helpMenu = {
  open: "帮助",
  long: "帮助、切削参数、术语表",
  menu: "菜单",
  cycle: (cycle) => `循环 ${cycle} 逐步播放`,
  guide: "所有循环和程序段的帮助",
  course: "课程",
} satisfies HelpMenuTexts;
